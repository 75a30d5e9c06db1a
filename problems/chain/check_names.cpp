#include "problems/chain/check_names.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {

void check_names(const Topology& topology, TableReader& mechanism) {
  std::vector<std::string> taken{"frame", "crank"};
  for (const TopologyLine& line : topology.lines) {
    if (line.name == taken[0] || line.name == taken[1]) {
      mechanism.faults().add(
          mechanism.where(),
          fmt::format("a point has the name {}, which is that of a body; rename the point",
                      in_quotes(line.name)));
    }
    taken.push_back(line.name);
  }
  std::vector<std::string> links = links_of({&topology, 1}).front();
  links.erase(links.begin());  // that of the crank
  for (const std::string& link : links) {
    if (std::ranges::find(taken, link) != taken.end()) {
      mechanism.faults().add(
          mechanism.where(),
          fmt::format("the name {} of a link, made of its points, is taken by another part; "
                      "rename a point",
                      in_quotes(link)));
    }
    taken.push_back(link);
  }
}

}  // namespace cognate::problems::reading
