#include "problems/cam/largest_roller.hpp"

#include <algorithm>
#include <cmath>

#include "problems/cam/extremes.hpp"
#include "problems/cam/quantities.hpp"
#include "problems/cam/second_contact.hpp"
#include "problems/linkage/verify.hpp"

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

/// `problem` with those limits alone that a roller's radius matters to.
CamProblem limits_of_radius(const CamProblem& problem) {
  CamProblem limits = problem;
  limits.constraints = {};
  limits.constraints.curvature_radius_min = problem.constraints.curvature_radius_min;
  limits.constraints.profile_radius_min = problem.constraints.profile_radius_min;
  limits.has_operation = false;
  return limits;
}

}  // namespace

bool frees_roller(const CamProblem& problem) {
  const CamLength& roller = problem.length(CamDimension::roller_radius);
  const CamConstraints& c = problem.constraints;
  const bool helps = problem.objective == CamObjective::contact_stress || c.contact_stress_max ||
                     c.concave_radius_min || c.profile_radius_max;
  return roller.used && !roller.given && !helps;
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
  const CamProblem limits = limits_of_radius(problem);
  const auto keeps_limits = [&](double tried) {
    radius = tried;
    CamDesign design;
    design.cam = cam;
    if (problem.second.closure == cam::Closure::conjugate) {
      design.second = conjugate_cam(cam, problem.second);
    }
    return all_satisfied(cam_checks(limits, design, CamExtremes(design.cam)));
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
