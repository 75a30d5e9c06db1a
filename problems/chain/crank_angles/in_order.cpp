#include "problems/chain/crank_angles/in_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"
#include "problems/chain/chosen_targets.hpp"
#include "synthesis/chain/sweep.hpp"

namespace cognate::problems {
namespace {

constexpr std::size_t kLeastSteps = 720, kStepsOfAPoint = 4;
constexpr std::size_t kBeginnings = 72;  ///< steps of the first point that are tried
constexpr std::size_t kFiner = 3;  ///< of ranges, in which a point's angle is the harder to find
constexpr std::size_t kMost = 3;   ///< of both senses together
constexpr std::size_t kMostOrdered = 240;  ///< points that are put in order step by step
constexpr double kNone = std::numeric_limits<double>::infinity();

std::vector<Vec2d> curve_of(const ScaledChain& problem, const synthesis::ChainDesign& design,
                            const std::vector<double>& cranks) {
  const std::vector<double> side(design.side.begin(), design.side.end());
  const synthesis::ChainView<double> view{problem.lines.data(),
                                          static_cast<int>(problem.lines.size()),
                                          design.parameters.data(), side.data()};
  synthesis::ChainPlace<double> place;
  std::vector<Vec2d> curve;
  for (const double crank : cranks) {
    synthesis::place_next(view, unit_vector(crank), place);
    curve.push_back(place.at[problem.topology->trace]);
  }
  return curve;
}

/// Crank angles in order within the ranges of a chain whose crank does not turn fully, crowded
/// towards their ends: there the point goes with the root of the distance, and at them it is as
/// fast as one likes.
std::vector<double> cranks_in_ranges(const ScaledChain& problem,
                                     const synthesis::ChainDesign& design, std::size_t steps) {
  std::vector<double> cranks;
  const NamedMechanism mechanism = named(*problem.topology, design);
  for (const auto& [from, to] : ranges_over_a_turn(mechanism.mechanism)) {
    const std::vector<double> all = crowded(from, to, static_cast<int>(steps));
    cranks.insert(cranks.end(), all.begin() + 1, all.end() - 1);
  }
  return cranks;
}

/// The crank's steps over a turn, and the traced point there and half-way to the next step, where
/// the range of the crank goes on.
struct Steps {
  std::vector<double> cranks, halves;
  std::vector<Vec2d> curve, between;

  Steps(const ScaledChain& problem, const synthesis::ChainDesign& design) {
    const std::size_t steps = std::max(kLeastSteps, kStepsOfAPoint * problem.points.size());
    for (std::size_t i = 0; i < steps; ++i) cranks.push_back(kTurn * double(i) / double(steps));
    for (const double crank : cranks) halves.push_back(crank + 0.5 * kTurn / double(steps));
    curve = curve_of(problem, design, cranks);
    between = curve_of(problem, design, halves);
    if (std::ranges::all_of(curve, [](const Vec2d& at) { return std::isfinite(at.x); })) return;
    cranks = cranks_in_ranges(problem, design, kFiner * steps);
    curve = curve_of(problem, design, cranks);
    halves.clear();
    for (std::size_t i = 0; i < cranks.size(); ++i) {
      halves.push_back(i + 1 < cranks.size() ? std::midpoint(cranks[i], cranks[i + 1]) : kNone);
    }
    between = curve_of(problem, design, halves);
  }
};

/// Where a curve comes nearest to a point on the way through a step.
struct Nearest {
  double square = kNone;  ///< of the distance
  double crank = 0;
};

/// Nearer of `known` and the way along a chord; nowhere where that has an end that is none.
Nearest nearer(const Nearest& known, const Vec2d& point, const Vec2d& from, const Vec2d& to,
               const std::array<double, 2>& cranks) {
  const Vec2d chord = to - from;
  const double length = squared_norm(chord);
  const double share = length > 0 ? std::clamp(dot(point - from, chord) / length, 0.0, 1.0) : 0.0;
  const double square = squared_norm(from + share * chord - point);
  if (!(square < known.square)) return known;
  return {square, std::lerp(cranks[0], cranks[1], share)};
}

/// Of each step where the curve is nearest to `point` from half a step before to half a step after.
std::vector<Nearest> nearest_at_steps(const Steps& steps, const Vec2d& point) {
  const std::size_t count = steps.curve.size();
  std::vector<Nearest> all;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    const double crank = steps.cranks[i], half = steps.halves[before];
    Nearest here{squared_norm(steps.curve[i] - point), crank};
    if (!std::isfinite(here.square)) here.square = kNone;
    here = nearer(here, point, steps.curve[i], steps.between[i], {crank, steps.halves[i]});
    here = nearer(here, point, steps.curve[i], steps.between[before],
                  {crank, i == 0 ? half - kTurn : half});
    all.push_back(here);
  }
  return all;
}

using Beginning = std::pair<double, std::size_t>;

/// Steps in order for one sense of the crank.
class InOrder {
 public:
  /// `nearest`: of each point, at each step.
  InOrder(const std::vector<std::vector<Nearest>>& nearest, bool clockwise)
      : nearest_(nearest), clockwise_(clockwise), least_(nearest.front().size()) {}

  /// The sums that are least among their neighbours, with the steps where they begin.
  std::vector<Beginning> valleys() {
    const std::size_t stride = std::max<std::size_t>(1, steps_in_turn() / kBeginnings);
    std::vector<Beginning> sums;
    for (std::size_t begin = 0; begin < steps_in_turn(); begin += stride) {
      sums.emplace_back(least_sum(begin), begin);
    }
    std::vector<Beginning> valleys;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const double before = sums[(i + sums.size() - 1) % sums.size()].first;
      const double after = sums[(i + 1) % sums.size()].first;
      if (std::isfinite(sums[i].first) && sums[i].first <= before && sums[i].first < after) {
        valleys.push_back(sums[i]);
      }
    }
    return valleys;
  }

  /// The angles of the least sum from a step on.
  std::vector<double> angles(std::size_t begin) {
    std::vector<std::vector<double>> tables{std::vector(steps_in_turn(), square(0, begin))};
    for (std::size_t point = 1; point < nearest_.size(); ++point) {
      std::vector<double> next(steps_in_turn(), kNone);
      for (std::size_t k = 1; k < next.size(); ++k) {
        next[k] = std::min(next[k - 1], tables.back()[k - 1] + square(point, begin + k));
      }
      tables.push_back(std::move(next));
    }
    std::vector<double> found(nearest_.size());
    std::size_t k = steps_in_turn() - 1;
    for (std::size_t point = nearest_.size() - 1; point > 0; --point) {
      while (k > 1 && tables[point][k - 1] <= tables[point][k]) --k;
      found[point] = angle(point, begin + k);
      --k;
    }
    found[0] = angle(0, begin);
    return found;
  }

 private:
  double square(std::size_t point, std::size_t step) const {
    return nearest_[point][place(step)].square;
  }

  /// With the first point at step `begin` and each other at a later one, within a turn. least_[k]:
  /// of the points so far with the last of them no later than k steps on.
  double least_sum(std::size_t begin) {
    std::ranges::fill(least_, square(0, begin));
    for (std::size_t point = 1; point < nearest_.size(); ++point) {
      double earlier = kNone, best = kNone;
      for (std::size_t k = 0; k < least_.size(); ++k) {
        best = std::min(best, earlier + square(point, begin + k));
        earlier = least_[k];
        least_[k] = best;
      }
    }
    return least_.back();
  }

  /// Which of the steps over a turn this one is.
  std::size_t place(std::size_t step) const {
    const std::size_t count = steps_in_turn(), ahead = step % count;
    return clockwise_ ? (count - ahead) % count : ahead;
  }

  double angle(std::size_t point, std::size_t step) const {
    const std::size_t count = steps_in_turn();
    const auto turns = std::ptrdiff_t((clockwise_ ? step + count - 1 : step) / count);
    return nearest_[point][place(step)].crank + kTurn * double(clockwise_ ? -turns : turns);
  }

  std::size_t steps_in_turn() const { return least_.size(); }

  const std::vector<std::vector<Nearest>>& nearest_;
  bool clockwise_;
  std::vector<double> least_;
};

std::vector<std::vector<double>> angles_of_all(const ScaledChain& problem,
                                               const synthesis::ChainDesign& design) {
  const Steps steps(problem, design);
  if (steps.cranks.empty()) return {};
  std::vector<std::vector<Nearest>> nearest;
  for (const Vec2d& point : problem.points) nearest.push_back(nearest_at_steps(steps, point));
  InOrder senses[] = {{nearest, false}, {nearest, true}};
  std::vector<std::pair<Beginning, InOrder*>> best;
  for (InOrder& sense : senses) {
    for (const Beginning& valley : sense.valleys()) best.emplace_back(valley, &sense);
  }
  std::ranges::stable_sort(best, {}, [](const auto& one) { return one.first.first; });
  best.resize(std::min(kMost, best.size()));
  std::vector<std::vector<double>> all;
  for (const auto& [beginning, sense] : best) all.push_back(sense->angles(beginning.second));
  return all;
}

}  // namespace

std::vector<std::vector<double>> ordered_angles(const ScaledChain& problem,
                                                const synthesis::ChainDesign& design) {
  const ChosenTargets chosen(problem, kMostOrdered);
  ScaledChain some = problem;
  some.points.clear();
  for (const std::size_t which : chosen.which) some.points.push_back(problem.points[which]);
  std::vector<std::vector<double>> all = angles_of_all(some, design);
  for (auto& angles : all) angles = chosen.at_all(problem, angles);
  return all;
}

}  // namespace cognate::problems
