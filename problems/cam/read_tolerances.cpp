#include "problems/cam/read_tolerances.hpp"

#include "problems/basics/names.hpp"
#include "problems/cam/toleranced_length.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems::reading {

void check_cam_tolerances(TableReader& document, const CamProblem& problem) {
  for (const auto& [name, dimension] : names<CamDimension>()) {
    const auto& given = problem.length(dimension).given;
    if (!given) continue;
    const auto made = toleranced_length(problem, dimension, *given);
    if (!made) return fault_impossible(document, made.error().group, made.error().reason);
  }
}

}  // namespace cognate::problems::reading
