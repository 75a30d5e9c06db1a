#include "problems/gear/gear_pair_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/golden_section.hpp"

namespace cognate::problems {
namespace {

/// Violations up to here are rounding, well below the tolerance of the checks.
constexpr double kFeasible = 1e-13;
/// An objective that is no more to be told from an infinite one.
constexpr double kWorst = 1e12;

struct Effort {
  int samples = 0, steps = 0;
};

/// Over the pinion's shift alone; of two unknowns, over each; and to compare combinations.
constexpr Effort kOneUnknown{40, 48}, kOfTwo{16, 32}, kCoarse{8, 6};

const Effort& effort_of(SearchDepth depth) {
  return depth == SearchDepth::fine ? kOfTwo : kCoarse;
}

/// One number to be least: below 0 where every limit is met, by the objective; else the violation.
double merit(const FoundPair& found) {
  if (found.violation > kFeasible) return found.violation;
  const double objective = std::min(found.objective / found.unit, kWorst);
  return objective / (1 + std::abs(objective)) - 1;
}

/// The best of `at(x)` over [from, to]: of samples, then by the golden section around the best one.
template <class At>
FoundPair least_of(const At& at, double from, double to, const Effort& effort) {
  FoundPair best = at(from);
  const auto keep = [&](double x) {
    FoundPair found = at(x);
    const double value = merit(found);
    if (value < merit(best)) best = found;
    return value;
  };
  if (!(from < to)) return best;
  const double step = (to - from) / effort.samples;
  double least = merit(best);
  int place = 0;
  for (int i = 1; i <= effort.samples; ++i) {
    const double value = keep(i < effort.samples ? from + i * step : to);
    if (value < least) {
      least = value;
      place = i;
    }
  }
  golden_section(keep, std::max(from, from + (place - 1) * step),
                 std::min(to, from + (place + 1) * step), effort.steps);
  return best;
}

}  // namespace

GearPairSearch::GearPairSearch(const GearPairProblem& problem, const GearCombination& combination)
    : problem_(problem),
      combination_(combination),
      normal_(std::cos(problem.helix)),
      backlash_(problem.backlash.value_or(0)),
      unshifted_(section_of(problem, {combination.teeth, combination.module, {}, 0}).gears) {}

GearPairSearch::Interval GearPairSearch::shifts_of(std::size_t index, bool without_undercut) const {
  const auto& given = problem_.profile_shift[index];
  if (given) return {*given, *given};
  Interval all{problem_.profile_shift_bounds.min, problem_.profile_shift_bounds.max};
  if (without_undercut) {
    const auto& gear = unshifted_[index];
    all.from = std::max(all.from, gear::least_profile_shift(gear.rack, gear.teeth) / normal_);
  }
  return all;
}

double GearPairSearch::sum_at(double distance) const {
  return gear::profile_shift_sum(unshifted_, distance, backlash_) / normal_;
}

double GearPairSearch::distance_of(double sum) const {
  auto gears = unshifted_;
  gears[0].profile_shift = sum * normal_;  // the sum alone counts
  return gear::centre_distance_with_backlash(gears, backlash_);
}

/// The sums of shifts that the bounds of shifts and of the centre distance leave.
GearPairSearch::Interval GearPairSearch::sums(bool without_undercut) const {
  const Interval first = shifts_of(0, without_undercut), second = shifts_of(1, without_undercut);
  Interval all{first.from + second.from, first.to + second.to};
  if (problem_.centre_distance) {
    const double sum = sum_at(*problem_.centre_distance);
    return {sum, sum};
  }
  const auto& distances = problem_.centre_distance_bounds;
  const double bases = gear::base_radius(unshifted_[0]) + gear::base_radius(unshifted_[1]);
  if (distances.min > bases) all.from = std::max(all.from, sum_at(distances.min));
  if (std::isfinite(distances.max)) {
    all.to = std::min(all.to, distances.max > bases ? sum_at(distances.max) : -HUGE_VAL);
  }
  return all;
}

/// By how much the sums that the centre distance allows miss those that the shifts allow.
double GearPairSearch::missing_sum(bool without_undercut) const {
  const Interval first = shifts_of(0, without_undercut), second = shifts_of(1, without_undercut);
  const Interval wanted = sums(without_undercut);
  const double narrow = std::max({0.0, first.from - first.to, second.from - second.to});
  const double below = first.from + second.from - wanted.to;
  const double above = wanted.from - (first.to + second.to);
  const double missing = std::max({narrow, below, above, 0.0});
  return missing > kFeasible || std::isnan(missing) ? (std::isfinite(missing) ? missing : kWorst)
                                                    : 0;
}

CheapTests GearPairSearch::cheap_tests() const {
  CheapTests tests;
  const auto [first, second] = combination_.teeth;
  if (problem_.ratio) {
    const double off = std::abs(double(second) / first / *problem_.ratio - 1);
    tests.ratio = std::max(0.0, off - problem_.ratio_tolerance - 1e-12);
  }
  if (problem_.constraints.hunting && std::gcd(first, second) > 1) tests.hunting = 1;
  tests.centre_distance = missing_sum(false);
  if (problem_.constraints.no_undercut && tests.centre_distance == 0) {
    tests.undercut = missing_sum(true);
  }
  return tests;
}

double GearPairSearch::objective_of(const GearPairNumbers& numbers,
                                    const gear::PairGeometry& mesh) const {
  switch (problem_.objective) {
    case GearObjective::balanced_sliding:
      return greatest_sliding(mesh);
    case GearObjective::contact_ratio:
      return -total_contact_ratio(problem_, numbers.module, mesh);
    case GearObjective::size:
      return numbers.centre_distance;
  }
  return 0;
}

FoundPair GearPairSearch::at(double first, double second, double centre_distance) const {
  FoundPair found;
  found.numbers = {combination_.teeth, combination_.module, {first, second}, centre_distance};
  const auto pair = section_of(problem_, found.numbers);
  const auto mesh = mesh_of(pair);
  found.violation = GearLimits(problem_, found.numbers, pair, mesh).violation();
  found.objective = mesh ? objective_of(found.numbers, *mesh) : kWorst;
  if (std::isnan(found.objective)) found.objective = kWorst;
  if (problem_.objective == GearObjective::size) found.unit = combination_.module;
  return found;
}

/// Where the sliding at the foot of both flanks is the same, by a zero and not by a minimum.
double GearPairSearch::balanced_shift(double sum, double distance, double from, double to) const {
  const gear::SpurPair pair =
      section_of(problem_, {combination_.teeth, combination_.module, {from, sum - from}, distance});
  const double shift = gear::balanced_shift(pair, from * normal_, to * normal_) / normal_;
  return std::isfinite(shift) ? std::clamp(shift, from, to) : from;
}

FoundPair GearPairSearch::best_split(double sum, SearchDepth depth) const {
  const double distance = problem_.centre_distance ? *problem_.centre_distance : distance_of(sum);
  const auto at_shift = [&](double first) { return at(first, sum - first, distance); };
  const auto& [one, two] = problem_.profile_shift;
  if (one) return at_shift(*one);
  if (two) return at(sum - *two, *two, distance);
  const bool safe = problem_.constraints.no_undercut;
  const Interval first = shifts_of(0, safe), second = shifts_of(1, safe);
  const Interval all{std::max(first.from, sum - second.to), std::min(first.to, sum - second.from)};
  if (all.empty()) return at_shift(0.5 * (all.from + all.to));
  FoundPair best = least_of(at_shift, all.from, all.to,
                            problem_.centre_distance ? kOneUnknown : effort_of(depth));
  if (problem_.objective == GearObjective::balanced_sliding) {
    const FoundPair balanced = at_shift(balanced_shift(sum, distance, all.from, all.to));
    if (is_better(balanced, best)) best = balanced;
  }
  return best;
}

std::optional<FoundPair> GearPairSearch::best(SearchDepth depth) const {
  const auto& [one, two] = problem_.profile_shift;
  if (one && two) {
    const double distance =
        problem_.centre_distance ? *problem_.centre_distance : distance_of(*one + *two);
    return std::isfinite(distance) ? std::optional(at(*one, *two, distance)) : std::nullopt;
  }
  Interval all = sums(problem_.constraints.no_undercut);
  if (all.empty()) all.from = all.to = 0.5 * (all.from + all.to);
  if (!std::isfinite(all.from) || !std::isfinite(all.to)) return std::nullopt;
  const auto at_sum = [&](double sum) { return best_split(sum, depth); };
  FoundPair found = least_of(at_sum, all.from, all.to, effort_of(depth));
  if (!std::isfinite(found.numbers.centre_distance)) return std::nullopt;
  return found;
}

bool is_better(const FoundPair& a, const FoundPair& b) {
  const bool feasible = a.violation <= kFeasible, other = b.violation <= kFeasible;
  if (feasible != other) return feasible;
  if (!feasible && a.violation != b.violation) return a.violation < b.violation;
  if (a.objective != b.objective) return a.objective < b.objective;
  const auto size = [](const FoundPair& f) { return f.numbers.centre_distance; };
  return size(a) < size(b);
}

}  // namespace cognate::problems
