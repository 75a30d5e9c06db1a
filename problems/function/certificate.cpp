#include "problems/function/certificate.hpp"

#include <cmath>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/function/length_ranges.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

using synthesis::FunctionBound;
using synthesis::LimitOfOutput;
using synthesis::ProportionBox;

std::optional<LimitOfOutput> limit_of(FunctionStart start) {
  if (start == FunctionStart::free) return std::nullopt;
  return start == FunctionStart::outer_dead_centre ? LimitOfOutput::outer : LimitOfOutput::inner;
}

Range phase_range(const FunctionProblem& problem) {
  if (problem.start != FunctionStart::free) return {0, 0};
  if (problem.input_start) return {*problem.input_start, *problem.input_start};
  const double turn = kTurn;
  const Range whole{0, synthesis::Interval::above(turn)};
  const Range range = problem.input_start_bounds.value_or(whole);
  return range.max - range.min < turn ? range : whole;
}

bool bounds_all_links(const FunctionProblem& problem) {
  const Given& given = problem.given;
  const Bounds& bounds = problem.bounds;
  const auto bounded = [](const std::optional<double>& value, const std::optional<Range>& range) {
    return value || (range && range->min > 0 && std::isfinite(range->max));
  };
  return bounded(given.crank, bounds.crank) && bounded(given.coupler, bounds.coupler) &&
         bounded(given.rocker, bounds.rocker) && bounded(given.frame, bounds.frame);
}

/// The lengths between which the search, and so its certificate, looks where the file has no
/// bounds.
std::string lengths_text(const std::array<Range, 4>& limits) {
  constexpr const char* kNames[] = {"crank", "coupler", "rocker", "frame"};
  std::string text;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    text += fmt::format(", {} {:g} to {:g}", kNames[i], limits[i].min, limits[i].max);
  }
  return text;
}

}  // namespace

FunctionDomain function_domain(const FunctionProblem& problem, const FunctionSamples& wanted) {
  const auto limits = length_ranges(problem);
  const double ratio = largest_ratio(limits, problem.constraints).value_or(kCertifiedLinkRatio);
  synthesis::DesiredFunction function;
  for (const auto& pair : wanted.samples) {
    function.input.push_back(pair.input);
    function.output.push_back(pair.output);
  }
  function.output_start = problem.output_start;
  function.start = limit_of(problem.start);
  function.lengths = certified_lengths(limits);
  const bool ratio_given = problem.constraints.link_ratio_max || bounds_all_links(problem);
  return {FunctionBound(std::move(function), proportion_limits(problem.constraints, ratio)),
          proportion_roots(problem.constraints, problem.given, limits, ratio, phase_range(problem)),
          domain_text(problem.constraints, problem.given, ratio, ratio_given) +
              (ratio_given ? "" : lengths_text(limits))};
}

Certificate certify(const FunctionProblem& problem, const FunctionSamples& wanted, double upper,
                    const Run& run, const Deadline& deadline) {
  const FunctionDomain domain = function_domain(problem, wanted);
  const CertificateRun certificate(upper, problem.solve, run, deadline);
  if (certificate.met_exactly(kMetExactly)) return certificate.state_exact(domain.text);
  const auto options = certificate.options(1);
  const auto result = synthesis::branch_and_bound(
      domain.roots, options,
      [&](const ProportionBox& box) { return domain.bound(box, options.target); },
      synthesis::halves);
  return certificate.state(result, 1, domain.text);
}

}  // namespace cognate::problems
