#include "problems/chain/ordered_angles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"
#include "synthesis/chain/sweep.hpp"

namespace cognate::problems {
namespace {

constexpr std::size_t kLeastSteps = 72, kStepsOfAPoint = 4;
constexpr std::size_t kFiner = 3;  ///< of ranges, in which a point's angle is the harder to find
constexpr std::size_t kMost = 3;   ///< of both senses together
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
    synthesis::place(view, unit_vector(crank), place);
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

/// The crank's steps over a turn, and the traced point there.
struct Steps {
  std::vector<double> cranks;
  std::vector<Vec2d> curve;

  Steps(const ScaledChain& problem, const synthesis::ChainDesign& design) {
    const std::size_t steps = std::max(kLeastSteps, kStepsOfAPoint * problem.points.size());
    for (std::size_t i = 0; i < steps; ++i) cranks.push_back(kTurn * double(i) / double(steps));
    curve = curve_of(problem, design, cranks);
    if (std::ranges::all_of(curve, [](const Vec2d& at) { return std::isfinite(at.x); })) return;
    cranks = cranks_in_ranges(problem, design, kFiner * steps);
    curve = curve_of(problem, design, cranks);
  }
};

using Beginning = std::pair<double, std::size_t>;

/// Steps in order for one sense of the crank.
class InOrder {
 public:
  InOrder(const std::vector<Vec2d>& points, const Steps& steps, bool clockwise)
      : points_(points),
        curve_(steps.curve),
        cranks_(steps.cranks),
        clockwise_(clockwise),
        least_(curve_.size()) {}

  /// The sums that are least among their neighbours, with the steps where they begin.
  std::vector<Beginning> valleys() {
    const std::size_t stride = std::max<std::size_t>(1, curve_.size() / kLeastSteps);
    std::vector<Beginning> sums;
    for (std::size_t begin = 0; begin < curve_.size(); begin += stride) {
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
    std::vector<std::vector<double>> tables{std::vector(curve_.size(), square(0, begin))};
    for (std::size_t point = 1; point < points_.size(); ++point) {
      std::vector<double> next(curve_.size(), kNone);
      for (std::size_t k = 1; k < next.size(); ++k) {
        next[k] = std::min(next[k - 1], tables.back()[k - 1] + square(point, begin + k));
      }
      tables.push_back(std::move(next));
    }
    std::vector<double> found(points_.size());
    std::size_t k = curve_.size() - 1;
    for (std::size_t point = points_.size() - 1; point > 0; --point) {
      while (k > 1 && tables[point][k - 1] <= tables[point][k]) --k;
      found[point] = angle(begin + k);
      --k;
    }
    found[0] = angle(begin);
    return found;
  }

 private:
  double square(std::size_t point, std::size_t step) const {
    const double away = squared_norm(curve_[place(step)] - points_[point]);
    return std::isfinite(away) ? away : kNone;
  }

  /// With the first point at step `begin` and each other at a later one, within a turn. least_[k]:
  /// of the points so far with the last of them no later than k steps on.
  double least_sum(std::size_t begin) {
    std::ranges::fill(least_, square(0, begin));
    for (std::size_t point = 1; point < points_.size(); ++point) {
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
    const std::size_t count = curve_.size(), ahead = step % count;
    return clockwise_ ? (count - ahead) % count : ahead;
  }

  double angle(std::size_t step) const {
    const std::size_t count = curve_.size();
    const auto turns = std::ptrdiff_t((clockwise_ ? step + count - 1 : step) / count);
    return cranks_[place(step)] + kTurn * double(clockwise_ ? -turns : turns);
  }

  const std::vector<Vec2d>& points_;
  const std::vector<Vec2d>& curve_;
  const std::vector<double>& cranks_;
  bool clockwise_;
  std::vector<double> least_;
};

}  // namespace

std::vector<std::vector<double>> ordered_angles(const ScaledChain& problem,
                                                const synthesis::ChainDesign& design) {
  const Steps steps(problem, design);
  if (steps.cranks.empty()) return {};
  InOrder senses[] = {{problem.points, steps, false}, {problem.points, steps, true}};
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

}  // namespace cognate::problems
