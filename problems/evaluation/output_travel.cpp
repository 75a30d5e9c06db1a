#include "problems/evaluation/output_travel.hpp"

#include "analysis/mechanism/sliding_pairs.hpp"

namespace cognate::problems {

Travel output_travel(const NamedMechanism& mechanism) {
  const auto body = static_cast<std::size_t>(mechanism.output);
  if (turning_bodies(mechanism.mechanism)[body]) return Travel{.body = mechanism.output};
  return travels(mechanism.mechanism)[body];
}

}  // namespace cognate::problems
