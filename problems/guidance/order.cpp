#include "problems/guidance/order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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
      if (!problem_.constraints.no_order_defect) return true;
      if (!is_whole(arc)) {
        return std::ranges::is_sorted(along) || std::ranges::is_sorted(along, std::greater{});
      }
      return turns_once(along, 1) || turns_once(along, -1);
    });
  }

  static bool turns_once(const std::vector<double>& along, double sense) {
    double way = 0;
    for (std::size_t i = 1; i < along.size(); ++i) {
      way += in_one_turn(sense * (along[i] - along[i - 1]));
    }
    return way <= kTurn;
  }

  /// At most as many as a long list allows.
  std::vector<double> thinned(std::vector<double> angles) const {
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
    angles = thinned(std::move(angles));
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
    for (std::size_t j = 0; j < problem_.poses.size(); ++j) {
      ordered.form.stations.push_back(merged[model_.station_of(j)]);
    }
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

}  // namespace

std::optional<OrderedMotion> in_order(const MotionProblem& scaled, const OrderedMotion& motion) {
  return Ordering(scaled, motion).find();
}

}  // namespace cognate::problems
