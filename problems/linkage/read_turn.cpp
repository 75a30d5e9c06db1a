#include "problems/linkage/read_turn.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "problems/basics/names.hpp"
#include "problems/linkage/read_operation.hpp"
#include "problems/mechanism/quantity_rules.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kClearance = "clearance";
constexpr std::size_t kMostClearances = 20;

constexpr NumberRule kLimit{is_positive_quantity, "a number from 1e-30 to 1e30"};

/// A greatest value over the turn, and the objective that it may be.
struct TurnLimit {
  std::string_view key;
  Measure measure;
  std::optional<double> Constraints::*most;
  const NumberRule& rule = kLimit;
};

constexpr TurnLimit kLimits[] = {
    {"peak_acceleration_max", Measure::peak_acceleration, &Constraints::peak_acceleration_max},
    {"torque_ripple_max", Measure::torque_ripple, &Constraints::torque_ripple_max},
    {"speed_fluctuation_max", Measure::speed_fluctuation, &Constraints::speed_fluctuation_max,
     kSpeedFluctuation},
    {"flywheel_inertia_max", Measure::flywheel_inertia, &Constraints::flywheel_inertia_max},
    {"motor_power_max", Measure::motor_power, &Constraints::motor_power_max}};

void read_obstacle(TableReader& clearance, Clearance& limit) {
  const bool is_area = limit.box.min.x < limit.box.max.x && limit.box.min.y < limit.box.max.y;
  if (!is_area) clearance.fault("outside", "has no area; min < max in both is wanted");
}

void read_clearance(TableReader& clearance, const TurnScope& scope, Constraints& limits) {
  Clearance limit;
  const auto point = clearance.choice<MovingPoint>("point");
  if (!clearance.has("point")) {
    clearance.fault("point", "is missing; \"coupler-point\", \"B\" or \"C\" is wanted");
  }
  limit.point = point.value_or(limit.point);
  if (point == MovingPoint::coupler_point && !scope.has_coupler_point) {
    clearance.fault("point",
                    "is \"coupler-point\", which nothing asks for here; \"B\" or \"C\" is "
                    "wanted");
  }
  limit.inside = clearance.has("inside");
  if (limit.inside == clearance.has("outside")) {
    clearance.fault(limit.inside ? "outside" : "inside",
                    limit.inside ? "is given beside inside; give one of them, and another "
                                   "clearance for the other"
                                 : "is missing; inside or outside = [[xmin, ymin], [xmax, ymax]] "
                                   "is wanted");
  }
  const auto box = clearance.box(limit.inside ? "inside" : "outside");
  clearance.finish();
  if (!box) return;
  limit.box = *box;
  const auto& [min, max] = *box;
  const std::array sides{min.x, min.y, max.x, max.y};
  if (std::ranges::none_of(sides, [](double side) { return std::isfinite(side); })) {
    clearance.fault(limit.inside ? "inside" : "outside",
                    "is the whole plane; at least one finite side is wanted");
  }
  if (!limit.inside) read_obstacle(clearance, limit);
  limits.clearances.push_back(limit);
}

void check_class(TableReader& constraints, std::string_view key, const Constraints& limits) {
  if (limits.required_class == RequiredClass::crank_rocker ||
      limits.required_class == RequiredClass::double_crank) {
    return;
  }
  constraints.fault(key,
                    "holds over the full turn of the crank; class = \"crank-rocker\" or "
                    "\"double-crank\" is wanted besides");
}

}  // namespace

void read_turn_limits(TableReader& document, TableReader& constraints, const TableReader& solve,
                      const TurnScope& scope, Constraints& limits) {
  const auto check = [&](std::string_view key) {
    if (!constraints.has(key)) return;
    if (!scope.refusal.empty()) {
      constraints.fault(key, scope.refusal);
    } else if (key == kClearance && !scope.has_place) {
      constraints.fault(key,
                        "limits a place in the plane, and a function generator has none; "
                        "leave it out");
    } else {
      check_class(constraints, key, limits);
    }
  };
  check(kClearance);
  for (TableReader& clearance : constraints.tables(kClearance, {0, kMostClearances, "tables"})) {
    read_clearance(clearance, scope, limits);
  }
  for (const auto& [key, measure, most, rule] : kLimits) {
    check(key);
    limits.*most = constraints.number(key, rule);
    const bool is_objective = solve.has_word("objectives", to_string(measure));
    const bool is_asked = constraints.has(key) || is_objective;
    if (is_asked) limits.*most = (limits.*most).value_or(std::numeric_limits<double>::infinity());
  }
  if (!scope.refusal.empty()) return;
  limits.operation = read_operation(
      document, {.by_acceleration = limits.peak_acceleration_max.has_value(),
                 .by_ripple = limits.torque_ripple_max.has_value(),
                 .by_fluctuation = limits.speed_fluctuation_max.has_value(),
                 .by_flywheel = limits.flywheel_inertia_max.has_value(),
                 .by_power = limits.motor_power_max.has_value(),
                 .has_coupler_point = scope.has_coupler_point,
                 .has_strokes = limits.required_class == RequiredClass::crank_rocker});
}

}  // namespace cognate::problems::reading
