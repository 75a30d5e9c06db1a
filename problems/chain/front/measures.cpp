#include "problems/chain/front/measures.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/quantity_key.hpp"

namespace cognate::problems {
namespace {

double least_transmission(const std::vector<Topology>&, const Design& design) {
  return design.metrics.transmission_acute_min;
}

bool limit_transmission(ChainDemand& demand, double least) {
  Range& limit = demand.transmission_angle;
  limit = {std::max(limit.min, least), std::min(limit.max, kPi - least)};
  return limit.min < limit.max;
}

double longest_length(const std::vector<Topology>& topologies, const Design& design) {
  const Topology& topology = topology_of(topologies, design);
  const auto chain = dimensions(topology, design.mechanism);
  double longest = 0;
  for (const auto& [line, parameter] : synthesis::placed_lines(chain_of(topology))) {
    if (!synthesis::has_lengths(line.type)) continue;
    for (int i = 0; i < synthesis::parameter_count(line.type); ++i) {
      const int place = parameter + i;
      longest = std::max(longest, chain.parameters[static_cast<std::size_t>(place)]);
    }
  }
  return longest;
}

bool limit_length(ChainDemand& demand, double greatest) {
  for (Topology& topology : demand.topologies) {
    for (TopologyLine& line : topology.lines) {
      if (!synthesis::has_lengths(line.line.type)) continue;
      const auto count = static_cast<std::size_t>(synthesis::parameter_count(line.line.type));
      for (std::size_t i = 0; i < count; ++i) {
        Range& bound = line.bounds[i];
        bound.max = std::min(bound.max, greatest);
        if (bound.min > bound.max || line.given[i].value_or(0) > greatest) return false;
      }
    }
  }
  return true;
}

constexpr ChainMeasureRule kRules[] = {
    {ChainMeasure::transmission_angle, "transmission_angle_deg.acute_min", true, kRightAngle,
     kPi / 36, least_transmission, limit_transmission},
    {ChainMeasure::size, "longest_link", false, 0, 0.2, longest_length, limit_length}};

}  // namespace

double ChainMeasureRule::shown(double value) const {
  return greatest_is_best ? degrees(value) : value;
}

const ChainMeasureRule& rule_of(ChainMeasure measure) {
  return *std::ranges::find(kRules, measure, &ChainMeasureRule::measure);
}

const Topology& topology_of(const std::vector<Topology>& topologies, const Design& design) {
  const auto name = find_quantity(design.metrics.quantities, QuantityKey<std::string>{"topology"});
  return *std::ranges::find(topologies, name.value_or(""), &Topology::name);
}

}  // namespace cognate::problems
