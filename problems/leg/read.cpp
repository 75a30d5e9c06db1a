#include "problems/chain/front/read.hpp"

#include <algorithm>

#include "problems/chain/read_design.hpp"
#include "problems/chain/read_made.hpp"
#include "problems/leg/given.hpp"
#include "problems/leg/keys.hpp"
#include "problems/leg/known.hpp"
#include "problems/linkage/warnings.hpp"

namespace cognate::problems {
namespace reading {
namespace {

/// The values of `mechanism.type` of a leg.
std::vector<std::string_view> leg_types() {
  std::vector<std::string_view> words;
  for (const TopologyWord& topology : leg_topology_words()) words.push_back(topology.word);
  for (const TopologyWord& topology : topology_words()) {
    if (!leg_topologies(topology.word).empty()) words.push_back(topology.word);
  }
  words.push_back(kChainWord);
  return words;
}

void read_leg_target(TableReader& table, LegTarget& target) {
  if (!table.has("stride")) {
    table.fault("stride", "is missing; expected the length of a step along the ground");
  }
  read_keys(table, kLegTargetKeys, target);
  if (target.height_min && target.height_max && *target.height_min > *target.height_max) {
    table.fault("height_min", "is above height_max; expected one up to it");
  }
  if (target.objective == LegObjective::duty && !table.has("flatness_max")) {
    table.fault("flatness_max",
                "is missing; expected the most flatness at which the duty factor is greatest");
  }
}

/// Closeness to a published leg needs one.
void read_near(TableReader& mechanism, LegProblem& problem) {
  read_keys(mechanism, kLegMechanismKeys, problem);
  if (!problem.near || known_leg(problem.mechanism)) return;
  mechanism.fault("near",
                  "is given with a mechanism that has no published dimensions; remove it, or take "
                  "type = \"klann\" or \"jansen\"");
}

std::string foot_of(const std::vector<Topology>& topologies) {
  if (topologies.empty()) return "";
  const Topology& topology = topologies.front();
  return topology.lines[static_cast<std::size_t>(topology.trace)].name;
}

}  // namespace
}  // namespace reading

LegProblem KindTraits<LegProblem>::read(reading::TableReader& document,
                                        const std::filesystem::path& /*folder*/) {
  using namespace reading;
  LegProblem problem;
  LinkageTables tables(document);
  if (tables.mechanism.has("type")) {
    problem.mechanism = tables.mechanism.text("type").value_or("");
    if (std::ranges::count(leg_types(), problem.mechanism) == 0) {
      fault_chain_type(document, tables.mechanism, leg_types());
      return problem;
    }
  }
  const auto known = leg_topologies(problem.mechanism);
  read_leg_target(tables.target, problem.target);
  read_near(tables.mechanism, problem);
  const Wanted wanted = read_traced(tables.target, problem.mechanism, foot_of(known));
  problem.topologies = read_topologies(document, tables, known, wanted);
  problem.constraints.transmission_angle =
      read_chain_transmission(tables.constraints).value_or(problem.constraints.transmission_angle);
  read_keys(tables.constraints, kLegConstraintKeys, problem.constraints);
  refuse_four_bar_limits(tables.constraints,
                         "transmission_angle_deg, foot_speed_min and foot_speed_max");
  read_chain_solve(tables.solve, problem.solve);
  problem.against = read_against(tables.solve,
                                 {.mechanism = problem.mechanism,
                                  .topologies = problem.topologies,
                                  .is_given = is_given(problem)},
                                 problem.solve);
  read_made(document, tables, "length", LimitSpan::turn, problem);
  for (TableReader* table :
       {&tables.target, &tables.mechanism, &tables.constraints, &tables.solve}) {
    table->finish();
  }
  problem.warnings = read_warnings(document);
  return problem;
}

}  // namespace cognate::problems
