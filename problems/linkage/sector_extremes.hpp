/// @file The least values of a smooth function of a four-bar and its crank's angle in each sector
/// of the turn, with exact derivatives by the dimensions.
#pragma once

#include <ceres/jet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/cycle/cycle_limits.hpp"
#include "problems/linkage/cycle/cycle_motion.hpp"

namespace cognate::problems {

/// The least value in a sector; infinite where the linkage does not close in it.
struct SectorExtreme {
  double value = std::numeric_limits<double>::infinity();
  LimitSlopes slopes{};
};
using SectorExtremes = std::array<SectorExtreme, CycleLimits::kSectors>;

/// A number with its derivatives by the dimensions.
using DimensionJet = ceres::Jet<double, std::tuple_size_v<LimitSlopes>>;

/// Whether the links' angles are requested, not only their directions.
enum class CycleAngles { none, all };

/// A four-bar at a table of crank angles from its frame.
class CycleTable {
 public:
  explicit CycleTable(const CycleDimensions& dimensions, CycleAngles angles = CycleAngles::none);

  /// Of `quantity`, which maps (LinkagePose<T>, CycleState<T>) to T for every number type;
  /// `with_slopes`: derivatives too.
  template <class Quantity>
  SectorExtremes least(const Quantity& quantity, bool with_slopes) const {
    std::array<double, kAngles + 1> values;
    for (int k = 0; k < kAngles; ++k) {
      values.at(at(k)) = states_[at(k)].closes ? quantity(plain_, states_[at(k)].state)
                                               : std::numeric_limits<double>::quiet_NaN();
    }
    values.back() = values.front();
    SectorExtremes all;
    for (int sector = 0; sector < CycleLimits::kSectors; ++sector) {
      all.at(at(sector)) = least_in(quantity, values, sector * kPerSector, with_slopes);
    }
    return all;
  }

  /// A quantity where half the crank's angle, in [0, π], has the direction `half`; not a number
  /// where the linkage does not close.
  template <class Quantity>
  DimensionJet value(const Quantity& quantity, const Vec2d& half) const {
    const double part = std::atan2(half.y, half.x) / kPi;
    const int k = static_cast<int>(kAngles * part);
    const Vec2d beyond = half * conj(half_directions().at(at(k)));
    return full(quantity, k, beyond.y / beyond.x);
  }

  /// The mean over the sectors' ends where the linkage closes; 0 where it nowhere does. Its
  /// derivatives only `with_slopes`.
  template <class Quantity>
  DimensionJet mean(const Quantity& quantity, bool with_slopes) const {
    DimensionJet sum;
    int count = 0;
    for (int k = 0; k < kAngles; k += kPerSector) {
      if (!states_[at(k)].closes) continue;
      sum +=
          with_slopes ? full(quantity, k, 0) : DimensionJet(quantity(plain_, states_[at(k)].state));
      ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : sum;
  }

  /// How often a link turns round, counter-clockwise, in a turn of the crank.
  double turns(MovingLink link) const { return turns_.at(static_cast<std::size_t>(link)); }

  const Lengths<double>& links() const { return plain_.links; }
  double assembly() const { return assembly_; }

 private:
  static constexpr int kPerSector = 12;
  static constexpr int kAngles = kPerSector * CycleLimits::kSectors;
  static constexpr int kDimensions = DimensionJet::DIMENSION;
  using OneJet = ceres::Jet<double, 1>;
  using FullJet = DimensionJet;

  /// A slope so small beside others counts for nothing: its square is that of rounding.
  static constexpr double kFlat = 1e-8;

  struct Sample {
    CycleState<double> state;
    bool closes = false;
  };

  void follow_angles();

  /// The angle of a link that stands nearly as `near` does.
  template <class T>
  static T angle_near(const LinkTurning<double>& near, double turned, const Vec2<T>& direction) {
    using std::atan2;
    const Vec2<T> from{T(near.direction.x), T(near.direction.y)};
    return T(near.angle + turned) + atan2(cross(from, direction), dot(from, direction));
  }

  /// Adds the links' angles to a state beyond angle k of the table, where the crank stands at
  /// `crank`.
  template <class T>
  void add_angles(int k, const T& crank, CycleState<T>& state) const {
    const bool again = k == kAngles;
    const CycleState<double>& near = states_[at(again ? 0 : k)].state;
    const auto turned = [&](MovingLink link) { return again ? kTurn * turns(link) : 0; };
    state.crank.angle = crank;
    state.coupler.angle =
        angle_near(near.coupler, turned(MovingLink::coupler), state.coupler.direction);
    state.rocker.angle =
        angle_near(near.rocker, turned(MovingLink::rocker), state.rocker.direction);
  }

  static double crank_angle(int k, double offset) {
    return kTurn * k / kAngles + 2 * std::atan(offset);
  }

  /// A value and its slope by the crank's angle, at the half direction of angle k and `offset`, the
  /// tangent of half the angle beyond.
  struct Sloping {
    double offset = 0, value = 0, slope = 0;
  };

  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  static const std::array<Vec2d, kAngles + 1>& half_directions();
  static Vec2d half_direction(int k, double offset) {
    const Vec2d half = half_directions().at(at(k)) * Vec2d{1, offset};
    return (1 / std::sqrt(1 + offset * offset)) * half;
  }

  /// The direction as a function of the crank's angle.
  static CrankDirection<OneJet> turning(const Vec2d& half) {
    const CrankDirection<double> plain = crank_direction(half);
    CrankDirection<OneJet> out{OneJet(plain.cos), OneJet(plain.sin), OneJet(plain.versine),
                               plain.side};
    out.cos.v[0] = -plain.sin;
    out.sin.v[0] = plain.cos;
    out.versine.v[0] = plain.side * plain.sin;
    return out;
  }

  template <class Quantity>
  Sloping sloping(const Quantity& quantity, int k, double offset) const {
    auto state =
        turn_state(one_.links, one_closure_, turning(half_direction(k, offset)), assembly_);
    if (angles_ == CycleAngles::all) add_angles(k, OneJet(crank_angle(k, offset), 0), state);
    const OneJet value = quantity(one_, state);
    return {offset, value.a, value.v[0]};
  }

  /// Narrows [left, right], where the slope changes its sign from − to +, by false position
  /// (Illinois), and by halving where that creeps, as at a kink.
  template <class Quantity>
  void narrow(const Quantity& quantity, int k, Sloping& left, Sloping& right) const {
    constexpr int kMostSteps = 60;
    constexpr double kClose = 1e-14;
    const double flat = kFlat * std::max(-left.slope, right.slope);
    double weight_left = -left.slope, weight_right = right.slope;
    int last = 0;
    bool creeps = false;
    for (int step = 0; step < kMostSteps; ++step) {
      const double width = right.offset - left.offset;
      if (-left.slope <= flat || right.slope <= flat || width <= kClose) return;
      const double share = creeps ? 0.5 : weight_left / (weight_left + weight_right);
      const Sloping middle = sloping(quantity, k, left.offset + share * width);
      if (!std::isfinite(middle.slope)) return;
      const int side = middle.slope < 0 ? -1 : 1;
      Sloping& moved = side < 0 ? left : right;
      creeps = !creeps && std::abs(middle.slope) > 0.5 * std::abs(moved.slope);
      moved = middle;
      (side < 0 ? weight_left : weight_right) = std::abs(middle.slope);
      if (side == last) (side < 0 ? weight_right : weight_left) /= 2;
      last = side;
    }
  }

  template <class Quantity>
  FullJet full(const Quantity& quantity, int k, double offset) const {
    const CrankDirection<double> plain = crank_direction(half_direction(k, offset));
    const CrankDirection<FullJet> direction{FullJet(plain.cos), FullJet(plain.sin),
                                            FullJet(plain.versine), plain.side};
    auto state = turn_state(full_.links, full_closure_, direction, assembly_);
    if (angles_ == CycleAngles::all) add_angles(k, FullJet(crank_angle(k, offset)), state);
    return quantity(full_, state);
  }

  /// The extreme at `end`, or between two ends of a narrow bracket. At a kink the slopes of both
  /// sides are mixed so that the crank's angle has no influence, which is also right where there is
  /// none.
  template <class Quantity>
  SectorExtreme extreme(const Quantity& quantity, int k, const Sloping& left, const Sloping& right,
                        bool with_slopes) const {
    SectorExtreme found{std::min(left.value, right.value), {}};
    if (!with_slopes) return found;
    const double rise = right.slope - left.slope;
    const double share = rise > 0 ? right.slope / rise : 1;  // of the left end
    const auto add = [&](double part, double offset) {
      if (part <= kFlat) return;
      const FullJet jet = full(quantity, k, offset);
      for (int i = 0; i < kDimensions; ++i) found.slopes.at(at(i)) += part * jet.v[i];
    };
    add(share, left.offset);
    add(1 - share, right.offset);
    return found;
  }

  template <class Quantity>
  SectorExtreme least_in(const Quantity& quantity, const std::array<double, kAngles + 1>& values,
                         int begin, bool with_slopes) const {
    int best = -1;
    for (int k = begin; k <= begin + kPerSector; ++k) {
      const double value = values.at(at(k));
      if (std::isfinite(value) && (best < 0 || value < values.at(at(best)))) best = k;
    }
    if (best < 0) return {};
    const Sloping here = sloping(quantity, best, 0);
    const int toward = here.slope < 0 ? 1 : -1;
    const int other = best + toward;
    const bool inside = other >= begin && other <= begin + kPerSector;
    const bool slopes = std::isfinite(here.slope) && here.slope != 0;
    if (!slopes || !inside || !std::isfinite(values.at(at(other)))) {
      return extreme(quantity, best, here, here, with_slopes);
    }
    Sloping there = sloping(quantity, best, toward * step_);
    if (!std::isfinite(there.slope) || there.slope * here.slope >= 0) {
      return extreme(quantity, best, here, here, with_slopes);
    }
    Sloping left = toward > 0 ? here : there, right = toward > 0 ? there : here;
    narrow(quantity, best, left, right);
    return extreme(quantity, best, left, right, with_slopes);
  }

  CycleAngles angles_;
  std::array<double, 3> turns_{1, 0, 0};
  double assembly_;
  double step_;  ///< tangent of half an angle of the table
  LinkagePose<double> plain_;
  LinkagePose<OneJet> one_;
  LinkagePose<FullJet> full_;
  Closure<OneJet> one_closure_;
  Closure<FullJet> full_closure_;
  std::array<Sample, kAngles> states_;
};

}  // namespace cognate::problems
