#include "app/kinds/leg/kind.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "app/console/messages.hpp"
#include "problems/leg/keys.hpp"

namespace cognate::app {
namespace {

using problems::LegObjective;
using problems::LegProblem;

constexpr Entry kLegPartKeys[] = {
    {"target.point", "chain: the foot (default: the last [[point]], else the last joint)"},
    {"mechanism.type",
     "\"klann\" (default), \"jansen\", \"chain\", or a topology of path-generation (chains); parts "
     "and bounds as there"},
    {"constraints.transmission_angle_deg", "[min, max] of every dyad over the turn"},
    {"solve.objectives",
     "[\"error\", and one of \"transmission_angle\", \"size\", \"links\"]: a Pareto front"}};

constexpr QuantityColumn kLegQuantities[] = {{"duty", "duty"},
                                             {"stride", "stride [length]"},
                                             {"step_height", "step height [length]"},
                                             {"flatness", "flatness"},
                                             {"foot_speed_min", "least foot speed"},
                                             {"longest_link", "longest link [length]"},
                                             {"link_count", "links"},
                                             {"topology", "topology"}};

}  // namespace

std::span<const Entry> Kind<LegProblem>::keys() {
  static const auto all = [] {
    using namespace problems::reading;
    std::vector<Entry> entries;
    const auto add = [&](const auto& keys) {
      for (const auto& key : keys) entries.push_back({key.name, key.meaning});
    };
    add(kLegTargetKeys);
    add(kLegMechanismKeys);
    std::ranges::copy(kLegPartKeys, std::back_inserter(entries));
    add(kLegConstraintKeys);
    return entries;
  }();
  return all;
}

std::vector<ListSection> Kind<LegProblem>::sections() {
  std::vector<std::string> meanings;
  for (const auto& [word, meaning] : problems::leg_topology_words()) {
    meanings.push_back(
        fmt::format("{}: {}", meaning, sketch(problems::leg_topologies(word).front())));
  }
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < meanings.size(); ++i) {
    entries.push_back({problems::leg_topology_words()[i].word, meanings[i]});
  }
  return {list_section("leg_topologies", "topologies of legs (mechanism.type = ...)", entries)};
}

std::string Kind<LegProblem>::describe(const LegProblem& problem) {
  const auto& target = problem.target;
  const bool longest = target.objective == LegObjective::duty;
  return titled(problem.title,
                longest ? fmt::format("leg ({}), stride {}, longest stance within flatness {}",
                                      problem.mechanism, target.stride, *target.flatness_max)
                        : fmt::format("leg ({}), stride {}, flattest stance over {} of the turn",
                                      problem.mechanism, target.stride, target.duty));
}

ColumnChoice Kind<LegProblem>::columns(const LegProblem& /*problem*/) {
  return {.error_unit = "length", .quantities = kLegQuantities};
}

nlohmann::ordered_json Kind<LegProblem>::target_json(const LegProblem& problem) {
  const auto& topology = problem.topologies.front();
  const auto foot = static_cast<std::size_t>(topology.trace);
  return {{"kind", "leg"}, {"point", topology.lines[foot].name}};
}

}  // namespace cognate::app
