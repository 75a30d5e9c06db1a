/// @file A named value reported with a result.
#pragma once

#include <string>
#include <variant>

namespace cognate::problems {

struct Quantity {
  std::string name;  ///< as in `cognate list --metrics`, with its unit
  std::variant<double, std::string, bool> value;
};

}  // namespace cognate::problems
