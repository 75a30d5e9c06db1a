#include "problems/chain/output/body.hpp"

#include <algorithm>

#include "problems/chain/places.hpp"

namespace cognate::problems {

int output_body(const Topology& topology, const std::array<std::string, 2>& output) {
  const ChainPlaces places(chain_of(topology).lines);
  const auto line = [&](const std::string& name) {
    const auto found = std::ranges::find(topology.lines, name, &TopologyLine::name);
    return static_cast<int>(found - topology.lines.begin());
  };
  return places.common_body(line(output[0]), line(output[1])).value_or(places.body_count() - 1);
}

}  // namespace cognate::problems
