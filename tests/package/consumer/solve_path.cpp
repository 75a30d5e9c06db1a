// A problem stated and solved in C++: a point passes through eight places of a known coupler curve.
#include <cmath>
#include <cognate/analysis/linkage/motion.hpp>
#include <cognate/problems/kinds.hpp>
#include <cognate/problems/linkage/result.hpp>
#include <cstdio>

int main() {
  const cognate::FourBar known{.pivot_a = {0, 0},
                               .pivot_d = {4, 0},
                               .crank = 1,
                               .coupler = 3,
                               .rocker = 3.5,
                               .coupler_point = cognate::Vec2d{1.5, 1}};
  const cognate::Motion motion(known);
  cognate::problems::PathProblem problem;
  for (int i = 0; i < 8; ++i) problem.points.push_back(*motion.at(0.7 * i)->coupler_point);

  const cognate::problems::Result result = solve(problem, {.seed = 1});
  if (result.status != cognate::problems::Status::solved || result.designs.empty()) return 1;
  const double miss = result.designs.front().error.max;
  std::printf("largest distance from a point: %.3g\n", miss);
  return miss < 1e-9 ? 0 : 1;
}
