#include "app/study/problem_atlas.hpp"

#include <fmt/core.h>

#include "app/study/atlas_file.hpp"

namespace cognate::app {

tl::expected<std::vector<problems::AtlasCurve>, std::vector<problems::Fault>> problem_atlas(
    const problems::PathProblem& problem) {
  if (!problem.atlas) return {};
  const auto& atlas = *problem.atlas;
  return read_atlas(atlas.file).map_error([&](const std::string& why) {
    return std::vector{problems::Fault{atlas.line, atlas.column,
                                       fmt::format("solve.atlas is \"{}\": {}", atlas.name, why)}};
  });
}

}  // namespace cognate::app
