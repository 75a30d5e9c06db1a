/// The motion of a chain written down, and checked by reading what was written.
#include "problems/chain/read_parts.hpp"
#include "problems/chain/write_design.hpp"
#include "problems/chain_motion/problem.hpp"
#include "problems/layers/read.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {
namespace reading {
namespace {

TableWriter target_writer(const ChainMotionProblem& problem) {
  TableWriter table;
  Array poses;
  for (const auto& [at, angle] : problem.poses) {
    poses.push_back(node(Array{node(at.x), node(at.y), node_deg(angle)}));
  }
  table.set("poses", poses).set("closed", problem.closed);
  write_chain_timing(problem.crank_angles, table);
  table.set("angle_weight", problem.angle_weight);
  write_traced(problem.mechanism, problem.topologies, table);
  return table;
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<ChainMotionProblem>::written(const ChainMotionProblem& problem) {
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
          .append(layers_table(problem.layers))
          .append(tolerance_table(problem.tolerances, false))
          .take();
  return all;
}

tl::expected<ChainMotionProblem, std::vector<std::string>> KindTraits<ChainMotionProblem>::checked(
    const ChainMotionProblem& problem) {
  return reading::checked_chain(problem, topologies(problem.mechanism));
}

}  // namespace cognate::problems
