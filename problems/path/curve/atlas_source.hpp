/// @file The atlas that a path problem names.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace cognate::problems {

/// `solve.atlas`: the study file with whose curves a search for a closed curve begins. Who solves
/// the problem reads it; that it is no atlas is then a fault of the problem file, at this place.
struct AtlasSource {
  std::string name;            ///< as written
  std::filesystem::path file;  ///< in the folder of the problem file
  std::size_t line = 1, column = 1;
};

}  // namespace cognate::problems
