#include "problems/cam/largest_roller.hpp"

#include <algorithm>
#include <cmath>

#include "problems/cam/cam_extremes.hpp"
#include "problems/cam/cam_facts.hpp"
#include "problems/verify.hpp"

namespace cognate::problems {
namespace {

/// What a roller measures at most where the file does not say: of the base radius (usual are 0.1 to
/// 0.5), and of the pitch curve's radius.
constexpr double kOfBase = 0.4, kOfCurvature = 0.8;

double least_radius(const CamProblem& problem) {
  return std::max(0.0, problem.length(CamDimension::roller_radius).bounds.min);
}

double greatest_radius(const CamProblem& problem, cam::Cam cam) {
  const double bound = problem.length(CamDimension::roller_radius).bounds.max;
  if (std::isfinite(bound)) return bound;
  auto& dimensions = cam.system.follower.dimensions;
  dimensions.roller_radius = 0;
  const auto sharpest = CamExtremes(cam).convex_radius();
  const double usual = kOfBase * dimensions.base_radius;
  return sharpest ? std::min(usual, kOfCurvature * sharpest->value) : usual;
}

}  // namespace

bool frees_roller(const CamProblem& problem) {
  const CamLength& roller = problem.length(CamDimension::roller_radius);
  return roller.used && !roller.given && problem.objective != CamObjective::contact_stress;
}

CamProblem without_roller(CamProblem problem) {
  if (frees_roller(problem)) {
    problem.length(CamDimension::roller_radius).given = least_radius(problem);
  }
  return problem;
}

void enlarge_roller(const CamProblem& problem, cam::Cam& cam) {
  constexpr int kHalvings = 52;
  double& radius = cam.system.follower.dimensions.roller_radius;
  const double most = greatest_radius(problem, cam);
  const auto keeps_limits = [&](double tried) {
    radius = tried;
    CamDesign design;
    design.cam = cam;
    return all_satisfied(cam_checks(problem, design, CamExtremes(design.cam)));
  };
  double good = least_radius(problem), bad = most;
  if (keeps_limits(most)) return;
  for (int i = 0; i < kHalvings && bad > good; ++i) {
    const double middle = 0.5 * (good + bad);
    (keeps_limits(middle) ? good : bad) = middle;
  }
  radius = good;
}

}  // namespace cognate::problems
