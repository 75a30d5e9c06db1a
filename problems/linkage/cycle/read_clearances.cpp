#include <algorithm>
#include <array>
#include <cmath>

#include "problems/linkage/cycle/read_cycle.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kClearance = "clearance";
constexpr std::size_t kMostClearances = 20;

void read_obstacle(TableReader& clearance, Clearance& limit) {
  const bool is_area = limit.box.min.x < limit.box.max.x && limit.box.min.y < limit.box.max.y;
  if (!is_area) clearance.fault("outside", "has no area; expected min < max in both");
}

void read_clearance(TableReader& clearance, const CycleScope& scope, Constraints& limits) {
  Clearance limit;
  const auto point = clearance.choice<MovingPoint>("point");
  if (!clearance.has("point")) {
    clearance.fault("point", "is missing; expected \"coupler-point\", \"B\" or \"C\"");
  }
  limit.point = point.value_or(limit.point);
  if (point == MovingPoint::coupler_point && !scope.has_coupler_point) {
    clearance.fault(
        "point", "is \"coupler-point\", which this problem does not have; expected \"B\" or \"C\"");
  }
  limit.inside = clearance.has("inside");
  if (limit.inside == clearance.has("outside")) {
    clearance.fault(limit.inside ? "outside" : "inside",
                    limit.inside
                        ? "is given beside inside; give one of them, and another "
                          "clearance for the other"
                        : "is missing; expected inside or outside = [[xmin, ymin], [xmax, ymax]]");
  }
  const auto box = clearance.box(limit.inside ? "inside" : "outside");
  clearance.finish();
  if (!box) return;
  limit.box = *box;
  const auto& [min, max] = *box;
  const std::array sides{min.x, min.y, max.x, max.y};
  if (std::ranges::none_of(sides, [](double side) { return std::isfinite(side); })) {
    clearance.fault(limit.inside ? "inside" : "outside",
                    "is the whole plane; expected at least one finite side");
  }
  if (!limit.inside) read_obstacle(clearance, limit);
  limits.clearances.push_back(limit);
}

}  // namespace

void check_over_turn(TableReader& constraints, std::string_view key, const CycleScope& scope,
                     const Constraints& limits) {
  if (!constraints.has(key)) return;
  if (!scope.refusal.empty()) {
    constraints.fault(key, scope.refusal);
  } else if (key == kClearance && !scope.has_place) {
    constraints.fault(key,
                      "limits a place in the plane, and a function generator has none; remove it");
  } else if (limits.required_class != RequiredClass::crank_rocker &&
             limits.required_class != RequiredClass::double_crank) {
    constraints.fault(key,
                      "holds over the full turn of the crank; expected class = \"crank-rocker\" or "
                      "\"double-crank\" as well");
  }
}

void read_clearances(TableReader& constraints, const CycleScope& scope, Constraints& limits) {
  check_over_turn(constraints, kClearance, scope, limits);
  for (TableReader& clearance : constraints.tables(kClearance, {0, kMostClearances, "tables"})) {
    read_clearance(clearance, scope, limits);
  }
}

}  // namespace cognate::problems::reading
