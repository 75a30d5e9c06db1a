/// @file The search for paths of slider-cranks in a page.
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/report/kernel/sketched.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/chain/minima_designs.hpp"
#include "problems/chain/problem.hpp"
#include "problems/chain/read_design.hpp"
#include "problems/chain/scaled.hpp"
#include "problems/chain/search.hpp"
#include "problems/chain/starts/known.hpp"
#include "problems/chain/verify.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::page {
namespace {

using json = nlohmann::ordered_json;
using problems::ChainPathProblem;
using problems::Design;
using problems::Topology;
using problems::reading::radians;

constexpr std::string_view kTopologyKey = "topology";

Topology slider_crank() {
  return problems::topologies(problems::kSliderCrankWord).front();
}

/// Points to be met in any timing, with what the file format has for limits.
std::size_t read_slider_path(problems::reading::LinkageTables& tables, ChainPathProblem& problem) {
  using namespace problems::reading;
  auto& [target, mechanism, bounds, constraints, solve] = tables;
  target.know({"timing"});
  mechanism.know({"type"});
  require_target(target, "points");
  const auto points =
      target.twos("points", kNumber, "[x, y]", {.min = 3, .max = kMostTargets, .of = "points"});
  for (const Two& point : points.value_or(std::vector<Two>{})) {
    problem.points.push_back({point[0], point[1]});
  }
  problem.closed = target.boolean("closed").value_or(false);
  problem.topologies = {slider_crank()};
  read_chain_bounds(bounds, problem.topologies);
  problem.constraints.transmission_angle =
      read_chain_transmission(constraints).value_or(problem.constraints.transmission_angle);
  read_chain_solve(solve, problem.solve);
  return problem.points.size();
}

/// Dimensions in the order of the topology's lines: pivot, crank, direction and offset of the
/// guide, coupler, and the point on it.
synthesis::ChainDesign dimensions_of(const std::vector<double>& row) {
  const int ahead = row[8] == 1 ? 1 : -1;
  return {{row[0], row[1], row[2], radians(row[3]), row[4], row[5], row[6], row[7]},
          {0, 0, 0, ahead, 0}};
}

/// Rows of the pivot, the crank's length, direction of the guide in degrees and its offset, the
/// coupler's length, the point on it, 1 where the slider is ahead of the crank's pin, and the
/// crank's angle at each of the targets, in degrees.
std::vector<Design> read_slider_cranks(problems::reading::TableReader& document,
                                       std::size_t targets) {
  constexpr std::size_t kFirst = 9, kMost = 20;
  const Topology topology = slider_crank();
  std::vector<Design> known;
  const auto rows = document.each_row("known", kFirst + targets, problems::reading::kNumber,
                                      "rows of nine numbers and the crank's angles",
                                      {.max = kMost, .of = "designs"});
  for (const auto& row : rows) {
    if (!row) continue;
    Design design;
    design.mechanism = problems::named(topology, dimensions_of(*row));
    design.metrics.quantities.push_back({std::string(kTopologyKey), topology.name});
    for (std::size_t i = kFirst; i < row->size(); ++i) {
      design.crank_angles.push_back(radians((*row)[i]));
    }
    known.push_back(std::move(design));
  }
  return known;
}

std::vector<Design> solved(const ChainPathProblem& problem, const problems::Run& run) {
  const problems::Deadline none(run);
  const problems::TargetScale scale(problem.points);
  if (!(scale.size > 0)) return {};
  const std::vector<problems::ScaledChain> chains{{problem, problem.topologies.front(), scale}};
  problems::Work work;
  const auto found =
      search_chains(chains, problem.solve, run, none, work, known_starts(run.known, chains, scale));
  auto designs = designs_of_minima(problem, scale, found.designs);
  std::erase_if(designs, [](const Design& one) { return !all_satisfied(one.constraints); });
  return designs;
}

json slider_crank_of(const Design& design) {
  const auto [v, side] = problems::dimensions(slider_crank(), design.mechanism);
  return {{"type", problems::kSliderCrankWord},
          {"pivot", {v[0], v[1]}},
          {"crank", v[2]},
          {"coupler", v[5]},
          {"offset", v[4]},
          {"direction_deg", problems::degrees(v[3])},
          {"assembly", side[3] == 1 ? "open" : "crossed"},
          {"coupler_point", {v[6], v[7]}}};
}

}  // namespace

json sketched_slider_cranks(const SketchQuestion& question) {
  return answered<ChainPathProblem>(
      question, read_slider_path,
      [](const auto& problem, const auto& run) { return solved(problem, run); }, read_slider_cranks,
      slider_crank_of);
}

}  // namespace cognate::page
