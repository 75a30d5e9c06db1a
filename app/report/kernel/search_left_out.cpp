/// @file What the search in a page leaves out: the solvers of other libraries, and starts from
/// exact synthesis through nine points, which take longer than a hand waits.
#include "problems/path/exact/starts.hpp"
#include "synthesis/optimise/gauss_newton.hpp"

namespace cognate {

synthesis::Solution synthesis::solve(Solver /*solver*/, const Model& model,
                                     std::span<const double> start, const Options& options) {
  Options own = options;
  own.learns_curvature = true;
  return solve_gauss_newton(model, start, own);
}

bool problems::has_exact_starts(const PathProblem& /*problem*/) {
  return false;
}

std::vector<problems::PathStart> problems::exact_starts(const PathProblem& /*problem*/,
                                                        const Run& /*run*/,
                                                        const Deadline& /*deadline*/) {
  return {};
}

}  // namespace cognate
