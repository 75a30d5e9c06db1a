#include "synthesis/exact/respacing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/function/designs.hpp"
#include "problems/function/exact.hpp"
#include "problems/function/exact_generators.hpp"
#include "problems/function/generator.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

using synthesis::AnglePair;
using synthesis::GeneratingFourBar;
using synthesis::Respacing;
using synthesis::RespacingOutcome;
using synthesis::RespacingTask;

/// Linkages whose lengths agree to this, relative, have met at the same level peaks.
constexpr double kSameSpacing = 1e-6;

/// x as a share of the domain, as the input goes from `from` to `to`.
double share_at(const RespacingTask& task, double input) {
  return std::clamp((input - task.from) / (task.to - task.from), 0.0, 1.0);
}

RespacingTask task_of(const FunctionProblem& problem, const FunctionSamples& wanted) {
  RespacingTask task;
  task.from = wanted.at(0).input;
  task.to = wanted.at(1).input;
  task.input_start_free = !problem.input_start;
  task.output_start_free = !problem.output_start;
  task.output = [&wanted, from = task.from, to = task.to](double input) {
    return wanted.at(std::clamp((input - from) / (to - from), 0.0, 1.0)).output;
  };
  return task;
}

GeneratingFourBar start_of(const Design& design) {
  const FourBar& linkage = four_bar(design);
  return {lengths(linkage), linkage.assembly, *design.metrics.input_start,
          *design.metrics.output_start};
}

/// The file's scale: where it gives the frame instead of the crank, that is kept.
Lengths<double> to_file_scale(const Lengths<double>& links, const Given& given) {
  if (!given.frame || given.crank) return links;
  const double factor = *given.frame / links.frame;
  return {factor * links.crank, factor * links.coupler, factor * links.rocker, *given.frame};
}

/// The linkage found, as other exact designs are.
Design design_of(const FunctionProblem& problem, const FunctionSamples& wanted,
                 const RespacingTask& task, const Respacing& found, const std::string& origin) {
  FunctionGenerator generator;
  generator.links = to_file_scale(found.linkage.links, problem.given);
  generator.assembly = found.linkage.assembly;
  generator.input_start = found.linkage.input_start;
  generator.output_start = found.linkage.output_start;
  std::vector<AnglePair> pairs;
  for (const double input : found.precision_inputs) {
    pairs.push_back(wanted.at(share_at(task, input)));
  }
  const auto positions = positions_of(generator, pairs);
  Design design = function_design(problem, wanted, generator, positions, origin + " + equal peaks");
  design.metrics.precision_residual = largest_error(generator, pairs, positions);
  return design;
}

/// "peaks level at 0.0235 degrees, the precision points at x = 1.02, …".
std::string level_note(const FunctionProblem& problem, const RespacingTask& task,
                       const Respacing& found, std::size_t number) {
  const Range& domain = std::get<FunctionOfX>(problem.target).domain;
  std::string points;
  for (const double input : found.precision_inputs) {
    const double x = domain.min + share_at(task, input) * (domain.max - domain.min);
    points += fmt::format("{}{:.9g}", points.empty() ? "" : ", ", x);
  }
  return fmt::format(
      "Design {}: {} peaks of the structural error level at {:.6g} degrees, with the precision "
      "points at x = {}.",
      number, found.peaks.size(), found.greatest / kDegree, points);
}

const char* why_not_level(RespacingOutcome outcome) {
  switch (outcome) {
    case RespacingOutcome::not_closing:
      return "the linkage does not close over the whole range";
    case RespacingOutcome::not_alternating:
      return "its error does not change sign at each precision point";
    case RespacingOutcome::stalled:
      return "no step lowers its greatest error further, as where the best linkage is infinitely "
             "long";
    case RespacingOutcome::level:
      break;
  }
  return "";
}

/// A design with what the exchange made of it.
struct Respaced {
  Design design;
  Respacing found;
};

bool same(const Respaced& a, const Respaced& b) {
  if (a.found.outcome != RespacingOutcome::level || b.found.outcome != a.found.outcome)
    return false;
  const Lengths<double> x = lengths(four_bar(a.design)), y = lengths(four_bar(b.design));
  const auto near = [](double p, double q) { return std::abs(p - q) <= kSameSpacing * (p + q); };
  return near(x.coupler, y.coupler) && near(x.rocker, y.rocker) && near(x.frame, y.frame) &&
         near(a.found.greatest, b.found.greatest);
}

}  // namespace

void level_peaks(const FunctionProblem& problem, const FunctionSamples& wanted, Result& result) {
  const RespacingTask task = task_of(problem, wanted);
  std::vector<Respaced> all;
  for (Design& design : result.designs) {
    Respaced next{{}, synthesis::equal_peaks(task, start_of(design))};
    const bool moved = next.found.exchanges > 0;
    next.design =
        moved ? design_of(problem, wanted, task, next.found, design.origin) : std::move(design);
    const bool known = std::ranges::any_of(all, [&](const auto& one) { return same(one, next); });
    if (!known) all.push_back(std::move(next));
  }
  std::ranges::stable_sort(all, {}, [](const Respaced& one) {
    return std::tuple(violation(one.design.constraints), is_limiting(one.design),
                      one.design.error.max);
  });
  result.designs.clear();
  for (Respaced& one : all) {
    const std::size_t number = result.designs.size() + 1;
    result.notes.push_back(one.found.outcome == RespacingOutcome::level
                               ? level_note(problem, task, one.found, number)
                               : fmt::format("Design {}: the peaks of the structural error could "
                                             "not be levelled; {}.",
                                             number, why_not_level(one.found.outcome)));
    result.designs.push_back(std::move(one.design));
  }
}

}  // namespace cognate::problems
