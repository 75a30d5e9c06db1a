#include "problems/reading/turn_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "problems/names.hpp"
#include "problems/reading/operation_tables.hpp"
#include "problems/reading/quantity_rules.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kClearance = "clearance", kPeak = "peak_acceleration_max",
                           kRipple = "torque_ripple_max";
constexpr std::size_t kMostClearances = 20;

constexpr NumberRule kLimit{is_positive_quantity, "a number from 1e-30 to 1e30"};

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
  for (const std::string_view key : {kClearance, kPeak, kRipple}) {
    if (!constraints.has(key)) continue;
    if (!scope.refusal.empty()) {
      constraints.fault(key, scope.refusal);
    } else if (key == kClearance && !scope.has_place) {
      constraints.fault(key,
                        "limits a place in the plane, and a function generator has none; "
                        "leave it out");
    } else {
      check_class(constraints, key, limits);
    }
  }
  for (TableReader& clearance : constraints.tables(kClearance, {0, kMostClearances, "tables"})) {
    read_clearance(clearance, scope, limits);
  }
  limits.peak_acceleration_max = constraints.number(kPeak, kLimit);
  limits.torque_ripple_max = constraints.number(kRipple, kLimit);
  if (!scope.refusal.empty()) return;
  const auto is_objective = [&](Measure measure) {
    return solve.has_word("objectives", to_string(measure));
  };
  const bool by_peak = is_objective(Measure::peak_acceleration);
  const bool by_ripple = is_objective(Measure::torque_ripple);
  constexpr double kAny = std::numeric_limits<double>::infinity();
  if (by_peak) limits.peak_acceleration_max = limits.peak_acceleration_max.value_or(kAny);
  if (by_ripple) limits.torque_ripple_max = limits.torque_ripple_max.value_or(kAny);
  limits.operation =
      read_operation(document, {constraints.has(kPeak) || by_peak,
                                constraints.has(kRipple) || by_ripple, scope.has_coupler_point});
}

}  // namespace cognate::problems::reading
