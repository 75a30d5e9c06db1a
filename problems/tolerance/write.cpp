/// `[tolerance]` written down.
#include "problems/tolerance/keys.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems::reading {
namespace {

Node written(const ToleranceValue& value) {
  if (const auto* grade = std::get_if<ToleranceGrade>(&value)) return node(to_string(*grade));
  const auto& [plus, minus] = std::get<Deviation>(value);
  if (plus == minus) return node(plus);
  return node(TableWriter{}.set("plus", plus).set("minus", minus));
}

TableWriter written(const Allocation& allocation, bool angle) {
  TableWriter costs;
  for (const CostFactor& cost : allocation.costs) costs.set(cost.dimension, cost.factor);
  TableWriter table;
  table.set(angle ? "limit_deg" : "limit", allocation.limit).set_name("by", allocation.basis);
  if (!costs.empty()) table.add("cost", node(costs));
  return table;
}

}  // namespace

Table tolerance_table(const std::optional<Tolerances>& tolerances, bool angle) {
  if (!tolerances) return {};
  TableWriter table;
  if (tolerances->length) table.add(kLengthTolerance, written(*tolerances->length));
  if (tolerances->pivots) table.add(kPivotTolerance, written(*tolerances->pivots));
  for (const auto& [dimension, value] : tolerances->dimensions) {
    table.add(dimension, written(value));
  }
  TableWriter pins;
  for (const auto& [joint, radial] : tolerances->clearances) pins.set(joint, radial);
  if (!pins.empty()) table.add(kPinClearance, node(pins));
  table.set_name(kDistribution, tolerances->distribution).set(kSampleCount, tolerances->samples);
  if (!tolerances->of.empty()) table.set(kJudged, tolerances->of);
  if (tolerances->max_error) {
    table.add(kYield, node(TableWriter{}.set(angle ? "max_error_deg" : "max_error",
                                             *tolerances->max_error)));
  }
  if (tolerances->allocation) {
    table.add(kAllocate, node(written(*tolerances->allocation, angle)));
  }
  return TableWriter{}.add("tolerance", node(table)).take();
}

}  // namespace cognate::problems::reading
