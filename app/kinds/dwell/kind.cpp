#include "app/kinds/dwell/kind.hpp"

#include <fmt/core.h>

#include "app/console/messages.hpp"
#include "problems/basics/degrees.hpp"

namespace cognate::app {
namespace {

using problems::DwellProblem;

constexpr Entry kDwellKeys[] = {
    {"target.dwell",
     "[{ over_deg = 100 }]: the angle of the crank over which the output stands still; one or two"},
    {"target.dwell.from_deg", "the crank angle at which it begins (default: found)"},
    {"target.dwell.half_band_deg_max", "the most deviation of the output from its middle there"},
    {"target.apart_deg", "two dwells: by how much the output differs between them at least"},
    {"target.swing_deg_min", "the least swing of the output over the turn"},
    {"target.output",
     "[\"G\", \"F\"] (default): the output's angle is that from G to F; of a chain also the name "
     "of a slider"},
    {"target.stroke_min", "of a slider: its least stroke; also apart and dwell.half_band_max"},
    {"mechanism.type",
     "\"six-bar\" (default), \"stephenson-3\", \"watt-2\", \"three-pin\", or \"chain\"; with a "
     "slider as output \"six-bar-slider\", \"stephenson-3-slider\", \"watt-2-slider\"; parts and "
     "bounds as of path-generation (chains)"},
    {"constraints.transmission_angle_deg", "[min, max] of every dyad over the turn"},
    {"solve.objectives",
     "[\"error\", and one of \"transmission_angle\", of a slider \"size\"]: a Pareto front"}};

constexpr QuantityColumn kDwellQuantities[] = {
    {"half_band_deg", "half band [deg]"},      {"swing_deg", "swing [deg]"},
    {"half_band", "half band [length]"},       {"stroke", "stroke [length]"},
    {"dwell_from_deg", "from [deg]"},          {"dwell_2_from_deg", "second from [deg]"},
    {"longest_link", "longest link [length]"}, {"topology", "topology"}};

std::string angles_of(const DwellProblem& problem) {
  std::string text;
  for (const problems::Dwell& dwell : problem.dwells) {
    text += fmt::format("{}{}", text.empty() ? "" : " and ", problems::degrees(dwell.over));
  }
  return text;
}

}  // namespace

std::span<const Entry> Kind<DwellProblem>::keys() {
  return kDwellKeys;
}

std::vector<ListSection> Kind<DwellProblem>::sections() {
  std::vector<std::string> meanings;
  for (const auto& [word, meaning] : problems::function_topology_words()) {
    const auto stands_for = problems::function_topologies(word);
    meanings.emplace_back(meaning);
    if (stands_for.size() == 1) meanings.back() += ": " + sketch(stands_for.front());
  }
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < meanings.size(); ++i) {
    entries.push_back({problems::function_topology_words()[i].word, meanings[i]});
  }
  return {list_section("function_topologies",
                       "topologies of functions and dwells (mechanism.type = ...)", entries)};
}

std::string Kind<DwellProblem>::describe(const DwellProblem& problem) {
  return titled(problem.title, fmt::format("function generation ({}), dwell over {} degrees",
                                           problem.mechanism, angles_of(problem)));
}

ColumnChoice Kind<DwellProblem>::columns(const DwellProblem& problem) {
  return {.error_unit = problems::slides(problem) ? "length" : "deg",
          .quantities = kDwellQuantities};
}

nlohmann::ordered_json Kind<DwellProblem>::target_json(const DwellProblem& /*problem*/) {
  return {{"kind", "dwell"}};
}

}  // namespace cognate::app
