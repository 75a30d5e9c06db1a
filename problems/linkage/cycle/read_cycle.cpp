#include "problems/linkage/cycle/read_cycle.hpp"

#include <limits>

#include "problems/linkage/cycle/read_operation.hpp"

namespace cognate::problems::reading {

void read_cycle_limits(TableReader& document, TableReader& constraints, const TableReader& solve,
                       const CycleScope& scope, Constraints& limits) {
  read_clearances(constraints, scope, limits);
  for (const CycleDeclaration& quantity : kCycleQuantities) {
    check_over_turn(constraints, quantity.limit_key, scope, limits);
    auto& most = limits.cycle_max[quantity.id];
    most = constraints.number(quantity.limit_key, quantity.limit_rule);
    const bool is_objective = solve.has_word("objectives", quantity.key());
    const bool is_asked = constraints.has(quantity.limit_key) || is_objective;
    if (is_asked) most = most.value_or(std::numeric_limits<double>::infinity());
  }
  if (!scope.refusal.empty()) return;
  limits.operation = read_operation(
      document, {.asked = limits.cycle_max,
                 .has_coupler_point = scope.has_coupler_point,
                 .has_strokes = limits.required_class == RequiredClass::crank_rocker});
}

}  // namespace cognate::problems::reading
