#include "problems/path_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "analysis/angle.hpp"
#include "analysis/mobility.hpp"
#include "problems/curve_branch.hpp"

namespace cognate::problems {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// How far from a dead point the crank stays: beyond, rounding decides whether the linkage closes.
constexpr double kFromDeadPoint = 1e-10;

/// Prescribed angles closer than this are one, to rounding.
constexpr double kSameAngle = 1e-9;

/// Consecutive points that share a place, as one of their weighted mean.
struct Block {
  double at = 0;  ///< along the motion
  Vec2d mean;
  double weight = 0;
  std::size_t first = 0, last = 0;  ///< of the points of its stretch
};

/// A part of the motion, and the points met there one after the other.
struct Stretch {
  double from = 0, to = 0;  ///< along the motion: `sense` times the crank angle
  HeldBy at_start = HeldBy::range_start, at_end = HeldBy::range_end;
  std::size_t timed_before = 0, timed_after = 0;
  bool is_closed = false;           ///< a whole turn that may begin anywhere
  std::vector<std::size_t> points;  ///< in the order in which they are met
};

/// The points of one stretch placed along a branch.
class Placing {
 public:
  Placing(const CurveBranch& branch, double sense, const Stretch& stretch,
          std::span<const Vec2d> targets, std::span<const double> weights)
      : branch_(branch), sense_(sense), stretch_(stretch), targets_(targets), weights_(weights) {
    samples_ = branch.samples(sense, stretch.from, stretch.to);
    // The last sample of a whole turn is its first again.
    if (stretch.is_closed && !samples_.empty()) samples_.pop_back();
  }

  bool is_possible() const { return !samples_.empty(); }

  std::vector<Block> in_order();
  std::vector<Block> in_any_order();

 private:
  struct Way {
    double cost = kInfinity;
    std::vector<std::size_t> at;  ///< sample of each point, counted on beyond the turn
  };

  const Vec2d& target(std::size_t k) const { return targets_[stretch_.points[k]]; }
  double weight(std::size_t k) const { return weights_[stretch_.points[k]]; }
  double place_of(std::size_t sample) const {
    return samples_[sample % samples_.size()].at + kTurn * double(sample / samples_.size());
  }
  Way best_way(std::size_t first, std::size_t starts, std::size_t count) const;
  Way best_way() const;
  void settle(Block& block) const;
  void merge(Block& into, const Block& next, double shift) const;
  void close(std::vector<Block>& blocks) const;

  const CurveBranch& branch_;
  double sense_;
  const Stretch& stretch_;
  std::span<const Vec2d> targets_;
  std::span<const double> weights_;
  std::vector<CurveSample> samples_;
};

/// The cheapest assignment of the points to `count` samples from `first` on, the first point within
/// the first `starts` of them, no point before the one before it.
Placing::Way Placing::best_way(std::size_t first, std::size_t starts, std::size_t count) const {
  const std::size_t n = stretch_.points.size(), m = samples_.size();
  std::vector<std::uint16_t> from(n * count);
  std::vector<double> cost(count), distance(m);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < m; ++i) {
      distance[i] = weight(k) * squared_norm(samples_[i].point - target(k));
    }
    std::uint16_t* source = from.data() + k * count;
    double least = k == 0 ? 0 : kInfinity;
    std::uint16_t where = 0;
    for (std::size_t i = 0, at = first % m; i < count; ++i, at = at + 1 < m ? at + 1 : 0) {
      if (k > 0 && cost[i] < least) {
        least = cost[i];
        where = static_cast<std::uint16_t>(i);
      }
      source[i] = where;
      cost[i] = k == 0 && i >= starts ? kInfinity : least + distance[at];
    }
  }
  const auto end = std::ranges::min_element(cost);
  Way way{*end, std::vector<std::size_t>(n)};
  auto i = static_cast<std::size_t>(end - cost.begin());
  for (std::size_t k = n; k-- > 0;) {
    way.at[k] = first + i;
    i = from[k * count + i];
  }
  return way;
}

/// Over a closed stretch the way may begin anywhere and goes round once at most. Where the best one
/// that may go farther does, the best of a few beginnings near its own ends is taken.
Placing::Way Placing::best_way() const {
  const std::size_t m = samples_.size();
  if (!stretch_.is_closed) return best_way(0, m, m);
  Way way = best_way(0, m, 2 * m);
  const std::size_t first = way.at.front(), last = way.at.back();
  if (last - first <= m) return way;
  Way best;
  for (const std::size_t begin : {first, (first + last + m) / 2, last}) {
    Way other = best_way(begin % m, m + 1, m + 1);
    if (other.cost < best.cost) best = std::move(other);
  }
  return best;
}

/// Brings a block to the nearest place downhill.
void Placing::settle(Block& block) const {
  const bool unlimited = stretch_.is_closed;
  block.at = branch_.nearest(sense_, block.mean, block.at, unlimited ? -kInfinity : stretch_.from,
                             unlimited ? kInfinity : stretch_.to);
}

/// `next`, `shift` beyond where it lies, joins the block before it.
void Placing::merge(Block& into, const Block& next, double shift) const {
  const double weight = into.weight + next.weight, share = next.weight / weight;
  into.mean = into.mean + share * (next.mean - into.mean);
  into.at += share * (next.at + shift - into.at);
  into.weight = weight;
  into.last = next.last;
  settle(into);
}

/// The last place is at most a turn beyond the first: else both are one block across the seam.
void Placing::close(std::vector<Block>& blocks) const {
  for (bool merged = true; merged && blocks.size() > 1;) {
    merged = false;
    if (blocks.back().at > blocks.front().at + kTurn) {
      Block joined = blocks.back();
      merge(joined, blocks.front(), kTurn);
      joined.at -= kTurn;
      blocks.pop_back();
      blocks.front() = joined;
      merged = true;
    } else if (blocks[0].at > blocks[1].at) {
      merge(blocks[0], blocks[1], 0);
      blocks.erase(blocks.begin() + 1);
      merged = true;
    }
  }
}

std::vector<Block> Placing::in_order() {
  const Way way = best_way();
  std::vector<Block> blocks;
  for (std::size_t k = 0; k < way.at.size(); ++k) {
    blocks.push_back({place_of(way.at[k]), target(k), weight(k), k, k});
    settle(blocks.back());
    while (blocks.size() > 1 && blocks[blocks.size() - 2].at > blocks.back().at) {
      const Block next = blocks.back();
      blocks.pop_back();
      merge(blocks.back(), next, 0);
    }
  }
  if (stretch_.is_closed) close(blocks);
  return blocks;
}

std::vector<Block> Placing::in_any_order() {
  std::vector<Block> blocks;
  for (std::size_t k = 0; k < stretch_.points.size(); ++k) {
    const auto nearest = std::ranges::min_element(samples_, {}, [&](const CurveSample& sample) {
      return squared_norm(sample.point - target(k));
    });
    blocks.push_back({nearest->at, target(k), weight(k), k, k});
    settle(blocks.back());
  }
  return blocks;
}

/// The stretches of a motion within `range` of the crank (from the frame, along the motion), where
/// `timed` points lie at `angles`. Empty where they cannot be passed in order.
class Stretches {
 public:
  Stretches(std::size_t points, std::span<const std::size_t> timed,
            std::span<const double> timed_at, bool in_order)
      : points_(points), timed_(timed), at_(timed_at), in_order_(in_order) {}

  /// Of a crank that turns fully.
  std::vector<Stretch> round() const {
    if (timed_.empty() || !in_order_) {
      return {{.from = 0, .to = kTurn, .is_closed = true, .points = untimed(0, points_)}};
    }
    std::vector<Stretch> all;
    for (std::size_t k = 0; k < timed_.size(); ++k) {
      const std::size_t next = (k + 1) % timed_.size();
      Stretch stretch{.from = at_[k],
                      .to = at_[k] + step(at_[k], at_[next]),
                      .at_start = HeldBy::timed_point,
                      .at_end = HeldBy::timed_point,
                      .timed_before = timed_[k],
                      .timed_after = timed_[next]};
      for (std::size_t j = timed_[k] + 1; j % points_ != timed_[next]; ++j) {
        stretch.points.push_back(j % points_);
      }
      all.push_back(std::move(stretch));
    }
    // Where the last timed point repeats the first, the turn lies between those with the most
    // points.
    const auto has_step = [](const Stretch& stretch) { return stretch.to > stretch.from; };
    if (std::ranges::none_of(all, has_step)) {
      auto& whole = *std::ranges::max_element(
          all, {}, [](const Stretch& stretch) { return stretch.points.size(); });
      whole.to = whole.from + kTurn;
    }
    return all;
  }

  /// Of one that turns from `from` to `to` only.
  std::optional<std::vector<Stretch>> between(double from, double to) const {
    std::vector<double> places;
    for (const double at : at_) {
      double place = from + in_one_turn(at - from);
      if (place > to) return std::nullopt;
      if (in_order_ && !places.empty()) {
        if (place < places.back() - kSameAngle) return std::nullopt;
        place = std::max(place, places.back());
      }
      places.push_back(place);
    }
    if (timed_.empty() || !in_order_) {
      return std::vector<Stretch>{{.from = from, .to = to, .points = untimed(0, points_)}};
    }
    std::vector<Stretch> all;
    for (std::size_t k = 0; k <= timed_.size(); ++k) {
      Stretch stretch{.from = from, .to = to};
      if (k > 0) {
        stretch.from = places[k - 1];
        stretch.at_start = HeldBy::timed_point;
        stretch.timed_before = timed_[k - 1];
      }
      if (k < timed_.size()) {
        stretch.to = places[k];
        stretch.at_end = HeldBy::timed_point;
        stretch.timed_after = timed_[k];
      }
      stretch.points =
          untimed(k > 0 ? timed_[k - 1] + 1 : 0, k < timed_.size() ? timed_[k] : points_);
      all.push_back(std::move(stretch));
    }
    return all;
  }

 private:
  std::vector<std::size_t> untimed(std::size_t from, std::size_t to) const {
    std::vector<std::size_t> all;
    for (std::size_t j = from; j < to; ++j) {
      if (std::ranges::find(timed_, j) == timed_.end()) all.push_back(j);
    }
    return all;
  }

  /// From one angle forward to another; angles that are equal but for rounding have none between.
  static double step(double from, double to) {
    const double forward = in_one_turn(to - from);
    return forward < kSameAngle || forward > kTurn - kSameAngle ? 0 : forward;
  }

  std::size_t points_;
  std::span<const std::size_t> timed_;
  std::span<const double> at_;
  bool in_order_;
};

/// Enters the blocks of a stretch.
void enter(const std::vector<Block>& blocks, const Stretch& stretch, double sense,
           OrderedPlaces& places) {
  const std::size_t count = stretch.points.size();
  for (const Block& block : blocks) {
    PlaceInOrder place{HeldBy::nothing, sense * block.at, places.blocks++, 0};
    if (!stretch.is_closed && block.at <= stretch.from) {
      place.held_by = stretch.at_start;
      place.timed_point = stretch.timed_before;
    } else if (!stretch.is_closed && block.at >= stretch.to) {
      place.held_by = stretch.at_end;
      place.timed_point = stretch.timed_after;
    }
    // The range of the crank is counted counter-clockwise.
    if (sense < 0 && place.held_by == HeldBy::range_start) {
      place.held_by = HeldBy::range_end;
    } else if (sense < 0 && place.held_by == HeldBy::range_end) {
      place.held_by = HeldBy::range_start;
    }
    // A block across the seam of a closed stretch goes on at its beginning.
    for (std::size_t k = block.first;; k = (k + 1) % count) {
      places.of_point[stretch.points[k]] = place;
      if (k == block.last) break;
    }
  }
}

}  // namespace

bool assigns_places(const PathProblem& problem) {
  const Constraints& constraints = problem.constraints;
  return problem.timing != Timing::prescribed &&
         (constraints.no_order_defect || constraints.no_circuit_defect);
}

PathOrder::PathOrder(const PathProblem& scaled)
    : points_(scaled.points),
      weights_(scaled.weights),
      in_order_(scaled.order == PointOrder::cyclic && scaled.constraints.no_order_defect) {
  weights_.resize(points_.size(), 1.0);
  for (std::size_t j = 0; j < points_.size(); ++j) {
    if (scaled.is_timed(j)) timed_.push_back(j);
  }
}

std::optional<OrderedPlaces> PathOrder::places(const FourBar& linkage,
                                               std::span<const double> crank_angles,
                                               bool clockwise) const {
  const CurveBranch branch(linkage);
  const double sense = clockwise ? -1 : 1, direction = frame_angle(linkage);
  std::vector<Vec2d> targets;
  for (const Vec2d& point : points_) targets.push_back(branch.in_frame(point));
  std::vector<double> timed_at;
  for (const std::size_t j : timed_) timed_at.push_back(sense * (crank_angles[j] - direction));
  const Stretches stretches(points_.size(), timed_, timed_at, in_order_);

  std::optional<OrderedPlaces> best;
  const auto try_out = [&](const std::vector<Stretch>& all) {
    OrderedPlaces found{std::vector<PlaceInOrder>(points_.size()), 0, 0};
    for (std::size_t k = 0; k < timed_.size(); ++k) {
      found.of_point[timed_[k]].angle = sense * timed_at[k];
    }
    for (const Stretch& stretch : all) {
      if (stretch.points.empty()) continue;
      Placing placing(branch, sense, stretch, targets, weights_);
      if (!placing.is_possible()) return;
      enter(in_order_ ? placing.in_order() : placing.in_any_order(), stretch, sense, found);
    }
    for (std::size_t j = 0; j < points_.size(); ++j) {
      const auto point = branch.point(found.of_point[j].angle);
      found.cost += point ? weights_[j] * squared_norm(*point - targets[j]) : kInfinity;
    }
    if (std::isfinite(found.cost) && (!best || found.cost < best->cost)) best = std::move(found);
  };
  const Lengths<double> links = lengths(linkage);
  if (crank_rotates(links)) {
    try_out(stretches.round());
    return best;
  }
  for (const CrankRange& range : crank_ranges(links)) {
    const double from = range.from + kFromDeadPoint, to = range.to - kFromDeadPoint;
    if (!(from < to)) continue;
    const auto all = sense > 0 ? stretches.between(from, to) : stretches.between(-to, -from);
    if (all) try_out(*all);
  }
  return best;
}

}  // namespace cognate::problems
