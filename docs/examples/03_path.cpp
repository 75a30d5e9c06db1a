// A problem stated in C++: a coupler point is to pass through eight points, which are taken from a
// known coupler curve, so that a four-bar exists that meets them.
#include <cognate/analysis.hpp>
#include <cognate/path.hpp>
#include <cognate/units.hpp>
#include <cstdio>

using namespace cognate::literals;
namespace problems = cognate::problems;

int main() {
  const cognate::FourBar known{.pivot_a = {0, 0},
                               .pivot_d = {4, 0},
                               .crank = 1,
                               .coupler = 3,
                               .rocker = 3.5,
                               .coupler_point = cognate::Vec2d{1.5, 1}};
  problems::PathProblem problem;
  for (int i = 0; i < 8; ++i) {
    problem.points.push_back(*cognate::Motion(known).at(40_deg * i)->coupler_point);
  }
  problem.constraints.required_class = problems::RequiredClass::crank_rocker;
  problem.constraints.transmission_angle = problems::between(20_deg, 160_deg);
  problem.bounds.pivot_a = problems::around({0, 0}, 5);
  for (const std::string& fault : validate(problem)) std::printf("%s\n", fault.c_str());

  const problems::Result result = solve(problem, {.seed = 1});
  if (result.designs.empty()) return 1;
  std::printf("%s\n", problems::to_string(result.status).data());
  std::printf("farthest from a point: %.6f\n", result.designs.front().error.max);
}

// solved
// farthest from a point: 0.000000
