/// @file `[mechanism]` of the types that their dimensions define.
#pragma once

#include "problems/mechanism/named_mechanism.hpp"
#include "problems/mechanism/named_parts.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// What `[mechanism]` says of a mechanism.
struct ReadMechanism {
  MechanismDescription description;
  Mechanism<double> mechanism;
  NamedParts parts;
  int output = 0;  ///< the body whose motion is the mechanism's output
  bool sound =
      false;  ///< false where a fault was added: then only the names of the parts are right
};

/// The mechanism of `type`, any but a chain.
ReadMechanism read_simple_mechanism(TableReader& mechanism, MechanismType type);

}  // namespace cognate::problems::reading
