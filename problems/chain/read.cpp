#include "problems/raster/read.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "problems/chain/front/read.hpp"
#include "problems/chain/given.hpp"
#include "problems/chain/problem.hpp"
#include "problems/chain/raster/axes.hpp"
#include "problems/chain/read_design.hpp"
#include "problems/chain/read_target.hpp"
#include "problems/chain/read_tolerances.hpp"
#include "problems/layers/read.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/read_raster.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::problems {
namespace reading {
namespace {

constexpr std::string_view kType = "type";

/// The values of `mechanism.type` of a path, that of the four-bar first.
std::vector<std::string_view> path_types() {
  std::vector<std::string_view> words{"four-bar"};
  for (const TopologyWord& topology : topology_words()) words.push_back(topology.word);
  words.push_back(kChainWord);
  return words;
}

std::optional<Raster> read_chain_raster(TableReader& document, const ChainPathProblem& problem) {
  constexpr std::array<std::string_view, 4> kKeys{"length", "pivots", "coupler_point", "crank"};
  const bool is_one = problem.topologies.size() == 1;
  return read_raster(document, kKeys,
                     is_one ? ""
                            : "is given with a type of several topologies; expected a single one, "
                              "as \"watt-1\" or \"chain\"");
}

void check_chain_raster(TableReader& document, const ChainPathProblem& problem) {
  if (!problem.raster || problem.topologies.size() != 1) return;
  const auto off = dimension_off_raster(*problem.raster, problem.topologies.front());
  if (!off) return;
  document.fault("raster", fmt::format("has no value of {} within its bounds [{}, {}]; expected at "
                                       "least one: widen the bounds or refine the raster",
                                       off->name, off->bounds.min, off->bounds.max));
}

// What speaks against robust designs.
std::string_view robust_refusal(const ChainPathProblem& problem) {
  if (const auto why = robust_tolerance_refusal(problem.tolerances); !why.empty()) return why;
  if (problem.raster) return "is given with a raster; remove one of them";
  return {};
}

// What speaks against fronts.
std::string_view front_refusal(const ChainPathProblem& problem) {
  if (problem.raster) return "is given with a raster; remove one of them";
  if (problem.solve.robust) return "is given with robust; remove one of them";
  return {};
}

void read_chain_front(TableReader& table, ChainPathProblem& problem) {
  const bool whole = problem.topologies.size() == 1 && is_given(problem.topologies.front());
  const std::string_view refusal = front_refusal(problem);
  problem.against = read_against(table,
                                 {.mechanism = problem.mechanism,
                                  .topologies = problem.topologies,
                                  .is_given = whole && refusal.empty(),
                                  .refusal = refusal},
                                 problem.solve);
}

/// What is for chains of dyads alone.
void read_with_dyads(TableReader& document, LinkageTables& tables, ChainPathProblem& problem) {
  problem.raster = read_chain_raster(document, problem);
  check_chain_raster(document, problem);
  problem.tolerances = read_chain_tolerances(document, problem.topologies, "length");
  read_robust(tables.solve, robust_refusal(problem), problem.solve);
  read_chain_front(tables.solve, problem);
  problem.layers =
      read_design_layers(document, tables.constraints, links_of(problem.topologies),
                         problem.against ? kNoLayersOfFronts : layers_max_refusal(problem.solve));
}

void read_with_three_pins(TableReader& document, LinkageTables& tables, ChainPathProblem& problem) {
  read_chain_front(tables.solve, problem);
  refuse_with_three_pins(document, tables, problem.constraints.over);
}

/// Without a raster the chain itself may be moved; on one its size counts, which bounds say.
void check_movable(TableReader& target, const ChainPathProblem& problem) {
  constexpr std::string_view kPlace = "place";
  if (!problem.is_movable) return;
  if (!problem.raster) {
    return target.fault(
        kPlace,
        "is \"similar\" without [raster]; a chain without one is moved and enlarged "
        "itself: remove it");
  }
  for (const Topology& topology : problem.topologies) {
    for (const TopologyLine& line : topology.lines) {
      const auto count = static_cast<std::size_t>(parameter_count(line.line.type));
      for (std::size_t i = 0; i < count; ++i) {
        const Range& bound = line.bounds[i];
        const bool turns = parameter_role(line.line.type, static_cast<int>(i)) ==
                           synthesis::ParameterRole::direction;
        if (turns || line.given[i] || std::isfinite(bound.max - bound.min)) continue;
        return target.fault(kPlace, fmt::format("is \"similar\", but point {} has a dimension "
                                                "without bounds; expected bounds.length, pivots "
                                                "and point, which say how large it may be",
                                                line.name));
      }
    }
  }
}

}  // namespace
}  // namespace reading

bool KindTraits<ChainPathProblem>::takes(reading::TableReader& document) {
  if (!document.has_table("mechanism")) return false;
  reading::TableReader mechanism = document.table("mechanism");
  if (!mechanism.has_text(reading::kType)) return false;
  const std::string type = *mechanism.text(reading::kType);
  return type == kChainWord || type == kSliderCrankWord || !from_string<MechanismType>(type);
}

ChainPathProblem KindTraits<ChainPathProblem>::read(reading::TableReader& document,
                                                    const std::filesystem::path& folder) {
  using namespace reading;
  ChainPathProblem problem;
  TableReader mechanism = document.table("mechanism");
  problem.mechanism = mechanism.text(kType).value_or("");
  if (problem.mechanism != kChainWord && topologies(problem.mechanism).empty()) {
    fault_chain_type(document, mechanism, path_types());
    return problem;
  }
  LinkageTables tables(document);
  tables.mechanism.know({kType});
  read_chain_target(tables.target, folder, problem);
  const Wanted wanted = read_traced(tables.target, problem.mechanism, "P");
  problem.topologies = read_topologies(document, tables, topologies(problem.mechanism), wanted);
  problem.constraints = read_chain_constraints(tables.constraints);
  read_chain_solve(tables.solve, problem.solve);
  std::ranges::any_of(problem.topologies, has_three_pin_link)
      ? read_with_three_pins(document, tables, problem)
      : read_with_dyads(document, tables, problem);
  check_movable(tables.target, problem);
  for (TableReader* table :
       {&tables.target, &tables.mechanism, &tables.constraints, &tables.solve}) {
    table->finish();
  }
  problem.warnings = read_warnings(document);
  return problem;
}

}  // namespace cognate::problems
