#include "analysis/mechanism/gait.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate {
namespace {

constexpr int kTurnSamples = 720, kStanceSamples = 720, kSpeedSteps = 40;
/// Of the step height: levels that differ by less are one.
constexpr double kSameLevel = 1e-12;
/// Of the step height, or of a stride: stances that differ by less are equally good.
constexpr double kTie = 1e-9;
/// Radians: parts of the turn whose lengths differ by less are equal.
constexpr double kSameAngle = 1e-9;
/// Of the distance of the path from the origin: an extent up to this is rounding.
constexpr double kNoExtent = 1e-12;

/// The zero of `f` between a and b where its sign differs at these.
template <class Function>
double zero_between(const Function& f, double a, double at_a, double b, double at_b) {
  if (at_a == 0) return a;
  if (at_b == 0) return b;
  const auto [low, high] = bracket_zero(f, a, at_a, b, at_b);
  return 0.5 * (low + high);
}

struct Knot {
  double crank = 0, level = 0;
  bool is_peak = false;  ///< a maximum of the level
};

/// The level of a foot over the turn: monotone between neighbouring knots.
class Levels {
 public:
  explicit Levels(const FootPath& path) : path_(path) {
    FootState before = path(0);
    for (int i = 0; i < kTurnSamples; ++i) {
      const double from = kTurn * i / kTurnSamples, to = kTurn * (i + 1) / kTurnSamples;
      const FootState after = path(to);
      add(from, before.at, false);
      add_extreme(from, before.rate.y, to, after.rate.y);
      before = after;
    }
    const auto [low, high] = std::ranges::minmax(knots_, {}, &Knot::level);
    ground_ = low.level;
    height_ = high.level - low.level;
  }

  bool is_known() const { return is_finite_ && height_ > kNoExtent * size_; }
  double ground() const { return ground_; }
  double height() const { return height_; }

  /// Where the longest part begins in which the level is at most `most` above the ground, and how
  /// long it is.
  std::pair<double, double> longest_below(double most) const {
    const double limit = ground_ + most + kSameLevel * height_;
    const auto is_below = [&](std::size_t i) { return knot(i).level <= limit; };
    std::pair<double, double> longest{0, 0};
    for (std::size_t i = 0; i < knots_.size(); ++i) {
      if (is_below(i) || !is_below(i + 1)) continue;
      std::size_t end = i + 1;
      while (is_below(end + 1)) ++end;
      const double from = crossing(i, limit), length = crossing(end, limit) - from;
      if (length > longest.second + kSameAngle) longest = {from, length};
    }
    return longest;
  }

  /// Where the parts of the turn of this length begin that have the least highest level and both
  /// ends of one level, the least of such: several only where these are equal.
  std::vector<double> lowest_parts(double length) const {
    std::vector<Part> parts;
    for (const double from : level_parts(length)) {
      const double ends = std::max(level(from), level(from + length));
      parts.push_back({from, highest(from, length), ends});
    }
    keep_least(parts, &Part::top);
    keep_least(parts, &Part::ends);
    std::vector<double> from;
    for (const Part& one : parts) from.push_back(one.from);
    return from;
  }

  /// The highest level from `from` on.
  double highest(double from, double length) const {
    double most = std::max(level(from), level(from + length));
    for (const Knot& one : knots_) {
      if (one.is_peak && in_one_turn(one.crank - from) <= length) most = std::max(most, one.level);
    }
    return most;
  }

 private:
  struct Part {
    double from, top, ends;  ///< crank angle, highest level, level of the ends
  };

  double level(double crank) const { return path_(crank).at.y; }

  void keep_least(std::vector<Part>& parts, double Part::*value) const {
    if (parts.empty()) return;
    const double least = std::ranges::min(parts, {}, value).*value;
    std::erase_if(parts, [&](const Part& one) { return one.*value > least + kTie * height_; });
  }

  /// Where the parts of the turn of this length begin whose ends have one level, from the crank
  /// angle 0 on. Between extremes of the difference too, so that none depends on the samples.
  std::vector<double> level_parts(double length) const {
    const auto fall = [&](double from) { return level(from) - level(from + length); };
    const auto rate = [&](double from) { return path_(from).rate.y - path_(from + length).rate.y; };
    std::vector<double> found;
    const auto add_between = [&](double from, double before, double to, double after) {
      if (std::abs(before) <= kSameLevel * height_) {
        found.push_back(from);
      } else if (before * after < 0) {
        found.push_back(zero_between(fall, from, before, to, after));
      }
    };
    for (std::size_t i = 0; i < knots_.size(); ++i) {
      const double from = knot(i).crank, to = knot(i + 1).crank;
      const double before = fall(from), after = fall(to);
      const double turning = rate(from), turned = rate(to);
      if (turning * turned < 0) {
        const double middle = zero_between(rate, from, turning, to, turned);
        add_between(from, before, middle, fall(middle));
        add_between(middle, fall(middle), to, after);
      } else {
        add_between(from, before, to, after);
      }
    }
    return found;
  }

  void add(double crank, const Vec2d& at, bool is_peak) {
    knots_.push_back({crank, at.y, is_peak});
    is_finite_ = is_finite_ && std::isfinite(at.x) && std::isfinite(at.y);
    size_ = std::max({size_, std::abs(at.x), std::abs(at.y)});
  }

  void add_extreme(double from, double rate_before, double to, double rate_after) {
    if (!(rate_before * rate_after <= 0) || rate_after == 0) return;
    const auto rate = [&](double crank) { return path_(crank).rate.y; };
    const double at = zero_between(rate, from, rate_before, to, rate_after);
    add(at, path_(at).at, rate_after < 0);
  }

  /// Counted on over the seam of the turn.
  Knot knot(std::size_t i) const {
    Knot one = knots_[i % knots_.size()];
    const std::size_t turns = i / knots_.size();
    one.crank += kTurn * double(turns);
    return one;
  }

  /// Where the level crosses `limit` after knot i.
  double crossing(std::size_t i, double limit) const {
    const Knot a = knot(i), b = knot(i + 1);
    const auto above = [&](double crank) { return level(crank) - limit; };
    return zero_between(above, a.crank, a.level - limit, b.crank, b.level - limit);
  }

  const FootPath& path_;
  std::vector<Knot> knots_;
  bool is_finite_ = true;
  double size_ = 0, ground_ = 0, height_ = 0;
};

/// Fills stride and sense, and the square about the middle of the band; `middle`: its level.
void measure_stance(const FootPath& path, double middle, Gait& of) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  const auto take = [&](double x) {
    least = std::min(least, x);
    greatest = std::max(greatest, x);
  };
  const auto rate = [&](double crank) { return path(crank).rate.x; };
  const double step = (of.to - of.from) / kStanceSamples;
  const FootState first = path(of.from);
  FootState before = first;
  take(before.at.x);
  for (int i = 0; i < kStanceSamples; ++i) {
    const double from = of.from + step * i;
    const FootState after = path(from + step);
    take(after.at.x);
    const double mean = 0.5 * (before.at.y + after.at.y) - middle;
    of.square += mean * mean / kStanceSamples;
    if (before.rate.x * after.rate.x < 0) {
      take(path(zero_between(rate, from, before.rate.x, from + step, after.rate.x)).at.x);
    }
    before = after;
  }
  of.stride = greatest - least;
  of.sense = before.at.x < first.at.x ? -1 : 1;
}

/// Fills the extremes of the speed.
void measure_speed(const FootPath& path, Gait& of) {
  const double mean = of.sense * of.stride / (of.to - of.from);
  const auto speed = [&](double crank) { return path(crank).rate.x / mean; };
  const double step = (of.to - of.from) / kStanceSamples;
  std::vector<double> values;
  for (int i = 0; i <= kStanceSamples; ++i) values.push_back(speed(of.from + step * i));
  const auto extreme = [&](double sign) {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double here = sign * values[i];
      most = std::max(most, here);
      if (i == 0 || i + 1 == values.size()) continue;
      if (here < sign * values[i - 1] || here < sign * values[i + 1]) continue;
      const double at = of.from + step * double(i);
      const auto lowered = [&](double crank) { return -sign * speed(crank); };
      most = std::max(most, -golden_section(lowered, at - step, at + step, kSpeedSteps).least());
    }
    return sign * most;
  };
  of.speed_min = extreme(-1);
  of.speed_max = extreme(1);
}

/// All but the speed.
Gait with_stance(const FootPath& path, const Levels& levels, double from, double length) {
  Gait one;
  one.duty = length / kTurn;
  one.from = in_one_turn(from);
  one.to = one.from + length;
  one.height = levels.height();
  one.band = levels.highest(one.from, length) - levels.ground();
  measure_stance(path, levels.ground() + 0.5 * one.band, one);
  return one;
}

/// Of the lowest stances of this length the one with the longest stride.
Gait lowest_stance(const FootPath& path, const Levels& levels, double length) {
  Gait best;
  for (const double from : levels.lowest_parts(length)) {
    const Gait one = with_stance(path, levels, from, length);
    if (one.stride > (1 + kTie) * best.stride) best = one;
  }
  return best;
}

Gait longest_stance(const FootPath& path, const Levels& levels) {
  const auto [from, length] = levels.longest_below(kStanceShare * levels.height());
  return with_stance(path, levels, from, length);
}

}  // namespace

std::optional<Gait> gait(const FootPath& path, std::optional<double> duty) {
  const Levels levels(path);
  if (!levels.is_known()) return std::nullopt;
  Gait found = duty ? lowest_stance(path, levels, kTurn * *duty) : longest_stance(path, levels);
  if (!(found.stride > kNoExtent * levels.height())) return std::nullopt;
  measure_speed(path, found);
  return found;
}

std::optional<Gait> gait(const Mechanism<double>& mechanism, const Attached<double>& foot,
                         std::optional<double> duty) {
  const bool follows = has_groups(mechanism);
  const auto walk = [&](auto motion) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const FootPath path = [&](double crank) -> FootState {
      const double to = follows ? in_one_turn(crank) : crank;
      if (!motion.move_to(to)) return {{kNone, kNone}, {kNone, kNone}};
      const auto at = motion.point(foot);
      return {at[0], at[1]};
    };
    return gait(path, duty);
  };
  if (!follows) return walk(MechanismMotion<1>(mechanism));
  return walk(FollowedMotion<1>(mechanism, follow(mechanism, 0, kTurn)));
}

}  // namespace cognate
