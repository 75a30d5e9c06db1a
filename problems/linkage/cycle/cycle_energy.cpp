#include "problems/linkage/cycle/cycle_energy.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

/// The direction of half the crank's angle, in [0, π], where the crank has direction `crank`.
Vec2d half_of(const Vec2d& crank) {
  const double x = std::clamp(crank.x, -1., 1.);
  return {std::copysign(std::sqrt(0.5 * (1 + x)), crank.y), std::sqrt(0.5 * (1 - x))};
}

}  // namespace

double angle_of_half(const Vec2d& half) {
  return 2 * std::atan2(half.y, half.x);
}

TurningPoints turning_points(const Lengths<double>& l, double assembly) {
  const auto towards_c = [&](double distance) {
    const double cosine =
        (l.frame * l.frame + distance * distance - l.rocker * l.rocker) / (2 * l.frame * distance);
    return Vec2d{cosine, assembly * std::sqrt(1 - cosine * cosine)};
  };
  return {half_of(towards_c(l.coupler + l.crank)), half_of(-towards_c(l.coupler - l.crank))};
}

/// The rocker turns counter-clockwise from the outer to the inner turning point as the crank does,
/// in the open assembly; else the other way. It does not turn there, so that what a load would have
/// done does not depend on the crank's angle to first order, and its derivatives by the dimensions
/// are those at a crank angle that stands still.
CycleWork::Stroke CycleWork::stroke_of(const WorkingLoad& load, const CycleTable& table) const {
  const auto [outer, inner] = turning_points(table.links(), table.assembly());
  const bool counter_clockwise = (load.sense == LoadSense::advance) == (operation_.speed > 0);
  const bool from_outer = counter_clockwise == (table.assembly() > 0);
  const Vec2d &from = from_outer ? outer : inner, &to = from_outer ? inner : outer;
  if (!std::isfinite(from.x + to.x)) {
    const DimensionJet unknown(std::numeric_limits<double>::quiet_NaN());
    return {0, 0, unknown, unknown};
  }
  const auto work = [&](const auto& of, const auto& at) { return work_of(load, of, at); };
  return {angle_of_half(from), angle_of_half(to), table.value(work, from), table.value(work, to)};
}

CycleWork::CycleWork(const Operation& operation, const CycleTable& table) : operation_(operation) {
  for (const WorkingLoad& load : operation.loads) {
    if (load.sense == LoadSense::always) {
      drive_ -= load.torque * table.turns(load.at.link);
    } else {
      const Stroke stroke = stroke_of(load, table);
      drive_ -= (stroke.at_to - stroke.at_from) / kTurn;
      strokes_.push_back(stroke);
    }
  }
}

bool CycleWork::is_known() const {
  return std::isfinite(drive_.a);
}

}  // namespace cognate::problems
