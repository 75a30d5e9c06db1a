#include "problems/turn_limits.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "problems/sector_extremes.hpp"

namespace cognate::problems {
namespace {

/// Solvers keep this much inside, so that what they call met is met.
constexpr double kMargin = 1e-9;

constexpr int kSectors = TurnLimits::kSectors;

template <class T>
Vec2<T> place(const PlacedLinkage<T>& of, const TurnState<T>& at, MovingPoint point) {
  return of.pivot_a + of.turn * turning_of(of, at, place_of(point)).place;
}

/// The distance of a point from one side of a box: towards·p − bound.
struct SideDistance {
  MovingPoint point;
  Vec2d towards;
  double bound;

  template <class T>
  T operator()(const PlacedLinkage<T>& of, const TurnState<T>& at) const {
    const Vec2<T> p = place(of, at, point);
    return T(towards.x) * p.x + T(towards.y) * p.y - T(bound);
  }
};

/// By how much a point lies outside of a box: the greatest distance beyond one of its sides.
struct ObstacleDistance {
  MovingPoint point;
  Box box;

  template <class T>
  T operator()(const PlacedLinkage<T>& of, const TurnState<T>& at) const {
    const Vec2<T> p = place(of, at, point);
    T greatest = T(box.min.x) - p.x;
    for (const T& beyond : {p.x - T(box.max.x), T(box.min.y) - p.y, p.y - T(box.max.y)}) {
      if (greatest < beyond) greatest = beyond;
    }
    return greatest;
  }
};

/// −|a| times a share, of the coupler point or of the rocker's angle.
struct Calm {
  Accelerated accelerated;
  double share;

  template <class T>
  T operator()(const PlacedLinkage<T>& of, const TurnState<T>& at) const {
    using std::sqrt;
    constexpr double kNothing = 1e-200;  // whose root has a slope
    T square = at.rocker.bend * at.rocker.bend;
    if (accelerated == Accelerated::coupler_point) {
      square = squared_norm(turning_of(of, at, place_of(MovingPoint::coupler_point)).bend);
    }
    return T(-share) * sqrt(square + T(kNothing));
  }
};

/// The driving torque, or with the sign −1 its negative.
struct Torque {
  const Operation& operation;
  double sign;

  template <class T>
  T operator()(const PlacedLinkage<T>& of, const TurnState<T>& at) const {
    return T(sign) * driving_torque(of, at, operation);
  }
};

/// Writes rows one after the other.
class Rows {
 public:
  Rows(std::span<double> values, std::span<LimitSlopes> slopes)
      : values_(values), slopes_(slopes) {}

  bool with_slopes() const { return !slopes_.empty(); }

  /// Distances from a limit.
  void add(const SectorExtremes& distances) {
    for (const SectorExtreme& least : distances) {
      if (std::isfinite(least.value)) {
        add(least.value - kMargin, 1, least.slopes);
      } else {
        add(1, 0, {});
      }
    }
  }

  /// What is left of 1 by `r`, whose slopes are `sign` times those given; −∞ where the linkage does
  /// not close. What overflows is beyond any limit.
  void add_share(double r, double sign, const LimitSlopes& slopes) {
    constexpr double kBeyond = -700;  // −ln r of the largest numbers
    if (r == -std::numeric_limits<double>::infinity()) return add(1, 0, {});
    if (!std::isfinite(r)) return add(kBeyond, 0, {});
    add((r < 1 ? 1 - r : -std::log(r)) - kMargin, r < 1 ? -sign : -sign / r, slopes);
  }

 private:
  void add(double value, double factor, const LimitSlopes& slopes) {
    values_[row_] = value;
    if (with_slopes()) {
      for (std::size_t i = 0; i < slopes.size(); ++i) slopes_[row_][i] = factor * slopes[i];
    }
    ++row_;
  }

  std::span<double> values_;
  std::span<LimitSlopes> slopes_;
  std::size_t row_ = 0;
};

/// The sides of the box that are limits, as functions that are ≥ 0 within.
std::vector<SideDistance> sides_of(const Clearance& clearance) {
  const auto& [min, max] = clearance.box;
  std::vector<SideDistance> sides;
  const auto add = [&](const Vec2d& towards, double bound) {
    if (std::isfinite(bound)) sides.push_back({clearance.point, towards, bound});
  };
  add({1, 0}, min.x);
  add({-1, 0}, -max.x);
  add({0, 1}, min.y);
  add({0, -1}, -max.y);
  return sides;
}

}  // namespace

TurnLimits::TurnLimits(const Constraints& constraints, Accelerated accelerated)
    : clearances_(constraints.clearances),
      accelerated_(accelerated),
      operation_(constraints.operation) {
  const double ripple = constraints.torque_ripple_max.value_or(0);
  if (std::isfinite(ripple)) ripple_max_ = ripple;
  if (const auto& most = constraints.peak_acceleration_max) {
    acceleration_share_ = operation_.speed * operation_.speed / *most;
  }
  std::size_t quantities = 0;
  for (const Clearance& clearance : clearances_) {
    quantities += clearance.inside ? sides_of(clearance).size() : 1;
  }
  if (acceleration_share_ > 0) ++quantities;
  count_ = kSectors * (static_cast<int>(quantities) + (ripple_max_ > 0 ? kSectors : 0));
}

void TurnLimits::evaluate(const TurnDimensions& at, std::span<double> values,
                          std::span<LimitSlopes> slopes) const {
  if (count_ == 0) return;
  const TurnTable table(at);
  Rows rows(values, slopes);
  const bool sloped = rows.with_slopes();
  for (const Clearance& clearance : clearances_) {
    if (!clearance.inside) {
      rows.add(table.least(ObstacleDistance{clearance.point, clearance.box}, sloped));
      continue;
    }
    for (const SideDistance& side : sides_of(clearance)) rows.add(table.least(side, sloped));
  }
  if (acceleration_share_ > 0) {
    const SectorExtremes calmness = table.least(Calm{accelerated_, acceleration_share_}, sloped);
    for (const SectorExtreme& least : calmness) rows.add_share(-least.value, -1, least.slopes);
  }
  if (ripple_max_ > 0) {
    const double share = 1 / ripple_max_;
    const SectorExtremes least = table.least(Torque{operation_, share}, sloped);
    const SectorExtremes most = table.least(Torque{operation_, -share}, sloped);
    for (const SectorExtreme& high : most) {
      for (const SectorExtreme& low : least) {
        LimitSlopes by;
        for (std::size_t i = 0; i < by.size(); ++i) by[i] = high.slopes[i] + low.slopes[i];
        rows.add_share(-high.value - low.value, -1, by);
      }
    }
  }
}

TurnTable::TurnTable(const TurnDimensions& dimensions)
    : assembly_(sign(dimensions.assembly)), step_(std::tan(std::numbers::pi / kAngles)) {
  const auto& [links, point, pivot, angle, assembly] = dimensions;
  plain_ = {links, point, pivot, {std::cos(angle), std::sin(angle)}};
  const auto jet = [](double value) { return OneJet(value); };
  one_ = {{jet(links.crank), jet(links.coupler), jet(links.rocker), jet(links.frame)},
          {jet(point.x), jet(point.y)},
          {jet(pivot.x), jet(pivot.y)},
          {jet(plain_.turn.x), jet(plain_.turn.y)}};
  full_ = {{{links.crank, 0}, {links.coupler, 1}, {links.rocker, 2}, {links.frame, 3}},
           {{point.x, 4}, {point.y, 5}},
           {{pivot.x, 6}, {pivot.y, 7}},
           {{plain_.turn.x, 8}, {plain_.turn.y, 8}}};
  full_.turn.x.v[8] = -plain_.turn.y;
  full_.turn.y.v[8] = plain_.turn.x;
  one_closure_ = Closure<OneJet>(one_.links);
  full_closure_ = Closure<FullJet>(full_.links);
  const Closure<double> closure(links);
  for (int k = 0; k < kAngles; ++k) {
    Sample& sample = states_.at(at(k));
    const auto direction = crank_direction(half_directions().at(at(k)));
    sample.state = turn_state(links, closure, direction, assembly_);
    sample.closes = std::isfinite(sample.state.rocker.bend);
  }
}

const std::array<Vec2d, TurnTable::kAngles + 1>& TurnTable::half_directions() {
  static const auto all = [] {
    std::array<Vec2d, kAngles + 1> halves;
    for (int k = 0; k <= kAngles; ++k) {
      const double half = std::numbers::pi * k / kAngles;
      halves.at(at(k)) = {std::cos(half), std::sin(half)};
    }
    return halves;
  }();
  return all;
}

}  // namespace cognate::problems
