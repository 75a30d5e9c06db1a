/// A path problem of a chain written down, and checked by reading what was written.
#include "problems/chain/problem.hpp"
#include "problems/chain/read_parts.hpp"
#include "problems/chain/write_design.hpp"
#include "problems/layers/read.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/path/problem.hpp"
#include "problems/raster/read.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {
namespace reading {
namespace {

TableWriter target_writer(const ChainPathProblem& problem) {
  TableWriter table;
  table.set("points", problem.points).set("closed", problem.closed);
  if (problem.is_movable) table.set_name("place", CurvePlace::similar);
  write_chain_timing(problem.crank_angles, table);
  write_traced(problem.mechanism, problem.topologies, table);
  return table;
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<ChainPathProblem>::written(const ChainPathProblem& problem) {
  using namespace reading;
  Written all;
  check_structure(problem.mechanism, problem.topologies, topologies(problem.mechanism), all.faults);
  check_one_demand(problem.topologies, all.faults);
  TableWriter constraints = chain_constraints_writer(problem.constraints);
  write_design_layers(problem.layers, constraints);
  all.document =
      document_writer(kWord, problem.title, problem.length_unit)
          .set("target", target_writer(problem))
          .set("mechanism", chain_mechanism_writer(problem.mechanism, problem.topologies))
          .set("bounds", chain_bounds_writer(problem.topologies))
          .set("constraints", constraints)
          .set("solve", chain_solve_writer(problem.solve, problem.against))
          .set("warnings", warnings_writer(problem.warnings))
          .append(raster_table(problem.raster))
          .append(layers_table(problem.layers))
          .append(tolerance_table(problem.tolerances, false))
          .take();
  return all;
}

tl::expected<ChainPathProblem, std::vector<std::string>> KindTraits<ChainPathProblem>::checked(
    const ChainPathProblem& problem) {
  return reading::checked_chain(problem, topologies(problem.mechanism));
}

}  // namespace cognate::problems
