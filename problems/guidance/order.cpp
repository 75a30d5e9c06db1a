#include "problems/guidance/order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/guidance/closure.hpp"

namespace cognate::problems {
namespace {

using synthesis::Pose;

/// Angles beside those of the stations.
constexpr int kSpread = 48;
/// Of a long list at most so many angles of stations are looked at, in even steps, and fewer where
/// the errors of all poses at all of them would be more than so many.
constexpr std::size_t kMostAngles = 600, kFewestAngles = 60, kMostErrors = 3'000'000;
/// Of a crank that turns fully: how many angles are tried for the first station.
constexpr std::size_t kBeginnings = 8;
/// Of the sum of all slopes of a station: less is what an unfinished refinement leaves.
constexpr double kLeastMultiplier = 1e-6;

/// A crank angle and how far each station is then from its poses.
struct Level {
  double angle = 0;
  std::vector<double> cost;
};

/// An angle for each station, and the sum of squares.
struct Assignment {
  std::vector<double> angles;
  double cost = kInfinity;
};

double squared_error(const Pose& a, const Pose& b, double weight) {
  const double turned = weight * std::remainder(a.angle - b.angle, kTurn);
  return squared_norm(a.at - b.at) + turned * turned;
}

class Ordering {
 public:
  Ordering(const MotionProblem& problem, const OrderedMotion& motion)
      : problem_(problem),
        motion_(motion),
        model_(problem, motion.form),
        stations_(model_.station_count()),
        angles_(model_.station_angles(motion.x)) {}

  std::optional<OrderedMotion> find() {
    const auto& sides = motion_.form.sides;
    if (std::ranges::count(sides, sides.front()) != std::ssize(sides)) return std::nullopt;
    const DyadPair pair = model_.pair(motion_.x);
    const auto arcs = closing_arcs(pair.second.kind, pair.first, second_dyad(pair.second));
    const bool has_ends = !motion_.form.stations.empty() || !model_.limits_driven_range();
    if (has_ends && is_kept(arcs)) return std::nullopt;
    for (const CrankRange& arc : arcs) try_arc(arc);
    if (best_.cost == kInfinity) return std::nullopt;
    return taken();
  }

 private:
  static bool is_whole(const CrankRange& arc) { return arc.to - arc.from >= kTurn; }

  /// Whether the angles are on one circuit, and in order if that is demanded.
  bool is_kept(const std::vector<CrankRange>& arcs) const {
    return std::ranges::any_of(arcs, [&](const CrankRange& arc) {
      std::vector<double> along;
      for (const double angle : angles_) along.push_back(in_one_turn(angle - arc.from));
      const double greatest = *std::ranges::max_element(along);
      if (greatest > arc.to - arc.from) return false;
      if (!problem_.constraints.no_order_defect) return has_extreme_ends(along);
      if (!is_whole(arc)) {
        return std::ranges::is_sorted(along) || std::ranges::is_sorted(along, std::greater{});
      }
      return turns_once(along, 1) || turns_once(along, -1);
    });
  }

  /// Whether the ends of the form, if the motion needs any, are the stations furthest apart.
  bool has_extreme_ends(const std::vector<double>& along) const {
    if (!model_.limits_driven_range()) return true;
    return motion_.form.ends == extremes(along);
  }

  static std::pair<std::size_t, std::size_t> extremes(const std::vector<double>& along) {
    const auto [least, greatest] = std::ranges::minmax_element(along);
    return {static_cast<std::size_t>(least - along.begin()),
            static_cast<std::size_t>(greatest - along.begin())};
  }

  static bool turns_once(const std::vector<double>& along, double sense) {
    double way = 0;
    for (std::size_t i = 1; i < along.size(); ++i) {
      way += in_one_turn(sense * (along[i] - along[i - 1]));
    }
    return way <= kTurn;
  }

  /// At most as many as a long list allows.
  std::vector<double> coarsened(std::vector<double> angles) const {
    const std::size_t most =
        std::clamp(kMostErrors / problem_.poses.size(), kFewestAngles, kMostAngles);
    if (angles.size() <= most) return angles;
    std::ranges::sort(angles);
    std::vector<double> kept;
    for (std::size_t k = 0; k < most; ++k) {
      kept.push_back(angles[k * (angles.size() - 1) / (most - 1)]);
    }
    return kept;
  }

  /// The angles in `arc` that may be taken, in ascending order.
  void list_levels(const CrankRange& arc) {
    std::vector<double> angles;
    const double span = arc.to - arc.from;
    for (const double angle : angles_) {
      const double along = in_one_turn(angle - arc.from);
      if (along <= span) angles.push_back(arc.from + along);
    }
    angles = coarsened(std::move(angles));
    for (int k = 0; k < kSpread; ++k) angles.push_back(arc.from + span * (k + 0.5) / kSpread);
    std::ranges::sort(angles);
    levels_.clear();
    for (const double angle : angles) {
      const auto body = model_.body_at(motion_.x, angle);
      if (!body) continue;
      Level level{angle, std::vector<double>(stations_, 0.0)};
      for (std::size_t j = 0; j < problem_.poses.size(); ++j) {
        level.cost[model_.station_of(j)] +=
            squared_error(*body, problem_.poses[j], problem_.angle_weight);
      }
      levels_.push_back(std::move(level));
    }
  }

  void try_arc(const CrankRange& arc) {
    list_levels(arc);
    if (levels_.empty()) return;
    std::vector<std::size_t> row(levels_.size());
    std::iota(row.begin(), row.end(), std::size_t{0});
    if (!problem_.constraints.no_order_defect) return take_nearest();
    if (!is_whole(arc)) {
      take_in_order(row);
      std::ranges::reverse(row);
      return take_in_order(row);
    }
    std::vector<std::size_t> beginnings = row;
    std::ranges::stable_sort(beginnings, {}, [&](std::size_t k) { return levels_[k].cost[0]; });
    if (beginnings.size() > kBeginnings) beginnings.resize(kBeginnings);
    for (const std::size_t first : beginnings) {
      std::vector<std::size_t> round = row;
      std::ranges::rotate(round, round.begin() + static_cast<std::ptrdiff_t>(first));
      round.push_back(first);  // once round
      take_in_order(round);
      std::ranges::reverse(round);
      take_in_order(round);
    }
  }

  /// For each station the nearest level.
  void take_nearest() {
    Assignment found{{}, 0};
    for (std::size_t i = 0; i < stations_; ++i) {
      const auto best =
          std::ranges::min_element(levels_, {}, [&](const Level& level) { return level.cost[i]; });
      found.angles.push_back(best->angle);
      found.cost += best->cost[i];
    }
    if (found.cost < best_.cost) best_ = std::move(found);
  }

  /// The cheapest levels that come one after another, or again, in `row`: dynamic programming.
  void take_in_order(const std::vector<std::size_t>& row) {
    const std::size_t count = row.size();
    std::vector<double> sum(count, 0.0);
    std::vector<std::size_t> from(stations_ * count);
    for (std::size_t i = 0; i < stations_; ++i) {
      double least = kInfinity;
      std::size_t best = 0;
      for (std::size_t k = 0; k < count; ++k) {
        if (sum[k] < least) {
          least = sum[k];
          best = k;
        }
        from[i * count + k] = best;
        sum[k] = least + levels_[row[k]].cost[i];
      }
    }
    const auto last = std::ranges::min_element(sum);
    if (!(*last < best_.cost)) return;
    best_ = {std::vector<double>(stations_), *last};
    auto k = static_cast<std::size_t>(last - sum.begin());
    for (std::size_t i = stations_; i-- > 0;) {
      best_.angles[i] = levels_[row[k]].angle;
      k = from[i * count + k];
    }
  }

  /// The form in which stations of one angle are one.
  OrderedMotion taken() const {
    std::vector<int> merged(stations_);
    std::vector<double> angles;
    const bool pools = problem_.constraints.no_order_defect;
    for (std::size_t i = 0; i < stations_; ++i) {
      const auto& taken = best_.angles;
      const bool joins_last = pools && i > 0 && taken[i] == taken[i - 1];
      const bool joins_first = pools && i > 0 && taken[i] == taken[0];
      if (joins_last || joins_first) {
        merged[i] = joins_last ? merged[i - 1] : 0;
        continue;
      }
      merged[i] = static_cast<int>(angles.size());
      angles.push_back(taken[i]);
    }
    OrderedMotion ordered{motion_.form, motion_.x};
    ordered.form.stations.clear();
    ordered.form.held.clear();
    for (std::size_t j = 0; j < problem_.poses.size(); ++j) {
      ordered.form.stations.push_back(merged[model_.station_of(j)]);
    }
    if (!pools && model_.limits_driven_range()) ordered.form.ends = extremes(angles);
    ordered.x = MotionModel(problem_, ordered.form).with_angles(motion_.x, angles);
    return ordered;
  }

  const MotionProblem& problem_;
  const OrderedMotion& motion_;
  MotionModel model_;
  std::size_t stations_;
  std::vector<double> angles_;
  std::vector<Level> levels_;  ///< of the arc that is tried
  Assignment best_;
};

/// Parts stations of a motion in order.
class Parting {
 public:
  Parting(const MotionProblem& problem, const OrderedMotion& motion)
      : motion_(motion),
        model_(problem, motion.form),
        angles_(model_.station_angles(motion.x)),
        slopes_(model_.angle_slopes(motion.x)),
        problem_(problem) {}

  std::optional<OrderedMotion> part() {
    if (slopes_.empty() || model_.station_count() < 2) return std::nullopt;
    const auto poses = in_blocks();
    const double sense = turns_forward() ? 1 : -1;
    std::vector<int> stations(poses.size());
    std::vector<double> angles;
    for (std::size_t from = 0; from < poses.size();) {
      std::size_t to = from;
      while (to < poses.size() && station(poses[to]) == station(poses[from])) ++to;
      const std::size_t cut = cut_of({poses.data() + from, to - from}, sense);
      for (std::size_t i = from; i < to; ++i) {
        if (i == from || i == from + cut) angles.push_back(angles_[station(poses[i])]);
        stations[poses[i]] = static_cast<int>(angles.size()) - 1;
      }
      from = to;
    }
    if (angles.size() == model_.station_count()) return std::nullopt;
    OrderedMotion parted{motion_.form, {}};
    parted.form.stations = std::move(stations);
    parted.form.held.clear();
    parted.x = MotionModel(problem_, parted.form).with_angles(motion_.x, angles);
    return parted;
  }

 private:
  std::size_t station(std::size_t pose) const { return model_.station_of(pose); }

  /// The poses from the first of a station on, so that those of a station are neighbours: once
  /// round, the last poses may share the station of the first.
  std::vector<std::size_t> in_blocks() const {
    std::vector<std::size_t> poses(slopes_.size());
    std::iota(poses.begin(), poses.end(), std::size_t{0});
    if (station(0) != station(poses.size() - 1)) return poses;
    auto first = poses.end() - 1;
    while (station(*(first - 1)) == station(0)) --first;
    std::ranges::rotate(poses, first);
    return poses;
  }

  bool turns_forward() const {
    double way = 0;
    for (std::size_t i = 1; i < angles_.size(); ++i)
      way += in_one_turn(angles_[i] - angles_[i - 1]);
    return way <= kTurn;
  }

  /// Before which pose of a block it is to be parted; 0: nowhere. The ends of the motion may be
  /// held by limits, so that of their slopes only those of the other poses are counted.
  std::size_t cut_of(std::span<const std::size_t> block, double sense) const {
    double all = 0, sum = 0, size = 0;
    for (const std::size_t pose : block) {
      all += slopes_[pose];
      size += std::abs(slopes_[pose]);
    }
    const bool holds_first = block.front() == 0;
    double greatest = kLeastMultiplier * size;
    std::size_t cut = 0;
    for (std::size_t i = 0; i + 1 < block.size(); ++i) {
      sum += slopes_[block[i]];
      const double multiplier = sense * (holds_first ? sum - all : sum);
      if (multiplier <= greatest) continue;
      greatest = multiplier;
      cut = i + 1;
    }
    return cut;
  }

  const OrderedMotion& motion_;
  MotionModel model_;
  std::vector<double> angles_, slopes_;
  const MotionProblem& problem_;
};

}  // namespace

std::optional<OrderedMotion> parted(const MotionProblem& scaled, const OrderedMotion& motion) {
  if (motion.form.stations.empty() || !scaled.constraints.no_order_defect) return std::nullopt;
  return Parting(scaled, motion).part();
}

std::optional<OrderedMotion> in_order(const MotionProblem& scaled, const OrderedMotion& motion) {
  return Ordering(scaled, motion).find();
}

}  // namespace cognate::problems
