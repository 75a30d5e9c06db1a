#include "problems/gear/read_pair_bounds.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "problems/gear/rules.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kModulesKey = "modules";

constexpr std::size_t kMostModules = 50;
/// So many combinations of teeth and modules that trying all of them takes less than a minute.
constexpr std::int64_t kMostCombinations = 400'000;

void refuse_both(TableReader& mechanism, std::string_view key, TableReader& bounds,
                 std::string_view bound) {
  if (!mechanism.has(key) || !bounds.has(bound)) return;
  bounds.fault(bound,
               fmt::format("is given beside {}; leave one of them out", mechanism.name(key)));
}

void want_either(TableReader& mechanism, std::string_view key, TableReader& bounds,
                 std::string_view bound, std::string_view form) {
  if (mechanism.has(key) || bounds.has(bound)) return;
  mechanism.fault(key, fmt::format("is missing; expected a value, or {} = {} to find it within",
                                   bounds.name(bound), form));
}

void read_teeth_ranges(TableReader& bounds, GearPairProblem& problem) {
  const auto ranges = bounds.twos(kTeethKey, kTeeth, "[[min, max], [min, max]]", {2, 2, "ranges"});
  if (!ranges) return;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [min, max] = (*ranges)[i];
    if (min > max) {
      bounds.fault(kTeethKey,
                   fmt::format("has an empty range, {} > {}; expected [min, max] with min <= max",
                               min, max));
      return;
    }
    problem.teeth_bounds[i] = {static_cast<int>(min), static_cast<int>(max)};
  }
}

void read_modules(TableReader& bounds, GearPairProblem& problem) {
  auto modules = bounds.numbers(kModulesKey, kLinkLength, {1, kMostModules, "lengths"});
  if (!modules) return;
  std::ranges::sort(*modules);
  const auto doubled = std::ranges::unique(*modules);
  modules->erase(doubled.begin(), doubled.end());
  problem.modules = *std::move(modules);
}

void read_shifts(TableReader& mechanism, TableReader& bounds, GearPairProblem& problem) {
  const auto range = bounds.range(kShift, kProfileShift);
  if (!range) return;
  problem.profile_shift_bounds = *range;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& given = problem.profile_shift[i];
    if (!given || (*given >= range->min && *given <= range->max)) continue;
    mechanism.fault(kShift, fmt::format("has {}, outside its bounds; {} allows [{}, {}]", *given,
                                        bounds.name(kShift), range->min, range->max));
    return;
  }
}

void check_count(TableReader& bounds, const GearPairProblem& problem) {
  std::int64_t count = problem.modules.empty() ? 1 : std::ssize(problem.modules);
  for (const auto& [min, max] : problem.teeth_bounds) count *= max - min + 1;
  if (count <= kMostCombinations) return;
  bounds.fault(kTeethKey, fmt::format("and modules make {} combinations; at most {} are allowed",
                                      count, kMostCombinations));
}

}  // namespace

void read_gear_pair_bounds(TableReader& mechanism, TableReader& bounds, GearPairProblem& problem) {
  read_teeth_ranges(bounds, problem);
  read_modules(bounds, problem);
  read_shifts(mechanism, bounds, problem);
  const auto distances = bounds.range(kDistance, kDistanceLimit);
  if (distances) problem.centre_distance_bounds = *distances;
  refuse_both(mechanism, kTeethKey, bounds, kTeethKey);
  refuse_both(mechanism, kModule, bounds, kModulesKey);
  refuse_both(mechanism, kDistance, bounds, kDistance);
  want_either(mechanism, kTeethKey, bounds, kTeethKey, "[[min, max], [min, max]]");
  want_either(mechanism, kModule, bounds, kModulesKey, "[m, ...]");
  check_count(bounds, problem);
}

}  // namespace cognate::problems::reading
