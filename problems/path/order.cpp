#include "problems/path/order.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/path/curve_branch.hpp"

namespace cognate::problems {
namespace {

/// How far from a dead point the crank stays: beyond, rounding decides whether the linkage closes.
constexpr double kFromDeadPoint = 1e-10;

/// Prescribed angles closer than this are one, to rounding.
constexpr double kSameAngle = 1e-9;

/// Over a turn, from how many samples ways are tried where one turn is too little for the best.
constexpr std::size_t kBeginnings = 24;

/// Consecutive points that share a place, as one of their weighted mean.
struct Block {
  double at = 0;  ///< along the motion
  Vec2d mean;
  double weight = 0;
  std::size_t first = 0, last = 0;  ///< of the points of its stretch
  double from = 0, to = 0;          ///< between which places it is looked for
};

/// A part of the motion, and the points met there one after the other.
struct Stretch {
  double from = 0, to = 0;  ///< along the motion: `sense` times the crank angle
  HeldBy at_start = HeldBy::range_end, at_end = HeldBy::range_end;
  std::size_t timed_before = 0, timed_after = 0;
  bool is_closed = false;           ///< a whole turn that may begin anywhere
  std::vector<std::size_t> points;  ///< in the order in which they are met
};

/// The points of one stretch placed along a branch.
class Placing {
 public:
  Placing(const CurveBranch& branch, const Travel& travel, const Stretch& stretch,
          std::span<const Vec2d> targets, std::span<const double> weights)
      : branch_(branch), travel_(travel), stretch_(stretch), targets_(targets), weights_(weights) {
    samples_ = branch.samples(travel, stretch.from, stretch.to);
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
    std::size_t begin = 0;        ///< the sample from which they are counted
  };

  const Vec2d& target(std::size_t k) const { return targets_[stretch_.points[k]]; }
  double weight(std::size_t k) const { return weights_[stretch_.points[k]]; }
  double place_of(std::size_t sample) const {
    const std::size_t whole_turns = sample / samples_.size();
    return samples_[sample % samples_.size()].at + kTurn * double(whole_turns);
  }
  Way best_way(std::size_t first, std::size_t starts, std::size_t count) const;
  Way best_way() const;
  void settle(Block& block) const;
  Block settled(std::size_t sample, std::size_t k) const;
  void merge(Block& into, const Block& next, double shift) const;
  void close(std::vector<Block>& blocks) const;
  void release(std::vector<Block>& blocks) const;

  const CurveBranch& branch_;
  const Travel& travel_;
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
  Way way{*end, std::vector<std::size_t>(n), first};
  auto i = static_cast<std::size_t>(end - cost.begin());
  for (std::size_t k = n; k-- > 0;) {
    way.at[k] = first + i;
    i = from[k * count + i];
  }
  return way;
}

/// Over a closed stretch the way may begin anywhere and goes round once at most. Where the best one
/// that may go farther does so, beginnings are tried in even steps and about the best of them.
Placing::Way Placing::best_way() const {
  const std::size_t m = samples_.size();
  if (!stretch_.is_closed) return best_way(0, m, m);
  Way best = best_way(0, m, 2 * m);
  if (best.at.back() - best.at.front() <= m) return best;
  best.cost = kInfinity;
  const auto begin_at = [&](std::size_t begin) {
    Way other = best_way(begin % m, m + 1, m + 1);
    if (other.cost < best.cost) best = std::move(other);
  };
  std::size_t step = m / kBeginnings + 1;
  for (std::size_t begin = 0; begin < m; begin += step) begin_at(begin);
  for (; step > 1; step = (step + 1) / 2) {
    const std::size_t middle = best.begin;
    begin_at(middle + step / 2);
    begin_at(middle + m - step / 2);
  }
  return best;
}

/// Brings a block to the nearest place downhill.
void Placing::settle(Block& block) const {
  block.at = branch_.nearest(travel_, block.mean, block.at, block.from, block.to);
}

/// A point at a sample, where it settles no farther than the neighbours of that.
Block Placing::settled(std::size_t sample, std::size_t k) const {
  const bool closed = stretch_.is_closed;
  const std::size_t last = samples_.size() - 1;
  const double from = closed       ? place_of(sample + last) - kTurn
                      : sample > 0 ? place_of(sample - 1)
                                   : stretch_.from;
  const double to = closed || sample < last ? place_of(sample + 1) : stretch_.to;
  Block block{place_of(sample), target(k), weight(k), k, k, from, to};
  settle(block);
  return block;
}

/// `next`, `shift` beyond where it lies, joins the block before it.
void Placing::merge(Block& into, const Block& next, double shift) const {
  const double weight = into.weight + next.weight, share = next.weight / weight;
  into.mean = into.mean + share * (next.mean - into.mean);
  into.at += share * (next.at + shift - into.at);
  into.weight = weight;
  into.last = next.last;
  into.from = std::min(into.from, next.from + shift);
  into.to = std::max(into.to, next.to + shift);
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
      joined.from -= kTurn;
      joined.to -= kTurn;
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

/// Where a block wants to go farther than it was looked for, it does as far as its neighbours let
/// it.
void Placing::release(std::vector<Block>& blocks) const {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    Block& block = blocks[i];
    if (block.at > block.from && block.at < block.to) continue;
    const double before = i > 0                ? blocks[i - 1].at
                          : stretch_.is_closed ? blocks.back().at - kTurn
                                               : stretch_.from;
    const double after = i + 1 < blocks.size() ? blocks[i + 1].at
                         : stretch_.is_closed  ? blocks.front().at + kTurn
                                               : stretch_.to;
    block.at = branch_.nearest(travel_, block.mean, block.at, before, after);
  }
}

std::vector<Block> Placing::in_order() {
  const Way way = best_way();
  std::vector<Block> blocks;
  for (std::size_t k = 0; k < way.at.size(); ++k) {
    blocks.push_back(settled(way.at[k], k));
    while (blocks.size() > 1 && blocks[blocks.size() - 2].at > blocks.back().at) {
      const Block next = blocks.back();
      blocks.pop_back();
      merge(blocks.back(), next, 0);
    }
  }
  if (stretch_.is_closed) close(blocks);
  release(blocks);
  return blocks;
}

/// Down from every sample that is nearer than its neighbours and from which the curve may come
/// nearer than the best so far.
std::vector<Block> Placing::in_any_order() {
  std::vector<Block> blocks;
  const std::size_t m = samples_.size();
  std::vector<double> distance(m), chord(m);  // from each sample to the next
  for (std::size_t i = 0; i < m; ++i)
    chord[i] = norm(samples_[(i + 1) % m].point - samples_[i].point);
  for (std::size_t k = 0; k < stretch_.points.size(); ++k) {
    for (std::size_t i = 0; i < m; ++i) distance[i] = norm(samples_[i].point - target(k));
    const auto nearest =
        static_cast<std::size_t>(std::ranges::min_element(distance) - distance.begin());
    Block best = settled(nearest, k);
    double least = branch_.distance(travel_.angle(best.at), target(k));
    for (std::size_t i = 0; i < m; ++i) {
      const std::size_t before = (i + m - 1) % m, after = (i + 1) % m;
      if (i == nearest || distance[i] > distance[before] || distance[i] > distance[after]) continue;
      if (distance[i] - std::max(chord[before], chord[i]) >= least) continue;
      const Block other = settled(i, k);
      const double there = branch_.distance(travel_.angle(other.at), target(k));
      if (there >= least) continue;
      best = other;
      least = there;
    }
    blocks.push_back(best);
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
void enter(const std::vector<Block>& blocks, const Stretch& stretch, const Travel& travel,
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
  const auto try_out = [&](const Travel& travel, std::vector<Stretch> all) {
    OrderedPlaces found{std::vector<PlaceInOrder>(points_.size()), 0, 0};
    for (std::size_t k = 0; k < timed_.size(); ++k) {
      found.of_point[timed_[k]].angle = sense * timed_at[k];
    }
    for (Stretch& stretch : all) {
      if (stretch.points.empty()) continue;
      stretch.from = travel.place(stretch.from);
      stretch.to = travel.place(stretch.to);
      Placing placing(branch, travel, stretch, targets, weights_);
      if (!placing.is_possible()) return;
      enter(in_order_ ? placing.in_order() : placing.in_any_order(), stretch, travel, found);
    }
    for (std::size_t j = 0; j < points_.size(); ++j) {
      const auto point = branch.point(found.of_point[j].angle);
      found.cost += point ? weights_[j] * squared_norm(*point - targets[j]) : kInfinity;
    }
    if (std::isfinite(found.cost) && (!best || found.cost < best->cost)) best = std::move(found);
  };
  const Lengths<double> links = lengths(linkage);
  if (crank_rotates(links)) {
    try_out({.sense = sense}, stretches.round());
    return best;
  }
  for (const CrankRange& range : crank_ranges(links)) {
    const double half = 0.5 * (range.to - range.from);
    if (!(half > kFromDeadPoint)) continue;
    const double middle = sense * (range.from + half);
    auto all = stretches.between(middle - half + kFromDeadPoint, middle + half - kFromDeadPoint);
    if (all) try_out({sense, false, middle, half}, std::move(*all));
  }
  return best;
}

}  // namespace cognate::problems
