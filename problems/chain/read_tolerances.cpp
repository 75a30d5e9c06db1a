#include "problems/chain/read_tolerances.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "problems/mechanism/joint_names.hpp"
#include "problems/tolerance/dimensions.hpp"

namespace cognate::problems::reading {
namespace {

/// A chain of this topology, for its names: any dimensions do that lay no two points on each other.
NamedMechanism some_chain(const Topology& topology) {
  synthesis::ChainDesign design;
  design.parameters.resize(static_cast<std::size_t>(parameter_count(chain_of(topology))));
  std::iota(design.parameters.begin(), design.parameters.end(), 1);
  return named(topology, design);
}

void keep_common(std::vector<std::string>& names, const std::vector<std::string>& other) {
  std::erase_if(names, [&](const std::string& name) {
    return std::ranges::find(other, name) == other.end();
  });
}

/// What all of them have.
ToleranceScope common_scope(std::span<const Topology> topologies, std::string_view unit) {
  ToleranceScope scope{.unit = unit};
  for (std::size_t i = 0; i < topologies.size(); ++i) {
    const NamedMechanism chain = some_chain(topologies[i]);
    if (i == 0) {
      scope.dimensions = dimension_groups(chain);
      scope.joints = pin_names(chain);
    } else {
      keep_common(scope.dimensions, dimension_groups(chain));
      keep_common(scope.joints, pin_names(chain));
    }
  }
  return scope;
}

}  // namespace

std::optional<Tolerances> read_chain_tolerances(TableReader& document,
                                                std::span<const Topology> topologies,
                                                std::string_view unit) {
  if (!topologies.empty()) return read_tolerances(document, common_scope(topologies, unit));
  document.know({"tolerance"});  // its names are those of a sound mechanism
  return std::nullopt;
}

}  // namespace cognate::problems::reading
