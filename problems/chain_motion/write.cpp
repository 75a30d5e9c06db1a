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

TableWriter limits_writer(const ChainMotionProblem& problem) {
  TableWriter table;
  table.set_deg("transmission_angle_deg", problem.constraints.transmission_angle)
      .set_name("over", problem.constraints.over)
      .set("rms_error_max", problem.constraints.rms_error_max);
  write_design_layers(problem.layers, table);
  return table;
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<ChainMotionProblem>::written(const ChainMotionProblem& problem) {
  using namespace reading;
  Written all;
  check_structure(problem.mechanism, problem.topologies, topologies(problem.mechanism), all.faults);
  check_one_demand(problem.topologies, all.faults);
  all.document =
      document_writer(kWord, problem.title, problem.length_unit)
          .set("target", target_writer(problem))
          .set("mechanism", chain_mechanism_writer(problem.mechanism, problem.topologies))
          .set("bounds", chain_bounds_writer(problem.topologies))
          .set("constraints", limits_writer(problem))
          .set("solve", chain_solve_writer(problem.solve, problem.against))
          .set("warnings", warnings_writer(problem.warnings))
          .append(layers_table(problem.layers))
          .append(tolerance_table(problem.tolerances, false))
          .take();
  return all;
}

tl::expected<ChainMotionProblem, std::vector<std::string>> KindTraits<ChainMotionProblem>::checked(
    const ChainMotionProblem& problem) {
  ChainMotionProblem complete = problem;
  if (complete.topologies.empty()) complete.topologies = topologies(complete.mechanism);
  const auto read = reading::read_back(complete);
  if (!read) return tl::unexpected(read.error());
  complete.topologies = read->topologies;
  return complete;
}

}  // namespace cognate::problems
