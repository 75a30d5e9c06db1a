#include "problems/linkage/cycle/cycle_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "problems/linkage/cycle/cycle_energy.hpp"
#include "problems/linkage/cycle/mean_torque.hpp"
#include "problems/linkage/sector_extremes.hpp"

namespace cognate::problems {
namespace {

/// Solvers keep this much inside, so that what they call met is met.
constexpr double kMargin = 1e-9;

constexpr int kSectors = CycleLimits::kSectors;

template <class T>
Vec2<T> place(const LinkagePose<T>& of, const CycleState<T>& at, MovingPoint point) {
  return of.pivot_a + of.turn * turning_of(of, at, place_of(point)).place;
}

/// The distance of a point from one side of a box: towards·p − bound.
struct SideDistance {
  MovingPoint point;
  Vec2d towards;
  double bound;

  template <class T>
  T operator()(const LinkagePose<T>& of, const CycleState<T>& at) const {
    const Vec2<T> p = place(of, at, point);
    return T(towards.x) * p.x + T(towards.y) * p.y - T(bound);
  }
};

/// By how much a point lies outside of a box: the greatest distance beyond one of its sides.
struct ObstacleDistance {
  MovingPoint point;
  Box box;

  template <class T>
  T operator()(const LinkagePose<T>& of, const CycleState<T>& at) const {
    const Vec2<T> p = place(of, at, point);
    T greatest = T(box.min.x) - p.x;
    for (const T& beyond : {p.x - T(box.max.x), T(box.min.y) - p.y, p.y - T(box.max.y)}) {
      if (greatest < beyond) greatest = beyond;
    }
    return greatest;
  }
};

/// The square of a derivative by the crank's angle, of the coupler point or of the rocker's angle.
template <class T>
T squared_derivative(const LinkagePose<T>& of, const CycleState<T>& at, CycleOutput output,
                     Vec2<T> PointTurning<T>::*of_point, T LinkTurning<T>::*of_angle) {
  if (output == CycleOutput::rocker) return at.rocker.*of_angle * at.rocker.*of_angle;
  return squared_norm(turning_of(of, at, place_of(MovingPoint::coupler_point)).*of_point);
}

/// The root of a square, with a slope where that is nothing.
template <class T>
T root(const T& square) {
  using std::sqrt;
  return sqrt(square + T(1e-200));
}

/// −|v| times a share, of the coupler point or of the rocker's angle.
struct Speed {
  CycleOutput output;
  double share;

  template <class T>
  T operator()(const LinkagePose<T>& of, const CycleState<T>& at) const {
    return T(-share) *
           root(squared_derivative(of, at, output, &PointTurning<T>::rate, &LinkTurning<T>::rate));
  }
};

/// Likewise −|a|.
struct Acceleration {
  CycleOutput output;
  double share;

  template <class T>
  T operator()(const LinkagePose<T>& of, const CycleState<T>& at) const {
    return T(-share) *
           root(squared_derivative(of, at, output, &PointTurning<T>::bend, &LinkTurning<T>::bend));
  }
};

/// A share of the driving torque, which may be negative.
struct Torque {
  const Operation& operation;
  double share;

  template <class T>
  T operator()(const LinkagePose<T>& of, const CycleState<T>& at) const {
    return T(share) * driving_torque(of, at, operation);
  }
};

struct InertiaAtCrank {
  const Operation& operation;

  template <class T>
  T operator()(const LinkagePose<T>& of, const CycleState<T>& at) const {
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

  /// What is left of 1 by −`least`: shares of a limit, negative.
  void add_shares(const SectorExtremes& least) {
    for (const SectorExtreme& one : least) add_share(-one.value, -1, one.slopes);
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

/// What rows are made of.
struct RowSource {
  const Operation& operation;
  CycleOutput output;
  const CycleTable& table;

  double square_speed() const { return operation.speed * operation.speed; }
};

void add_speed(const RowSource& from, double most, Rows& rows) {
  const double share = std::abs(from.operation.speed) / most;
  rows.add_shares(from.table.least(Speed{from.output, share}, rows.with_slopes()));
}

void add_acceleration(const RowSource& from, double most, Rows& rows) {
  const double share = from.square_speed() / most;
  rows.add_shares(from.table.least(Acceleration{from.output, share}, rows.with_slopes()));
}

void add_ripple(const RowSource& from, double most, Rows& rows) {
  const double share = 1 / most;
  const auto least = [&](double sign) {
    return from.table.least(Torque{from.operation, sign * share}, rows.with_slopes());
  };
  rows.add_pairs(0, DimensionJet(1.), least(-1), least(1));
}

void add_peak_torque(const RowSource& from, double most, Rows& rows) {
  for (const double share : {-1 / most, 1 / most}) {
    rows.add_shares(from.table.least(Torque{from.operation, share}, rows.with_slopes()));
  }
}

void add_rms_torque(const RowSource& from, double most, Rows& rows) {
  const DimensionJet share = root(mean_square_torque(from.operation, from.table)) / most;
  if (std::isnan(share.a)) return rows.add_unknown(1);
  LimitSlopes slopes{};
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    slopes.at(i) = share.v[static_cast<Eigen::Index>(i)];
  }
  rows.add_share(share.a, 1, slopes);
}

void add_power(const RowSource& from, double most, Rows& rows) {
  const double share = from.operation.speed / most;
  rows.add_shares(from.table.least(Torque{from.operation, -share}, rows.with_slopes()));
}

constexpr int kPairs = kSectors * kSectors;

/// Whether speeds can stay within so much of their mean. `share` is that of the energy in a limit.
void add_energy(const RowSource& from, const Operation& operation, const CycleWork& work,
                double fluctuation, double share, double base, const DimensionJet& scale,
                Rows& rows) {
  const double speed = std::abs(operation.speed);
  const EnergyWithin below{operation, work, speed * (1 + fluctuation / 2), share};
  const EnergyWithin above{operation, work, speed * (1 - fluctuation / 2), -share};
  const bool sloped = rows.with_slopes();
  rows.add_pairs(base, scale, from.table.least(below, sloped), from.table.least(above, sloped));
}

void add_fluctuation(const RowSource& from, double most, Rows& rows) {
  const DimensionJet scale = most * from.square_speed() *
                             from.table.mean(InertiaAtCrank{from.operation}, rows.with_slopes());
  const CycleWork work(from.operation, from.table);
  if (!work.is_known() || !(scale.a > 0)) return rows.add_unknown(kPairs);
  add_energy(from, from.operation, work, most, 1, 1., 1. / scale, rows);
}

void add_flywheel(const RowSource& from, double most, Rows& rows) {
  Operation without = from.operation;
  without.flywheel = 0;
  const CycleWork work(without, from.table);
  if (!work.is_known()) return rows.add_unknown(kPairs);
  const double fluctuation = from.operation.fluctuation;
  add_energy(from, without, work, fluctuation, 1 / (fluctuation * from.square_speed() * most), 0,
             DimensionJet(1.), rows);
}

/// How the search limits a quantity.
struct LimitRows {
  CycleQuantity of;
  int count;
  CycleAngles angles;  ///< whether they need the links' angles
  void (*add)(const RowSource& from, double most, Rows& rows);
};

/// In the order of the rows.
constexpr std::array kLimitRows{
    LimitRows{CycleQuantity::peak_speed, kSectors, CycleAngles::none, add_speed},
    LimitRows{CycleQuantity::peak_acceleration, kSectors, CycleAngles::none, add_acceleration},
    LimitRows{CycleQuantity::torque_ripple, kPairs, CycleAngles::none, add_ripple},
    LimitRows{CycleQuantity::peak_torque, 2 * kSectors, CycleAngles::none, add_peak_torque},
    LimitRows{CycleQuantity::rms_torque, 1, CycleAngles::none, add_rms_torque},
    LimitRows{CycleQuantity::motor_power, kSectors, CycleAngles::none, add_power},
    LimitRows{CycleQuantity::speed_fluctuation, kPairs, CycleAngles::all, add_fluctuation},
    LimitRows{CycleQuantity::flywheel_inertia, kPairs, CycleAngles::all, add_flywheel}};
static_assert(kLimitRows.size() == kCycleQuantities.size());

}  // namespace

CycleLimits::CycleLimits(const Constraints& constraints, CycleOutput output)
    : clearances_(constraints.clearances), operation_(constraints.operation), output_(output) {
  for (const Clearance& clearance : clearances_) {
    count_ += kSectors * (clearance.inside ? static_cast<int>(sides_of(clearance).size()) : 1);
  }
  for (const LimitRows& limit : kLimitRows) {
    const auto& most = constraints.cycle_max[limit.of];
    if (!is_limit(most)) continue;
    most_[limit.of] = most;
    count_ += limit.count;
  }
}

void CycleLimits::evaluate(const CycleDimensions& at, std::span<double> values,
                           std::span<LimitSlopes> slopes) const {
  if (count_ == 0) return;
  const bool by_angles = std::ranges::any_of(kLimitRows, [&](const LimitRows& limit) {
    return most_[limit.of] && limit.angles == CycleAngles::all;
  });
  const CycleTable table(at, by_angles ? CycleAngles::all : CycleAngles::none);
  Rows rows(values, slopes);
  const bool sloped = rows.with_slopes();
  for (const Clearance& clearance : clearances_) {
    if (!clearance.inside) {
      rows.add(table.least(ObstacleDistance{clearance.point, clearance.box}, sloped));
      continue;
    }
    for (const SideDistance& side : sides_of(clearance)) rows.add(table.least(side, sloped));
  }
  const RowSource from{operation_, output_, table};
  for (const LimitRows& limit : kLimitRows) {
    if (const auto& most = most_[limit.of]) limit.add(from, *most, rows);
  }
}

}  // namespace cognate::problems
