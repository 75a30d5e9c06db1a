/// @file The names of the links of mechanisms that are yet to be designed.
#pragma once

#include <string>
#include <vector>

#include "problems/layers/read.hpp"
#include "problems/mechanism/mechanism_types.hpp"

namespace cognate::problems {

/// Those of mechanisms of these types, whatever their dimensions.
template <class... Type>
reading::LinkNames links_of() {
  const auto names = [](const NamedParts& parts) {
    std::vector<std::string> links;
    for (std::size_t body = 1; body < parts.bodies.size(); ++body) {
      links.push_back(parts.bodies[body].name);
    }
    return links;
  };
  return {names(TypeTraits<Type>::parts(Type{}))...};
}

}  // namespace cognate::problems
