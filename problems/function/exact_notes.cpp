#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/linkage/motion_within.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "problems/basics/enumeration.hpp"
#include "problems/evaluation/mechanism_metrics.hpp"
#include "problems/function/exact.hpp"
#include "problems/function/generator.hpp"

namespace cognate::problems {
namespace {

/// Near the limit of long links, where the refinement of a family ends.
constexpr double kNearLimit = 0.9;

double stretch(const Design& design) {
  return link_ratio(link_lengths(design.mechanism));
}

bool misses(const Design& design, std::string_view name) {
  return std::ranges::any_of(design.constraints, [&](const ConstraintCheck& check) {
    return check.name == name && !check.satisfied;
  });
}

/// Which link points the other way than the starts given have it; empty where none does.
std::string_view turned(const Design& design) {
  const bool input = misses(design, "mechanism.input_start_deg");
  const bool output = misses(design, "mechanism.output_start_deg");
  if (input && output) return "the frame comes out negative, so that input and output start";
  if (input) return "the crank comes out negative, so that it starts";
  return output ? "the rocker comes out negative, so that it starts" : std::string_view{};
}

bool closes(const Design& design, const Range& sweep) {
  const double start = *design.metrics.input_start;
  const auto* slider = std::get_if<SliderCrank>(&design.mechanism.description);
  const auto ranges = slider ? crank_ranges(*slider) : crank_ranges(lengths(four_bar(design)));
  return motion_within(ranges, {start + sweep.min, start + sweep.max}).has_value();
}

/// "Design 2" or "Designs 1, 2 and 4", of those for which `applies` holds; empty where none.
template <class Applies>
std::string designs_where(const std::vector<Design>& designs, const Applies& applies) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    if (applies(designs[i])) numbers.push_back(std::to_string(i + 1));
  }
  if (numbers.empty()) return {};
  return fmt::format("Design{} {}", numbers.size() > 1 ? "s" : "", enumeration(numbers));
}

void note_turned(Result& result) {
  std::vector<std::string_view> reported;
  for (const Design& design : result.designs) {
    const std::string_view what = turned(design);
    if (what.empty() || std::ranges::count(reported, what) > 0) continue;
    reported.push_back(what);
    const auto alike = [&](const Design& other) { return turned(other) == what; };
    result.notes.push_back(
        fmt::format("{}: {} turned by 180° from the angle given; lengths are positive here, and "
                    "the start given counts as not kept.",
                    designs_where(result.designs, alike), what));
  }
}

}  // namespace

bool is_limiting(const Design& design) {
  return stretch(design) > kLimitingRatio;
}

void note_designs(const FunctionSamples& wanted, Result& result) {
  note_turned(result);
  const auto open = designs_where(
      result.designs, [&](const Design& design) { return !closes(design, wanted.sweep); });
  if (!open.empty()) {
    result.notes.push_back(
        fmt::format("{}: the linkage does not close over the whole range; its error is that at the "
                    "precision points.",
                    open));
  }
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    const double ratio = stretch(result.designs[i]);
    if (!(ratio > kNearLimit * kLimitingRatio)) continue;
    result.notes.push_back(fmt::format(
        "Design {}: the longest link is {:.4g} times the shortest, near the limit in which a "
        "slider takes the place of long links; designs beyond {:g} times come after others, and "
        "constraints.link_ratio_max keeps links shorter.",
        i + 1, ratio, kLimitingRatio));
  }
}

}  // namespace cognate::problems
