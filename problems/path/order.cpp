#include "problems/path/order.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/path/curve/curve_branch.hpp"
#include "problems/path/order_intervals.hpp"
#include "problems/path/placing.hpp"

namespace cognate::problems {

struct PathOrderMemory {
  std::vector<Vec2d> targets;  ///< in the axes of the linkage
  std::vector<double> timed_at;
  std::vector<OrderInterval> intervals;
  PlacingWorkspace placing;
  OrderedPlaces best, other;
};

PathOrderWorkspace::PathOrderWorkspace() : memory_(std::make_unique<PathOrderMemory>()) {}
PathOrderWorkspace::~PathOrderWorkspace() = default;

namespace {

/// How far from a dead point the crank stays: beyond, rounding decides whether the linkage closes.
constexpr double kFromDeadPoint = 1e-10;

/// Where μ satisfies its limits, B–D being as long as they make it, from the frame line.
std::vector<CrankRange> ranges_within(const Lengths<double>& links, const Range& limits) {
  const auto& [l1, l2, l3, l4] = links;
  const double product = 4 * l2 * l3;
  // The angle θ at which μ is a limit: 4 l₁ l₄ sin²(θ/2) = d² − (l₄ − l₁)², and with the cosine
  // (l₄ + l₁)² − d²; not positive where no angle reaches it.
  struct End {
    double beyond_near, before_far;
    double angle() const { return 2 * std::atan2(std::sqrt(beyond_near), std::sqrt(before_far)); }
  };
  const auto end = [&](double mu) {
    const double sine = std::sin(0.5 * mu), cosine = std::cos(0.5 * mu);
    return End{(l2 - l3 + l4 - l1) * (l2 - l3 - l4 + l1) + product * sine * sine,
               (l4 + l1 + l2 + l3) * (l4 + l1 - l2 - l3) + product * cosine * cosine};
  };
  const End least = end(limits.min), greatest = end(limits.max);
  if (least.before_far <= 0 || greatest.beyond_near <= 0) return {};
  const bool passes_near = least.beyond_near <= 0, passes_far = greatest.before_far <= 0;
  if (passes_near && passes_far) return {{0, kTurn}};
  if (passes_near) return {{-greatest.angle(), greatest.angle()}};
  if (passes_far) return {{least.angle(), kTurn - least.angle()}};
  return {{least.angle(), greatest.angle()}, {-greatest.angle(), -least.angle()}};
}

/// The parts of `whole` in the ranges `within`, each enlarged as far as the timed points reach.
std::vector<CrankRange> parts_within(const CrankRange& whole, std::span<const CrankRange> within,
                                     const std::optional<CrankRange>& timed) {
  std::vector<CrankRange> parts;
  for (const CrankRange& range : within) {
    const double turns = kTurn * std::ceil((whole.from - range.to) / kTurn);
    CrankRange part{std::max(range.from + turns, whole.from), std::min(range.to + turns, whole.to)};
    if (!(part.from < part.to)) continue;
    if (timed) part = {std::min(part.from, timed->from), std::max(part.to, timed->to)};
    parts.push_back(part);
  }
  if (parts.empty() && timed) parts.push_back(*timed);
  return parts;
}

/// The part of `whole` between the first and the last of crank angles in it, a little more at both
/// ends; empty where not all lie in it.
std::optional<CrankRange> reach(const CrankRange& whole, std::span<const double> angles) {
  CrankRange all{whole.to, whole.from};
  for (const double angle : angles) {
    const double place = whole.from + in_one_turn(angle - whole.from);
    all = {std::min(all.from, place), std::max(all.to, place)};
  }
  if (all.to > whole.to) return std::nullopt;
  return CrankRange{std::max(all.from - 2 * kFromDeadPoint, whole.from),
                    std::min(all.to + 2 * kFromDeadPoint, whole.to)};
}

/// Enters the blocks of an interval.
void enter(std::span<const Block> blocks, const OrderInterval& interval, const Travel& travel,
           OrderedPlaces& places) {
  const std::size_t count = interval.points.size();
  for (const Block& block : blocks) {
    PlaceInOrder place{HeldBy::nothing, travel.angle(block.at), places.blocks++, 0};
    if (!interval.is_closed && block.at <= interval.from) {
      place.held_by = interval.at_start;
      place.timed_point = interval.timed_before;
    } else if (!interval.is_closed && block.at >= interval.to) {
      place.held_by = interval.at_end;
      place.timed_point = interval.timed_after;
    }
    if (place.held_by == HeldBy::timed_point) {
      place.angle = places.of_point[place.timed_point].angle;
    }
    // A block across the seam of a closed interval goes on at its beginning.
    for (std::size_t k = block.first;; k = (k + 1) % count) {
      places.of_point[interval.points[k]] = place;
      if (k == block.last) break;
    }
  }
}

/// The points of one motion of a linkage.
struct Motion {
  const CurveBranch& branch;
  const Travel& travel;
  std::span<const double> weights;
  std::span<const std::size_t> timed;
  bool in_order = true;
};

/// Fills `found` by the intervals of the motion in `own`; the cost is infinite where they cannot be
/// passed.
void place(const Motion& motion, PathOrderMemory& own, OrderedPlaces& found) {
  const std::size_t n = own.targets.size();
  found.of_point.assign(n, {});
  found.blocks = 0;
  found.cost = kInfinity;
  for (std::size_t k = 0; k < motion.timed.size(); ++k) {
    found.of_point[motion.timed[k]].angle = motion.travel.sense * own.timed_at[k];
  }
  for (OrderInterval& interval : own.intervals) {
    if (interval.points.empty()) continue;
    interval.from = motion.travel.place(interval.from);
    interval.to = motion.travel.place(interval.to);
    PathPlacing placing(motion.branch, motion.travel, interval, own.targets, motion.weights,
                        own.placing);
    if (!placing.is_possible()) return;
    enter(motion.in_order ? placing.in_order() : placing.in_any_order(), interval, motion.travel,
          found);
  }
  found.cost = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const auto point = motion.branch.point(found.of_point[j].angle);
    found.cost += point ? motion.weights[j] * squared_norm(*point - own.targets[j]) : kInfinity;
  }
}

}  // namespace

bool assigns_places(const PathProblem& problem) {
  const Constraints& constraints = problem.constraints;
  // A curve that has to follow a closed target as a whole passes its samples in order anyhow.
  const bool follows_target = constraints.full_turn && constraints.no_extra_loop;
  return problem.timing != Timing::prescribed && !follows_target &&
         (constraints.no_order_defect || constraints.no_circuit_defect);
}

bool OrderedPlaces::any_held() const {
  std::size_t alone = 0, untimed = 0;
  for (const PlaceInOrder& place : of_point) {
    untimed += place.held_by != HeldBy::timing;
    alone += place.held_by == HeldBy::nothing;
  }
  return alone < untimed || blocks < untimed;
}

PathOrder::PathOrder(const PathProblem& scaled, std::optional<Range> transmission)
    : points_(scaled.points),
      weights_(scaled.weights),
      in_order_(scaled.order == PointOrder::cyclic && scaled.constraints.no_order_defect),
      transmission_(transmission) {
  weights_.resize(points_.size(), 1.0);
  for (std::size_t j = 0; j < points_.size(); ++j) {
    if (scaled.is_timed(j)) timed_.push_back(j);
  }
  intervals_ = std::make_unique<OrderIntervals>(points_.size(), timed_, in_order_);
}

PathOrder::~PathOrder() = default;

/// Those of a crank that does not turn fully, from the frame line.
std::vector<CrankRange> PathOrder::ranges(const Lengths<double>& links,
                                          std::span<const double> timed_at, double sense) const {
  const std::vector<CrankRange> whole = crank_ranges(links);
  if (!transmission_) return whole;
  const std::vector<CrankRange> within = ranges_within(links, *transmission_);
  std::vector<double> angles;
  for (const double at : timed_at) angles.push_back(sense * at);
  std::vector<CrankRange> parts;
  for (const CrankRange& range : whole) {
    const auto timed = angles.empty() ? std::nullopt : reach(range, angles);
    if (!angles.empty() && !timed) continue;
    std::ranges::copy(parts_within(range, within, timed), std::back_inserter(parts));
  }
  return parts;
}

const OrderedPlaces* PathOrder::places(const FourBar& linkage, std::span<const double> crank_angles,
                                       bool clockwise, PathOrderWorkspace& workspace) const {
  PathOrderMemory& own = *workspace;
  const CurveBranch branch(linkage);
  const double sense = clockwise ? -1 : 1, direction = frame_angle(linkage);
  own.targets.clear();
  for (const Vec2d& point : points_) own.targets.push_back(branch.in_frame(point));
  own.timed_at.clear();
  for (const std::size_t j : timed_) own.timed_at.push_back(sense * (crank_angles[j] - direction));

  own.best.cost = kInfinity;
  const auto try_out = [&](const Travel& travel) {
    place({branch, travel, weights_, timed_, in_order_}, own, own.other);
    if (own.other.cost < own.best.cost) std::swap(own.best, own.other);
  };
  const Lengths<double> links = lengths(linkage);
  if (crank_rotates(links)) {
    intervals_->round(own.timed_at, own.intervals);
    try_out({.sense = sense});
    return std::isfinite(own.best.cost) ? &own.best : nullptr;
  }
  for (const CrankRange& range : ranges(links, own.timed_at, sense)) {
    const double half = 0.5 * (range.to - range.from);
    if (!(half > kFromDeadPoint)) continue;
    const double middle = sense * (range.from + half);
    const bool passes =
        intervals_->between(middle - half + kFromDeadPoint, middle + half - kFromDeadPoint,
                            own.timed_at, own.intervals);
    if (passes) try_out({sense, false, middle, half});
  }
  return std::isfinite(own.best.cost) ? &own.best : nullptr;
}

}  // namespace cognate::problems
