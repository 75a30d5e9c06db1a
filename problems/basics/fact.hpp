/// @file A named value that a result tells.
#pragma once

#include <string>
#include <variant>

namespace cognate::problems {

struct Fact {
  std::string name;  ///< as in `cognate list --metrics`, with its unit
  std::variant<double, std::string, bool> value;
};

}  // namespace cognate::problems
