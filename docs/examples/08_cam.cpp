// The smallest cam of a flat face that rises by 10 within 90 degrees in harmonic motion, nowhere
// bent more sharply than a circle of radius 5.
#include <cognate/cam.hpp>
#include <cognate/units.hpp>
#include <cstdio>

using namespace cognate::literals;
namespace problems = cognate::problems;
using cognate::cam::MotionLaw;

int main() {
  problems::CamProblem problem;
  problem.follower = cognate::cam::FollowerType::translating_flat;
  problem.motion = {{.law = MotionLaw::harmonic, .over = 90_deg, .rise = 10},
                    {.law = MotionLaw::dwell, .over = 90_deg},
                    {.law = MotionLaw::harmonic, .over = 90_deg, .rise = -10},
                    {.law = MotionLaw::dwell, .over = 90_deg}};
  problem.constraints.curvature_radius_min = 5;

  const problems::CamResult result = solve(problem, {});
  if (result.designs.empty()) return 1;
  // With s = 5 (1 - cos 2 phi) the radius is r + s + s'' = r + 5 + 15 cos 2 phi, at least r - 10.
  std::printf("%s: base radius %.6f\n", problems::to_string(result.status).data(),
              result.designs.front().cam.system.follower.dimensions.base_radius);
}

// solved: base radius 15.000000
