#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "problems/chain/problem.hpp"
#include "problems/chain/read_parts.hpp"
#include "problems/chain/read_structure.hpp"
#include "problems/chain/read_target.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/read_linkage.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems {
namespace reading {
namespace {

constexpr std::string_view kType = "type";
constexpr double kQuarterTurn = 90;

/// The values of `mechanism.type` of a path, that of the four-bar first.
std::vector<std::string_view> path_types() {
  std::vector<std::string_view> words{"four-bar"};
  for (const TopologyWord& topology : topology_words()) words.push_back(topology.word);
  words.push_back(kChainWord);
  return words;
}

bool is_all_given(const TopologyLine& line) {
  const bool either = line.line.type == synthesis::LineType::dyad && !line.assembly;
  const int count = parameter_count(line.line.type);
  const bool all = line.given[0] && (count < 2 || line.given[1]);
  return all && !either;
}

void check_something_is_found(TableReader& mechanism, const ChainPathProblem& problem) {
  for (const Topology& topology : problem.topologies) {
    if (!std::ranges::all_of(topology.lines, is_all_given)) continue;
    return mechanism.faults().add(mechanism.where(),
                                  "the mechanism is given with all dimensions, so that nothing is "
                                  "left to find; leave one out, or take kind = \"analysis\"");
  }
}

void read_topology(TableReader& document, LinkageTables& tables, ChainPathProblem& problem) {
  PartTables parts(document, tables.mechanism);
  if (problem.mechanism == kChainWord) {
    if (auto topology = read_structure(parts, tables.mechanism, tables.target)) {
      problem.topologies = {*std::move(topology)};
    }
  } else {
    problem.topologies = topologies(problem.mechanism);
    if (tables.target.has("point")) {
      tables.target.fault("point", fmt::format("is given with mechanism.type = {}, whose point P "
                                               "is traced; remove it, or take type = \"chain\"",
                                               in_quotes(problem.mechanism)));
    }
  }
  const bool is_known = !problem.topologies.empty();
  if (is_known) read_chain_bounds(tables.bounds, problem.topologies);
  if (problem.mechanism == kChainWord) {
    read_given(parts, problem.topologies);
  } else {
    read_given_by_name(parts, problem.topologies);
  }
  if (is_known) {
    tables.bounds.finish();
    check_something_is_found(tables.mechanism, problem);
  }
}

void read_transmission(TableReader& constraints, ChainConstraints& limits) {
  constexpr std::string_view kKey = "transmission_angle_deg";
  const auto range = constraints.range(kKey, kTransmissionAngle);
  if (!range) return;
  if (std::max(range->min, 2 * kQuarterTurn - range->max) >= kQuarterTurn) {
    return constraints.fault(
        kKey, fmt::format("is [{}, {}], which no dyad keeps to in motion; expected min < 90 < max",
                          range->min, range->max));
  }
  limits.transmission_angle = {radians(range->min), radians(range->max)};
}

void read_chain_constraints(TableReader& constraints, ChainConstraints& limits) {
  read_transmission(constraints, limits);
  limits.over = constraints.choice<LimitSpan>("over").value_or(limits.over);
  limits.rms_error_max = constraints.number("rms_error_max", kErrorScale);
  for (const std::string_view key :
       {"class", "link_ratio_max", "time_ratio", "pivot_region", "clearance", "no_branch_defect",
        "no_order_defect", "no_circuit_defect", "no_extra_loop"}) {
    if (!constraints.has(key)) continue;
    constraints.fault(key,
                      "is a limit of four-bars; remove it: chains take transmission_angle_deg, "
                      "over and rms_error_max");
  }
}

void read_chain_solve(TableReader& table, Solve& solve) {
  read_counts(table, kMostSearchedDesigns, solve);
  for (const std::string_view key : {"solver", "tolerance", "loss", "loss_scale", "certify",
                                     "certify_gap", "objectives", "atlas"}) {
    if (!table.has(key)) continue;
    table.fault(key,
                "is for four-bars alone; remove it: the search of a chain takes starts and "
                "designs");
  }
}

/// A type that the kind does not have: of the rest nothing can be said.
void fault_type(TableReader& document, TableReader& mechanism) {
  mechanism.choice_of(kType, path_types());
  document.know(
      {"target", "mechanism", "bounds", "constraints", "solve", "pivot", "crank", "dyad", "point"});
}

}  // namespace
}  // namespace reading

bool KindTraits<ChainPathProblem>::takes(reading::TableReader& document) {
  if (!document.has_table("mechanism")) return false;
  reading::TableReader mechanism = document.table("mechanism");
  if (!mechanism.has_text(reading::kType)) return false;
  const std::string type = *mechanism.text(reading::kType);
  return type == kChainWord || !from_string<MechanismType>(type);
}

ChainPathProblem KindTraits<ChainPathProblem>::read(reading::TableReader& document,
                                                    const std::filesystem::path& folder) {
  using namespace reading;
  ChainPathProblem problem;
  TableReader mechanism = document.table("mechanism");
  problem.mechanism = mechanism.text(kType).value_or("");
  if (problem.mechanism != kChainWord && topologies(problem.mechanism).empty()) {
    fault_type(document, mechanism);
    return problem;
  }
  LinkageTables tables(document);
  tables.mechanism.know({kType});
  read_chain_target(tables.target, folder, problem);
  read_topology(document, tables, problem);
  read_chain_constraints(tables.constraints, problem.constraints);
  read_chain_solve(tables.solve, problem.solve);
  for (TableReader* table :
       {&tables.target, &tables.mechanism, &tables.constraints, &tables.solve}) {
    table->finish();
  }
  return problem;
}

}  // namespace cognate::problems
