#include "problems/search/objective_rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/linkage/linkage_keys.hpp"

namespace cognate::problems {
namespace {

double transmission_angle(const Design& design) {
  return design.metrics.transmission_acute_min;
}

bool limit_transmission_angle(DesignLimits& limits, double least) {
  const Range any{0, kPi};
  auto& range = limits.constraints.transmission_angle;
  range = Range{std::max(range.value_or(any).min, least),
                std::min(range.value_or(any).max, kPi - least)};
  return range->min < range->max;
}

double longest_link(const Design& design) {
  const auto links = lengths(four_bar(design));
  return std::max({links.crank, links.coupler, links.rocker, links.frame});
}

double link_ratio(const Design& design) {
  const auto links = lengths(four_bar(design));
  return longest_link(design) / std::min({links.crank, links.coupler, links.rocker, links.frame});
}

bool limit_link_ratio(DesignLimits& limits, double greatest) {
  auto& ratio = limits.constraints.link_ratio_max;
  ratio = std::min(ratio.value_or(greatest), greatest);
  return *ratio >= 1;
}

bool limit_size(DesignLimits& limits, double greatest) {
  const Range any{0, std::numeric_limits<double>::infinity()};
  for (const LinkKey& link : kLinkKeys) {
    auto& range = limits.bounds.*link.bounds;
    range = Range{range.value_or(any).min, std::min(range.value_or(any).max, greatest)};
    if (!(range->min <= range->max)) return false;
  }
  return true;
}

constexpr ObjectiveRule kGeometric[] = {
    {DesignObjective::transmission_angle, "transmission_angle_deg.acute_min",
     "the minimum transmission angle", true, kRightAngle, false, transmission_angle,
     limit_transmission_angle},
    {DesignObjective::link_ratio, "link_ratio", "the ratio of the longest to the shortest link",
     false, 1, true, link_ratio, limit_link_ratio},
    {DesignObjective::size, "longest_link", "the longest link", false, 0, true, longest_link,
     limit_size}};

/// Of a design of which it is not known a quantity is no better than any.
template <std::size_t Index>
double cycle_value(const Design& design) {
  return design.metrics.cycle[kCycleQuantities[Index].id].value_or(kInfinity);
}

template <std::size_t Index>
bool limit_cycle_value(DesignLimits& limits, double greatest) {
  auto& limit = limits.constraints.cycle_max[kCycleQuantities[Index].id];
  limit = std::min(limit.value_or(greatest), greatest);
  return *limit > 0;
}

template <std::size_t... Index>
constexpr auto cycle_rules(std::index_sequence<Index...>) {
  return std::array{ObjectiveRule{.measure = objective_of(kCycleQuantities[Index].id),
                                  .column = kCycleQuantities[Index].key(),
                                  .words = kCycleQuantities[Index].words,
                                  .is_quantity = false,
                                  .value = cycle_value<Index>,
                                  .limit = limit_cycle_value<Index>}...};
}

constexpr auto kOverCycle = cycle_rules(std::make_index_sequence<kCycleQuantities.size()>{});

}  // namespace

double ObjectiveRule::shown(double value) const {
  return column.find("_deg") != std::string_view::npos ? degrees(value) : value;
}

const ObjectiveRule& rule_of(DesignObjective measure) {
  if (is_over_cycle(measure)) {
    return *std::ranges::find(kOverCycle, measure, &ObjectiveRule::measure);
  }
  return *std::ranges::find(kGeometric, measure, &ObjectiveRule::measure);
}

}  // namespace cognate::problems
