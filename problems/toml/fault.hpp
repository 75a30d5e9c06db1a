/// @file A fault of a file.
#pragma once

#include <cstddef>
#include <string>

namespace cognate::problems {

/// One fault of a file. Lines and columns count from 1.
struct Fault {
  std::size_t line = 1;
  std::size_t column = 1;
  std::string message;  ///< what is wrong; what is allowed
};

}  // namespace cognate::problems
