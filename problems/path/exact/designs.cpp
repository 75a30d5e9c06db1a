#include "problems/path/exact/designs.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/linkage/prevailing_side.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/crank_sense.hpp"

namespace cognate::problems {
namespace {

using synthesis::PathRoot;
using synthesis::PathSystem;
using synthesis::RootSymmetry;
using Complex = std::complex<double>;

Vec2d vector_of(Complex z) {
  return {z.real(), z.imag()};
}

/// The four-bar of a root, in the system's coordinates.
FourBar linkage_of(const PathRoot& root) {
  const Complex x = root.first.moving, a = root.first.fixed;
  const Complex y = root.second.moving, b = root.second.fixed;
  FourBar linkage;
  linkage.pivot_a = vector_of(a);
  linkage.pivot_d = vector_of(b);
  linkage.crank = std::abs(x - a);
  linkage.coupler = std::abs(y - x);
  linkage.rocker = std::abs(y - b);
  linkage.coupler_point = vector_of(-x * std::conj(y - x) / linkage.coupler);
  return linkage;
}

/// In the caller's plane, dimensions that are given exactly as given.
FourBar in_plane(const FourBar& scaled, const PathSystem& system, const Given& given) {
  FourBar linkage = scaled;
  const auto place = [&](const Vec2d& p) { return system.origin + system.scale * p; };
  linkage.pivot_a = given.pivot_a.value_or(place(scaled.pivot_a));
  linkage.pivot_d = given.pivot_d.value_or(place(scaled.pivot_d));
  linkage.crank = given.crank.value_or(system.scale * scaled.crank);
  linkage.coupler = given.coupler.value_or(system.scale * scaled.coupler);
  linkage.rocker = given.rocker.value_or(system.scale * scaled.rocker);
  linkage.coupler_point = given.coupler_point.value_or(system.scale * *scaled.coupler_point);
  return linkage;
}

/// A linkage of the plane in the system's coordinates, where no digits are lost if the plane's
/// origin is far away.
FourBar seen_from(const PathSystem& system, const FourBar& linkage) {
  FourBar local = linkage;
  for (Vec2d* pivot : {&local.pivot_a, &local.pivot_d}) {
    *pivot = (1 / system.scale) * (*pivot - system.origin);
  }
  for (double* length : {&local.crank, &local.coupler, &local.rocker}) *length /= system.scale;
  *local.coupler_point = (1 / system.scale) * *local.coupler_point;
  return local;
}

/// Where the linkage stands at each of the caller's positions.
std::vector<CrankPosition> stands_of(const FourBar& linkage, const PathSystem& system,
                                     const PathRoot& root) {
  const FourBar local = seen_from(system, linkage);
  const Complex x = root.first.moving, y = root.second.moving;
  std::vector<CrankPosition> positions(system.d.size() + 1);
  const auto stand = [&](int position, Complex turn, Complex d) {
    positions[std::size_t(position)] =
        position_of(local, vector_of(x * turn + d), vector_of(y * turn + d));
  };
  stand(system.reference, 1, 0);
  for (std::size_t j = 0; j < system.d.size(); ++j) {
    stand(system.order[j], root.rotations[j], system.d[j]);
  }
  return positions;
}

/// What the kernel says of the linkage at its positions; empty where it does not close, as rounding
/// may have it at a dead point.
std::vector<std::optional<Pose>> poses_at(const FourBar& linkage,
                                          const std::vector<CrankPosition>& positions) {
  FourBar side = linkage;
  side.assembly = Assembly::open;
  const Motion open(side);
  side.assembly = Assembly::crossed;
  const Motion crossed(side);
  std::vector<std::optional<Pose>> poses;
  for (const CrankPosition& position : positions) {
    const Motion& motion = position.side == Assembly::open ? open : crossed;
    poses.push_back(motion.at(position.crank_angle));
  }
  return poses;
}

/// Distances to the points; the root's own residual stands in where the linkage does not close.
TargetError error_at(const std::vector<std::optional<Pose>>& poses,
                     const std::vector<Vec2d>& points, double residual) {
  TargetError error;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double miss = poses[i] ? norm(*poses[i]->coupler_point - points[i]) : residual;
    error.sum_of_squares += miss * miss;
    error.max = std::max(error.max, miss);
  }
  error.rms = std::sqrt(error.sum_of_squares / double(points.size()));
  return error;
}

/// The largest error of the coupler's turn from the first pose to another; empty where the linkage
/// does not close at one of them.
std::optional<double> angle_error(const std::vector<std::optional<Pose>>& poses,
                                  const std::vector<double>& angles) {
  const auto direction = [](const Pose& pose) {
    const Vec2d coupler = pose.c - pose.b;
    return std::atan2(coupler.y, coupler.x);
  };
  double largest = 0;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    if (!poses[0] || !poses[i]) return std::nullopt;
    const double turn = direction(*poses[i]) - direction(*poses[0]);
    const double error = std::remainder(turn - (angles[i] - angles[0]), kTurn);
    largest = std::max(largest, std::abs(error));
  }
  return largest;
}

/// The linkage of a real root as a design.
std::optional<Design> design_of(const PathSystem& system, const PathRoot& root,
                                const PathProblem& problem) {
  FourBar linkage = in_plane(linkage_of(root), system, problem.given);
  for (const double length : {linkage.crank, linkage.coupler, linkage.rocker}) {
    if (!(length > 0 && std::isfinite(length))) return std::nullopt;
  }
  std::vector<CrankPosition> positions = stands_of(linkage, system, root);
  positions.resize(problem.points.size());  // sampled positions come after the problem's
  linkage.assembly = prevailing_side(positions, &CrankPosition::side);
  const auto poses = poses_at(linkage, positions);
  Design design;
  design.mechanism = named(linkage);
  for (const CrankPosition& position : positions) {
    design.crank_angles.push_back(in_one_turn(position.crank_angle));
  }
  design.error = error_at(poses, problem.points, system.scale * root.residual);
  design.metrics =
      design_metrics(linkage, std::span<const CrankPosition>(positions), {problem.order, false});
  design.metrics.precision_residual = system.scale * root.residual;
  design.metrics.condition = root.condition;
  if (const auto error = angle_error(poses, problem.pose_angles);
      error && problem.pose_angles.size() > 1) {
    design.metrics.quantities.push_back({"angle_error_max_deg", degrees(*error)});
  }
  design.constraints = check_constraints(problem.constraints, problem.bounds, problem.given,
                                         linkage, design.metrics);
  if (problem.crank_sense != CrankSense::either) {
    design.constraints.push_back(check_sense(problem.crank_sense, design.crank_angles));
  }
  return design;
}

/// Every solution that stands for the same curve (or the same poses).
std::vector<PathRoot> same_motion(const PathSystem& system, const PathRoot& root,
                                  RootSymmetry symmetry) {
  std::vector<PathRoot> all{root};
  if (symmetry == RootSymmetry::cognates) {
    const auto three = synthesis::cognates(system, root);
    all.assign(three.begin(), three.end());
  }
  if (symmetry == RootSymmetry::none) return all;
  for (std::size_t i = 0, count = all.size(); i < count; ++i) {
    PathRoot swapped = all[i];
    std::swap(swapped.first, swapped.second);
    all.push_back(swapped);
  }
  return all;
}

/// A direction of the frame is one condition, which its opposite satisfies too.
bool points_the_other_way(const PathProblem& problem, const PathRoot& root) {
  if (!problem.given.frame_angle) return false;
  const double angle = std::arg(root.second.fixed - root.first.fixed);
  return std::abs(std::remainder(angle - *problem.given.frame_angle, kTurn)) > 1;
}

std::ptrdiff_t failed(const Design& design) {
  return std::ranges::count(design.constraints, false, &ConstraintCheck::satisfied);
}

bool is_better_traced(const TracedDesign& a, const TracedDesign& b) {
  const auto fails_a = failed(a.design), fails_b = failed(b.design);
  if (fails_a != fails_b) return fails_a < fails_b;
  const double far_a = violation(a.design.constraints), far_b = violation(b.design.constraints);
  if (far_a != far_b) return far_a < far_b;
  return a.design.metrics.transmission_acute_min > b.design.metrics.transmission_acute_min;
}

}  // namespace

std::vector<synthesis::PathPose> positions_of(const PathProblem& problem) {
  std::vector<synthesis::PathPose> positions;
  for (const Vec2d& point : problem.points) positions.push_back({point, {}});
  for (std::size_t i = 0; i < problem.pose_angles.size(); ++i) {
    positions[i].angle = problem.pose_angles[i];
  }
  return positions;
}

synthesis::FixedParts given_parts(const Given& given) {
  return {.pivot_a = given.pivot_a,
          .pivot_d = given.pivot_d,
          .coupler_point = given.coupler_point,
          .frame_angle = given.frame_angle,
          .crank = given.crank,
          .coupler = given.coupler,
          .rocker = given.rocker,
          .frame = given.frame};
}

int equation_count(const PathProblem& problem) {
  const int poses = std::max<int>(1, int(problem.pose_angles.size()));
  return int(problem.points.size()) - 1 + poses - 1 +
         synthesis::condition_count(given_parts(problem.given));
}

std::vector<TracedDesign> designs_of(const ExactRoots& roots, const PathProblem& problem,
                                     int first_curve) {
  std::vector<TracedDesign> designs;
  int curve = first_curve;
  for (std::size_t i = 0; i < roots.roots.size(); ++i) {
    if (!roots.roots[i].real) continue;
    const bool proved = i < roots.certificates.size() && roots.certificates[i].certified;
    const PathRoot& root = proved ? roots.certificates[i].refined : roots.roots[i];
    for (const PathRoot& solution : same_motion(roots.system, root, roots.symmetry)) {
      if (points_the_other_way(problem, solution)) continue;
      auto design = design_of(roots.system, solution, problem);
      if (!design) continue;
      design->origin = roots.origin;
      designs.push_back({std::move(*design), curve});
    }
    ++curve;
  }
  return designs;
}

std::vector<Design> ranked(std::vector<TracedDesign> designs, int count) {
  std::ranges::stable_sort(designs, is_better_traced);
  if (designs.size() > std::size_t(count)) designs.resize(std::size_t(count));
  std::map<int, int> first_of;
  std::vector<Design> all;
  for (TracedDesign& traced : designs) {
    const auto [first, is_new] = first_of.try_emplace(traced.curve, int(all.size()));
    if (!is_new) traced.design.cognate_of = first->second;
    all.push_back(std::move(traced.design));
  }
  return all;
}

}  // namespace cognate::problems
