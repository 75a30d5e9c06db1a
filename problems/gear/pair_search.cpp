#include "problems/gear/pair_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "analysis/numbers/golden_section.hpp"

namespace cognate::problems {
namespace {

/// Violations up to here are rounding, well below the tolerance of the checks.
constexpr double kFeasible = 1e-13;
/// An objective that counts as infinite.
constexpr double kWorst = 1e12;

struct Effort {
  int samples = 0, steps = 0;
};

/// Over the pinion's shift alone; and over each of two unknowns.
constexpr Effort kOneUnknown{40, 48}, kRough{4, 0}, kCoarse{8, 6}, kFine{16, 32};

const Effort& effort_of(SearchDepth depth) {
  if (depth == SearchDepth::rough) return kRough;
  return depth == SearchDepth::coarse ? kCoarse : kFine;
}

/// The best of `at(x, to_beat)` over [from, to]: of samples, then by the golden section around the
/// best one.
template <class At>
PairDesign least_of(const At& at, double from, double to, const Effort& effort) {
  PairDesign best = at(from, HUGE_VAL);
  double least = best.merit();
  const auto keep = [&](double x) {
    const PairDesign found = at(x, least);
    const double value = found.merit();
    if (value < least) {
      best = found;
      least = value;
    }
    return value;
  };
  if (!(from < to)) return best;
  const double step = (to - from) / effort.samples;
  int place = 0;
  for (int i = 1; i <= effort.samples; ++i) {
    const double before = least;
    if (keep(i < effort.samples ? from + i * step : to) < before) place = i;
  }
  if (effort.steps == 0) return best;
  golden_section(keep, std::max(from, from + (place - 1) * step),
                 std::min(to, from + (place + 1) * step), effort.steps);
  return best;
}

}  // namespace

double PairDesign::merit() const {
  const double avoidable = violation - unavoidable;
  if (avoidable > kFeasible) return avoidable;
  const double size = std::min(objective / unit, kWorst);
  return size / (1 + std::abs(size)) - 1;
}

GearPairSearch::Interval GearPairSearch::Interval::operator&(const Interval& other) const {
  return {std::max(from, other.from), std::min(to, other.to)};
}

GearPairSearch::GearPairSearch(const GearPairProblem& problem, const GearCombination& combination)
    : problem_(problem),
      combination_(combination),
      normal_(std::cos(problem.helix)),
      backlash_(problem.backlash.value_or(0)),
      unshifted_(section_of(problem, {combination.teeth, combination.module, {}, 0}).gears),
      closest_(gear::sum_of_base_radii(unshifted_) * (1 + 1e-9)) {}

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

/// The sums of shifts that belong to the centre distances requested; of those that are too close
/// for any, those of the closest.
GearPairSearch::Interval GearPairSearch::wanted_sums() const {
  const auto sum = [&](double distance) { return sum_at(std::max(distance, closest_)); };
  const auto& given = problem_.centre_distance;
  if (given) return {sum(*given), sum(*given)};
  const auto& [least, greatest] = problem_.centre_distance_bounds;
  return {sum(least), std::isfinite(greatest) ? sum(greatest) : HUGE_VAL};
}

/// Those that are searched: within the bounds of shifts, and without undercut if that can be. Where
/// they miss the centre distance, all that have any.
GearPairSearch::Interval GearPairSearch::sums() const {
  const Interval touching{sum_at(closest_), HUGE_VAL};
  for (const Interval& wanted : {wanted_sums(), touching}) {
    for (const bool without_undercut : {problem_.constraints.no_undercut, false}) {
      const Interval first = shifts_of(0, without_undercut),
                     second = shifts_of(1, without_undercut);
      const Interval all = (first + second) & wanted;
      if (!first.empty() && !second.empty() && !all.empty()) return all;
    }
  }
  const double most = (shifts_of(0, false) + shifts_of(1, false)).to;
  return {most, most};
}

/// The pinion's shifts with which the wheel's is within its bounds too.
GearPairSearch::Interval GearPairSearch::first_shifts(double sum) const {
  const auto within = [&](bool without_undercut) {
    const Interval first = shifts_of(0, without_undercut), second = shifts_of(1, without_undercut);
    return first & Interval{sum - second.to, sum - second.from};
  };
  if (problem_.constraints.no_undercut) {
    const Interval all = within(true);
    if (!all.empty()) return all;
  }
  const Interval all = within(false);
  if (!all.empty()) return all;
  const double middle = 0.5 * (all.from + all.to);  // between ends that only rounding parts
  return {middle, middle};
}

/// By how many modules of shift, or of a centre distance at which base circles overlap, the pair is
/// kept from the centre distance requested.
double GearPairSearch::missing_sum(bool without_undercut) const {
  const Interval first = shifts_of(0, without_undercut), second = shifts_of(1, without_undercut);
  const Interval shifts = first + second, wanted = wanted_sums();
  const double narrow = std::max(first.from - first.to, second.from - second.to);
  const double farthest = problem_.centre_distance.value_or(problem_.centre_distance_bounds.max);
  const double overlap = std::max(0.0, (closest_ - farthest) / combination_.module);
  const double missing =
      overlap + std::max({0.0, narrow, shifts.from - wanted.to, wanted.from - shifts.to});
  return missing > kFeasible ? missing : 0;
}

std::optional<Refusal> GearPairSearch::refusal() const {
  const auto [first, second] = combination_.teeth;
  if (problem_.ratio) {
    const double off =
        std::abs(double(second) / first / *problem_.ratio - 1) - problem_.ratio_tolerance;
    if (off > 1e-12) return Refusal{CheapTest::ratio, off};
  }
  if (problem_.constraints.hunting && std::gcd(first, second) > 1) {
    return Refusal{CheapTest::hunting, 1};
  }
  const double missing = missing_sum(false);
  if (missing > 0) return Refusal{CheapTest::centre_distance, missing};
  if (!problem_.constraints.no_undercut) return std::nullopt;
  const double cut = missing_sum(true);
  return cut > 0 ? std::optional(Refusal{CheapTest::undercut, cut}) : std::nullopt;
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

PairDesign GearPairSearch::at(double first, double second, double centre_distance, double to_beat,
                              SearchDepth depth) const {
  PairDesign found;
  found.numbers = {combination_.teeth, combination_.module, {first, second}, centre_distance};
  if (problem_.objective == GearObjective::size) found.unit = combination_.module;
  gear::SpurPair pair{unshifted_, centre_distance};
  for (std::size_t i = 0; i < 2; ++i) {
    pair.gears[i].profile_shift = normal_ * found.numbers.shift[i];
  }
  std::optional<gear::PairGeometry> mesh;
  if (can_mesh(pair)) mesh = gear::geometry_of_line(pair);
  const auto weigh = [&] {
    const GearLimits limits(problem_, found.numbers, pair, mesh);
    found.violation = limits.violation();
    found.unavoidable = limits.violation_of_teeth();
  };
  weigh();
  found.objective = mesh ? objective_of(found.numbers, *mesh) : kWorst;
  if (std::isnan(found.objective)) found.objective = kWorst;
  const bool asks = mesh && problem_.constraints.no_interference && found.merit() < to_beat;
  if (asks && (depth == SearchDepth::fine || found.merit() < 0)) {
    gear::add_fillet_interference(pair, *mesh);
    weigh();
  }
  return found;
}

/// Where the sliding at the foot of both flanks is the same, by a zero and not by a minimum.
double GearPairSearch::balanced_shift(double sum, double distance, const Interval& shifts) const {
  const gear::SpurPair pair = section_of(
      problem_,
      {combination_.teeth, combination_.module, {shifts.from, sum - shifts.from}, distance});
  const double shift =
      gear::balanced_shift(pair, shifts.from * normal_, shifts.to * normal_) / normal_;
  return std::isfinite(shift) ? std::clamp(shift, shifts.from, shifts.to) : shifts.from;
}

PairDesign GearPairSearch::best_split(double sum, SearchDepth depth) const {
  const double distance = problem_.centre_distance ? *problem_.centre_distance : distance_of(sum);
  const auto at_shift = [&](double first, double to_beat) {
    return at(first, sum - first, distance, to_beat, depth);
  };
  const auto& [one, two] = problem_.profile_shift;
  if (one) return at_shift(*one, HUGE_VAL);
  if (two) return at(sum - *two, *two, distance, HUGE_VAL, depth);
  const Interval all = first_shifts(sum);
  PairDesign best = least_of(at_shift, all.from, all.to,
                             problem_.centre_distance ? kOneUnknown : effort_of(depth));
  if (problem_.objective == GearObjective::balanced_sliding && all.from < all.to) {
    const double to_beat = best.merit();
    const PairDesign balanced = at_shift(balanced_shift(sum, distance, all), to_beat);
    if (balanced.merit() < to_beat) best = balanced;
  }
  return best;
}

std::optional<PairDesign> GearPairSearch::best(SearchDepth depth) const {
  const auto& [one, two] = problem_.profile_shift;
  if (one && two) {
    const double distance =
        problem_.centre_distance ? *problem_.centre_distance : distance_of(*one + *two);
    return std::isfinite(distance) ? std::optional(at(*one, *two, distance, HUGE_VAL, depth))
                                   : std::nullopt;
  }
  const Interval all = sums();
  const auto at_sum = [&](double sum, double /*to_beat*/) { return best_split(sum, depth); };
  PairDesign found = least_of(at_sum, all.from, all.to, effort_of(depth));
  if (!std::isfinite(found.numbers.centre_distance)) return std::nullopt;
  return found;
}

bool is_smaller(const PairDesign& a, const PairDesign& b) {
  const auto size = [](const PairDesign& pair) {
    return std::tuple(pair.numbers.centre_distance, pair.numbers.teeth);
  };
  return size(a) < size(b);
}

bool is_better(const PairDesign& a, const PairDesign& b) {
  const bool feasible = a.violation <= kFeasible, other = b.violation <= kFeasible;
  if (feasible != other) return feasible;
  if (!feasible && a.violation != b.violation) return a.violation < b.violation;
  if (a.objective != b.objective) return a.objective < b.objective;
  return is_smaller(a, b);
}

bool is_as_good(const PairDesign& a, const PairDesign& b) {
  constexpr double kRounding = 1e-9;
  const auto near = [](double x, double y) {
    return x == y || std::abs(x - y) <= kRounding * std::max(std::abs(x), std::abs(y));
  };
  const bool feasible = a.violation <= kFeasible, other = b.violation <= kFeasible;
  return feasible == other && (feasible || near(a.violation, b.violation)) &&
         near(a.objective, b.objective);
}

}  // namespace cognate::problems
