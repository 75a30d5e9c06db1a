/// @file `[mechanism]`, written down.
#pragma once

#include "problems/mechanism/named_mechanism.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// `[mechanism]`, from its description.
TableWriter mechanism_writer(const NamedMechanism& mechanism);

}  // namespace cognate::problems::reading
