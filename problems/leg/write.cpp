/// A leg problem written down, and checked by reading what was written.
#include "problems/chain/write_design.hpp"
#include "problems/layers/read.hpp"
#include "problems/leg/keys.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {

reading::Written KindTraits<LegProblem>::written(const LegProblem& problem) {
  using namespace reading;
  Written all;
  check_structure(problem.mechanism, problem.topologies, leg_topologies(problem.mechanism),
                  all.faults);
  check_one_demand(problem.topologies, all.faults);
  TableWriter target, constraints;
  write_keys(problem.target, kLegTargetKeys, target);
  write_traced(problem.mechanism, problem.topologies, target);
  constraints.set_deg("transmission_angle_deg", problem.constraints.transmission_angle);
  write_keys(problem.constraints, kLegConstraintKeys, constraints);
  TableWriter mechanism = chain_mechanism_writer(problem.mechanism, problem.topologies);
  write_keys(problem, kLegMechanismKeys, mechanism);
  write_design_layers(problem.layers, constraints);
  all.document = document_writer(kWord, problem.title, problem.length_unit)
                     .set("target", target)
                     .set("mechanism", mechanism)
                     .set("bounds", chain_bounds_writer(problem.topologies))
                     .set("constraints", constraints)
                     .set("solve", chain_solve_writer(problem.solve, problem.against))
                     .set("warnings", warnings_writer(problem.warnings))
                     .append(layers_table(problem.layers))
                     .append(tolerance_table(problem.tolerances, false))
                     .take();
  return all;
}

tl::expected<LegProblem, std::vector<std::string>> KindTraits<LegProblem>::checked(
    const LegProblem& problem) {
  return reading::checked_chain(problem, leg_topologies(problem.mechanism));
}

}  // namespace cognate::problems
