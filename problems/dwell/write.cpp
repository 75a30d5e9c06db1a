/// A problem of dwells written down, and checked by reading what was written.
#include "problems/chain/write_design.hpp"
#include "problems/dwell/problem.hpp"
#include "problems/layers/read.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/raster/read.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {
namespace reading {
namespace {

TableWriter dwell_target_writer(const DwellProblem& problem) {
  const bool is_slider = slides(problem);
  const auto set_output = [&](TableWriter& table, const char* length, const char* angle,
                              const std::optional<double>& value) {
    is_slider ? table.set(length, value) : table.set_deg(angle, value);
  };
  Array dwells;
  for (const Dwell& dwell : problem.dwells) {
    TableWriter table;
    table.set_deg("over_deg", dwell.over).set_deg("from_deg", dwell.from);
    set_output(table, "half_band_max", "half_band_deg_max", dwell.half_band_max);
    dwells.push_back(node(table.take()));
  }
  TableWriter table;
  is_slider ? table.set("output", problem.output[1]) : table.set("output", problem.output);
  table.set("dwell", dwells);
  set_output(table, "apart", "apart_deg", problem.apart);
  if (problem.swing_min != 0) set_output(table, "stroke_min", "swing_deg_min", problem.swing_min);
  return table;
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<DwellProblem>::written(const DwellProblem& problem) {
  using namespace reading;
  Written all;
  check_structure(problem.mechanism, problem.topologies, function_topologies(problem.mechanism),
                  all.faults);
  check_one_demand(problem.topologies, all.faults);
  TableWriter constraints;
  constraints.set_deg("transmission_angle_deg", problem.constraints.transmission_angle);
  write_design_layers(problem.layers, constraints);
  all.document =
      document_writer(kWord, problem.title, problem.length_unit)
          .set("target", dwell_target_writer(problem))
          .set("mechanism", chain_mechanism_writer(problem.mechanism, problem.topologies))
          .set("bounds", chain_bounds_writer(problem.topologies))
          .set("constraints", constraints)
          .set("solve", chain_solve_writer(problem.solve, problem.against))
          .set("warnings", warnings_writer(problem.warnings))
          .append(raster_table(problem.raster))
          .append(layers_table(problem.layers))
          .append(tolerance_table(problem.tolerances, !slides(problem)))
          .take();
  return all;
}

tl::expected<DwellProblem, std::vector<std::string>> KindTraits<DwellProblem>::checked(
    const DwellProblem& problem) {
  return reading::checked_chain(problem, function_topologies(problem.mechanism));
}

}  // namespace cognate::problems
