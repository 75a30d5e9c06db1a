#include "problems/path/placing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

/// Over a turn, from how many samples ways are tried where one turn is too little for the best.
constexpr std::size_t kBeginnings = 24;

}  // namespace

PathPlacing::PathPlacing(const CurveBranch& branch, const Travel& travel,
                         const OrderInterval& interval, std::span<const Vec2d> targets,
                         std::span<const double> weights, PlacingWorkspace& workspace)
    : branch_(branch),
      travel_(travel),
      stretch_(interval),
      targets_(targets),
      weights_(weights),
      own_(workspace),
      samples_(workspace.samples) {
  branch.sample(travel, interval.from, interval.to, samples_, workspace.finer);
  // The last sample of a whole turn is its first again.
  if (interval.is_closed && !samples_.empty()) samples_.pop_back();
}

/// The cheapest assignment of the points to `count` samples from `first` on, the first point within
/// the first `starts` of them, no point before the one before it.
void PathPlacing::find_way(std::size_t first, std::size_t starts, std::size_t count,
                           PlacingWay& way) const {
  const std::size_t n = stretch_.points.size(), m = samples_.size();
  std::vector<std::uint16_t>& from = own_.source;
  std::vector<double>&cost = own_.cost, &distance = own_.distance;
  from.resize(n * count);
  cost.assign(count, 0);
  distance.resize(m);
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
  way.cost = *end;
  way.begin = first;
  way.at.resize(n);
  auto i = static_cast<std::size_t>(end - cost.begin());
  for (std::size_t k = n; k-- > 0;) {
    way.at[k] = first + i;
    i = from[k * count + i];
  }
}

/// Over a closed interval the way may begin anywhere and goes round once at most. Where the best
/// one that may go farther does so, beginnings are tried in even steps and about the best of them.
const PlacingWay& PathPlacing::best_way() const {
  const std::size_t m = samples_.size();
  PlacingWay &best = own_.way, &other = own_.other;
  if (!stretch_.is_closed) {
    find_way(0, m, m, best);
    return best;
  }
  find_way(0, m, 2 * m, best);
  if (best.at.back() - best.at.front() <= m) return best;
  best.cost = kInfinity;
  const auto begin_at = [&](std::size_t begin) {
    find_way(begin % m, m + 1, m + 1, other);
    if (other.cost < best.cost) std::swap(best, other);
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
void PathPlacing::settle(Block& block) const {
  block.at = branch_.nearest(travel_, block.mean, block.at, block.from, block.to);
}

/// A point at a sample, where it settles no farther than the neighbours of that.
Block PathPlacing::settled(std::size_t sample, std::size_t k) const {
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
void PathPlacing::merge(Block& into, const Block& next, double shift) const {
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
void PathPlacing::close(std::vector<Block>& blocks) const {
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
void PathPlacing::release(std::vector<Block>& blocks) const {
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

std::span<const Block> PathPlacing::in_order() {
  const PlacingWay& way = best_way();
  std::vector<Block>& blocks = own_.blocks;
  blocks.clear();
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
std::span<const Block> PathPlacing::in_any_order() {
  std::vector<Block>& blocks = own_.blocks;
  blocks.clear();
  const std::size_t m = samples_.size();
  std::vector<double>&distance = own_.distance, &chord = own_.chord;
  distance.resize(m);
  chord.resize(m);  // from each sample to the next
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

}  // namespace cognate::problems
