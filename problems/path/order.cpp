#include "problems/path/order.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/path/curve/curve_branch.hpp"
#include "problems/path/placing.hpp"
#include "problems/path/stretches.hpp"

namespace cognate::problems {

struct PathOrderMemory {
  std::vector<Vec2d> targets;  ///< in the axes of the linkage
  std::vector<double> timed_at;
  std::vector<Stretch> stretches;
  PlacingWorkspace placing;
  OrderedPlaces best, other;
};

PathOrderWorkspace::PathOrderWorkspace() : memory_(std::make_unique<PathOrderMemory>()) {}
PathOrderWorkspace::~PathOrderWorkspace() = default;

namespace {

/// How far from a dead point the crank stays: beyond, rounding decides whether the linkage closes.
constexpr double kFromDeadPoint = 1e-10;

/// Enters the blocks of a stretch.
void enter(std::span<const Block> blocks, const Stretch& stretch, const Travel& travel,
           OrderedPlaces& places) {
  const std::size_t count = stretch.points.size();
  for (const Block& block : blocks) {
    PlaceInOrder place{HeldBy::nothing, travel.angle(block.at), places.blocks++, 0};
    if (!stretch.is_closed && block.at <= stretch.from) {
      place.held_by = stretch.at_start;
      place.timed_point = stretch.timed_before;
    } else if (!stretch.is_closed && block.at >= stretch.to) {
      place.held_by = stretch.at_end;
      place.timed_point = stretch.timed_after;
    }
    if (place.held_by == HeldBy::timed_point) {
      place.angle = places.of_point[place.timed_point].angle;
    }
    // A block across the seam of a closed stretch goes on at its beginning.
    for (std::size_t k = block.first;; k = (k + 1) % count) {
      places.of_point[stretch.points[k]] = place;
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

/// Fills `found` by the stretches of the motion in `own`; the cost is infinite where they cannot be
/// passed.
void place(const Motion& motion, PathOrderMemory& own, OrderedPlaces& found) {
  const std::size_t n = own.targets.size();
  found.of_point.assign(n, {});
  found.blocks = 0;
  found.cost = kInfinity;
  for (std::size_t k = 0; k < motion.timed.size(); ++k) {
    found.of_point[motion.timed[k]].angle = motion.travel.sense * own.timed_at[k];
  }
  for (Stretch& stretch : own.stretches) {
    if (stretch.points.empty()) continue;
    stretch.from = motion.travel.place(stretch.from);
    stretch.to = motion.travel.place(stretch.to);
    PathPlacing placing(motion.branch, motion.travel, stretch, own.targets, motion.weights,
                        own.placing);
    if (!placing.is_possible()) return;
    enter(motion.in_order ? placing.in_order() : placing.in_any_order(), stretch, motion.travel,
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

PathOrder::PathOrder(const PathProblem& scaled)
    : points_(scaled.points),
      weights_(scaled.weights),
      in_order_(scaled.order == PointOrder::cyclic && scaled.constraints.no_order_defect) {
  weights_.resize(points_.size(), 1.0);
  for (std::size_t j = 0; j < points_.size(); ++j) {
    if (scaled.is_timed(j)) timed_.push_back(j);
  }
  stretches_ = std::make_unique<PathStretches>(points_.size(), timed_, in_order_);
}

PathOrder::~PathOrder() = default;

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
    stretches_->round(own.timed_at, own.stretches);
    try_out({.sense = sense});
    return std::isfinite(own.best.cost) ? &own.best : nullptr;
  }
  for (const CrankRange& range : crank_ranges(links)) {
    const double half = 0.5 * (range.to - range.from);
    if (!(half > kFromDeadPoint)) continue;
    const double middle = sense * (range.from + half);
    const bool passes =
        stretches_->between(middle - half + kFromDeadPoint, middle + half - kFromDeadPoint,
                            own.timed_at, own.stretches);
    if (passes) try_out({sense, false, middle, half});
  }
  return std::isfinite(own.best.cost) ? &own.best : nullptr;
}

}  // namespace cognate::problems
