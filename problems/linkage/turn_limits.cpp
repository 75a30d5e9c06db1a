#include "problems/linkage/turn_limits.hpp"

#include <cmath>
#include <limits>

#include "problems/linkage/sector_extremes.hpp"
#include "problems/linkage/turn_energy.hpp"

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

/// A share of the driving torque, which may be negative.
struct Torque {
  const Operation& operation;
  double share;

  template <class T>
  T operator()(const PlacedLinkage<T>& of, const TurnState<T>& at) const {
    return T(share) * driving_torque(of, at, operation);
  }
};

struct InertiaAtCrank {
  const Operation& operation;

  template <class T>
  T operator()(const PlacedLinkage<T>& of, const TurnState<T>& at) const {
    return equivalent_inertia(of, at, operation);
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

  /// What is left of 1 by base − share·(a + b) for the least values of two quantities in any two
  /// sectors.
  void add_pairs(double base, const DimensionJet& share, const SectorExtremes& first,
                 const SectorExtremes& second) {
    for (const SectorExtreme& a : first) {
      for (const SectorExtreme& b : second) {
        const double sum = a.value + b.value;
        LimitSlopes by{};
        for (std::size_t i = 0; i < by.size(); ++i) {
          const auto of_share = share.v[static_cast<Eigen::Index>(i)];
          by.at(i) = share.a * (a.slopes.at(i) + b.slopes.at(i));
          if (of_share != 0) by.at(i) += of_share * sum;
        }
        add_share(base - share.a * sum, -1, by);
      }
    }
  }

  void add_unknown(int count) {
    for (int i = 0; i < count; ++i) add(1, 0, {});
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

/// The rows that ask whether speeds can stay within so much of their mean.
class EnergyRows {
 public:
  EnergyRows(const Operation& operation, const TurnTable& table, Rows& rows)
      : operation_(operation), table_(table), rows_(rows) {}

  void add_fluctuation(double most) {
    const DimensionJet scale =
        most * square() * table_.mean(InertiaAtCrank{operation_}, rows_.with_slopes());
    const TurnWork work(operation_, table_);
    if (!work.is_known() || !(scale.a > 0)) return rows_.add_unknown(kPairs);
    add(operation_, work, most, 1, 1., 1. / scale);
  }

  void add_flywheel(double most) {
    Operation without = operation_;
    without.flywheel = 0;
    const TurnWork work(without, table_);
    if (!work.is_known()) return rows_.add_unknown(kPairs);
    const double fluctuation = operation_.fluctuation;
    add(without, work, fluctuation, 1 / (fluctuation * square() * most), 0, DimensionJet(1.));
  }

  static constexpr int kPairs = kSectors * kSectors;

 private:
  double square() const { return operation_.speed * operation_.speed; }

  void add(const Operation& operation, const TurnWork& work, double fluctuation, double share,
           double base, const DimensionJet& scale) {
    const double speed = std::abs(operation.speed);
    const EnergyWithin below{operation, work, speed * (1 + fluctuation / 2), share};
    const EnergyWithin above{operation, work, speed * (1 - fluctuation / 2), -share};
    const bool sloped = rows_.with_slopes();
    rows_.add_pairs(base, scale, table_.least(below, sloped), table_.least(above, sloped));
  }

  const Operation& operation_;
  const TurnTable& table_;
  Rows& rows_;
};

double finite_or_none(const std::optional<double>& most) {
  return is_limit(most) ? *most : 0;
}

}  // namespace

TurnLimits::TurnLimits(const Constraints& constraints, Accelerated accelerated)
    : clearances_(constraints.clearances),
      accelerated_(accelerated),
      ripple_max_(finite_or_none(constraints.torque_ripple_max)),
      power_max_(finite_or_none(constraints.motor_power_max)),
      fluctuation_max_(finite_or_none(constraints.speed_fluctuation_max)),
      flywheel_max_(finite_or_none(constraints.flywheel_inertia_max)),
      operation_(constraints.operation) {
  if (const auto& most = constraints.peak_acceleration_max) {
    acceleration_share_ = operation_.speed * operation_.speed / *most;
  }
  std::size_t quantities = 0;
  for (const Clearance& clearance : clearances_) {
    quantities += clearance.inside ? sides_of(clearance).size() : 1;
  }
  for (const double one_each : {acceleration_share_, power_max_}) {
    if (one_each > 0) ++quantities;
  }
  for (const double pairs : {ripple_max_, fluctuation_max_, flywheel_max_}) {
    if (pairs > 0) quantities += kSectors;
  }
  count_ = kSectors * static_cast<int>(quantities);
}

void TurnLimits::evaluate(const TurnDimensions& at, std::span<double> values,
                          std::span<LimitSlopes> slopes) const {
  if (count_ == 0) return;
  const TurnTable table(at, limits_energy() ? TurnAngles::all : TurnAngles::none);
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
    rows.add_pairs(0, DimensionJet(1.), table.least(Torque{operation_, -share}, sloped),
                   table.least(Torque{operation_, share}, sloped));
  }
  if (power_max_ > 0) {
    const double share = operation_.speed / power_max_;
    for (const SectorExtreme& least : table.least(Torque{operation_, -share}, sloped)) {
      rows.add_share(-least.value, -1, least.slopes);
    }
  }
  EnergyRows energy(operation_, table, rows);
  if (fluctuation_max_ > 0) energy.add_fluctuation(fluctuation_max_);
  if (flywheel_max_ > 0) energy.add_flywheel(flywheel_max_);
}

}  // namespace cognate::problems
