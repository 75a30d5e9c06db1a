#include "app/kinds/chain/kind.hpp"

#include <fmt/core.h>

#include "app/console/messages.hpp"
#include "app/documents/json_values.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::ChainPathProblem;
using problems::Topology;

constexpr Entry kChain[] = {
    {"mechanism.type",
     "a topology of the list below, tried in turns where it stands for several; or \"chain\""},
    {"target.points", "[[x, y], ...]; 3 to 10000"},
    {"target.closed", "whether the first follows the last (default: the last repeats the first)"},
    {"target.curve", "or: a closed curve; svg_path, svg, svg_id and samples as of four-bars"},
    {"target.place",
     "of a closed path with [raster]: \"given\" (default), or \"similar\": it may be moved, turned "
     "and "
     "enlarged"},
    {"target.timing", "\"free\" (default), or \"prescribed\" by crank_deg"},
    {"target.crank_deg", "the crank's angle at each point, of which differences count"},
    {"target.point", "chain: the traced point (default: the last [[point]], else the last joint)"},
    {"[[pivot]]", "name, at = [x, y]: here and below, what is missing or \"free\" is found"},
    {"[crank]", "of a chain: at, pin; length"},
    {"[[dyad]]", "of a chain: joins = [\"B\", \"D\"], new; lengths = [l1, l2], assembly"},
    {"slide",
     "of a [[dyad]] with type = \"RRP\", a slider: {through, direction_deg, offset}, the offset "
     "from "
     "the pivot through (default: the crank's) to the left; it joins one point, with a length"},
    {"[[point]]", "of a chain: name, on = [\"B\", \"C\"]; at = [u, v], origin B, first axis to C"},
    {"bounds.length", "[min, max] of the crank and the links of all dyads"},
    {"bounds.pivots", "[[xmin, ymin], [xmax, ymax]]"},
    {"bounds.point", "[[umin, vmin], [umax, vmax]] of the points on links"},
    {"bounds.NAME",
     "of one point: a box; of the crank's pin [min, max]; of a dyad's joint [[min1, max1], [min2, "
     "max2]]; of a slider's pin [min, max] of its link, NAME-slide [min, max] of its offset"},
    {"constraints.transmission_angle_deg", "[min, max] of every dyad"},
    {"constraints.over",
     "where that holds: \"turn\" (default) of the crank, or \"range\", from the first to the last "
     "point"},
    {"constraints.rms_error_max", "the most root mean square of the distances"},
    {"solve.objectives",
     "[\"error\", and one of \"transmission_angle\", \"size\", \"links\"]: a Pareto front; with "
     "\"links\" and type = \"any\" the best chain of each number of links"}};

constexpr QuantityColumn kTopology{"topology", "topology"};
constexpr QuantityColumn kChainQuantities[] = {kTopology};
constexpr QuantityColumn kLinkQuantities[] = {{"link_count", "links"}, kTopology};
constexpr QuantityColumn kSizeQuantities[] = {{"longest_link", "longest link [length]"}, kTopology};

std::span<const QuantityColumn> quantities_of(const ChainPathProblem& problem) {
  if (problem.against == problems::ChainMeasure::links) return kLinkQuantities;
  if (problem.against == problems::ChainMeasure::size) return kSizeQuantities;
  if (problem.topologies.size() > 1) return kChainQuantities;
  return {};
}

/// Every topology that files know by a word has one name for it.
std::string traced_name(const ChainPathProblem& problem) {
  const Topology& topology = problem.topologies.front();
  return topology.lines[static_cast<std::size_t>(topology.trace)].name;
}

/// "Stephenson III six-bar: crank AB; C(B, D); …".
std::string meaning_of(const problems::TopologyWord& word) {
  const auto stands_for = problems::topologies(word.word);
  const std::string meaning(word.meaning);
  return stands_for.size() == 1 ? meaning + ": " + sketch(stands_for.front()) : meaning;
}

}  // namespace

std::span<const Entry> Kind<ChainPathProblem>::keys() {
  return kChain;
}

std::vector<ListSection> Kind<ChainPathProblem>::sections() {
  std::vector<std::string> meanings;
  for (const auto& word : problems::topology_words()) meanings.push_back(meaning_of(word));
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < meanings.size(); ++i) {
    entries.push_back({problems::topology_words()[i].word, meanings[i]});
  }
  return {list_section("topologies", "topologies of paths (mechanism.type = ...)", entries)};
}

std::string Kind<ChainPathProblem>::describe(const ChainPathProblem& problem) {
  return titled(problem.title,
                fmt::format("path generation, {}, {} points{}, {} timing", problem.mechanism,
                            problem.points.size(), problem.closed ? " of a closed path" : "",
                            problem.crank_angles.empty() ? "free" : "prescribed"));
}

ColumnChoice Kind<ChainPathProblem>::columns(const ChainPathProblem& problem) {
  return {.error_unit = "length", .quantities = quantities_of(problem)};
}

ordered_json Kind<ChainPathProblem>::target_json(const ChainPathProblem& problem) {
  ordered_json points = ordered_json::array();
  for (const Vec2d& point : problem.points) points.push_back(app::to_json(point));
  return {{"kind", "path"}, {"points", points}, {"point", traced_name(problem)}};
}

ordered_json Kind<ChainPathProblem>::reached_json(const ChainPathProblem& problem,
                                                  const problems::Design& design) {
  return reached_points(design, traced_name(problem));
}

}  // namespace cognate::app
