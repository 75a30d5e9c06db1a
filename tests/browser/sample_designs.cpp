#include "tests/browser/sample_designs.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Vec2d polar(double length, double angle) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

/// Where axes fixed at `at` in the body numbered 2, turned by `turn`, stand at a drive coordinate.
synthesis::Pose pose_of_coupler(const Mechanism<double>& mechanism, double drive, const Vec2d& at,
                                double turn) {
  MechanismMotion<0> motion(mechanism);
  motion.move_to(drive);
  const auto& body = motion.bodies()[2];
  return {point_motion(body, at)[0], std::atan2(body.direction.y, body.direction.x) + turn};
}

Design exact_design(NamedMechanism mechanism, std::vector<double> stations, std::string origin) {
  Design design{.mechanism = std::move(mechanism), .crank_angles = std::move(stations)};
  design.origin = "exact:" + std::move(origin);
  design.metrics.precision_residual = 3e-16;
  design.metrics.condition = 14.2;
  design.constraints = {{"no_branch_defect", std::string("none"), std::string("none"), true}};
  return design;
}

Design four_bar_design(const FourBar& linkage, std::vector<double> stations, std::string origin) {
  Design design = exact_design(named(linkage), std::move(stations), std::move(origin));
  const auto metrics = design_metrics(linkage, design.crank_angles, {});
  design.metrics.mobility = metrics.mobility;
  design.metrics.transmission_min = metrics.transmission_min;
  design.metrics.transmission_max = metrics.transmission_max;
  design.metrics.transmission_acute_min = metrics.transmission_acute_min;
  design.metrics.time_ratio = metrics.time_ratio;
  design.metrics.defects = metrics.defects;
  return design;
}

/// A circular cubic that runs to infinity, like a centre-point curve.
Locus cubic(const std::string& name, const Vec2d& at, double size, double turn) {
  Locus locus{.name = name, .branches = {{}}};
  for (int i = -600; i <= 600; ++i) {
    const double t = std::tan(0.5 * kPi * i / 601.0);
    const Vec2d point = size / (1 + t * t) * Vec2d{0.4 * t * t + 1, t * (0.4 * t * t - 1)};
    locus.branches.front().push_back(at + polar(1, turn) * point);
  }
  return locus;
}

/// Four poses of a coupler; a four-bar that takes them, other types that do not quite.
SampleResult motion() {
  const FourBar linkage{.pivot_a = {0, 0},
                        .pivot_d = {4, 0.5},
                        .crank = 1,
                        .coupler = 3.4,
                        .rocker = 2.6,
                        .coupler_point = Vec2d{1.6, 1.3}};
  const SliderCrank slider_crank{.pivot = {0.2, 0.1}, .crank = 1.05, .coupler = 3.3, .offset = 0.6};
  const OscillatingBlock block{.pivot_a = {0, 0}, .pivot_c = {3.4, 1.8}, .crank = 1, .offset = 0.3};
  const EllipticTrammel trammel{.centre = {1, 0}, .length = 3};
  const std::vector<double> stations = {0.4, 1.2, 2.1, 3.0};
  MotionProblem problem;
  problem.title = "A flap through four poses";
  for (const double at : stations) {
    problem.poses.push_back(pose_of_coupler(as_mechanism(linkage), at, {1.6, 1.3}, 0.5));
  }
  Result result{.status = Status::solved};
  result.designs = {four_bar_design(linkage, stations, "four-poses"),
                    exact_design(named(slider_crank), stations, "four-poses"),
                    exact_design(named(block), stations, "four-poses"),
                    exact_design(named(trammel), {0.3, 0.8, 1.2, 1.5}, "four-poses")};
  result.designs[1].metrics.quantities = {{"class", std::string("crank turns fully")},
                                          {"pressure_angle_max_deg", 28.5}};
  result.designs[2].error = {.sum_of_squares = 0.01, .rms = 0.05, .max = 0.08};
  result.loci = {cubic("centre-point curve", {0.5, -0.5}, 3, 0.6),
                 cubic("circle-point curve", {2, 1}, 2, -0.8),
                 {.name = "poles", .branches = {{{2.2, -0.4}}, {{1.2, 1.9}}, {{3.1, 0.8}}}}};
  result.quantities = {{"real_dyads", 12.0}, {"complex_dyads", 40.0}, {"poses", 4.0}};
  result.notes = {"The centre-point curve is unbounded; there the dyad is a slider."};
  return {"motion", problem, result};
}

/// Crank-rockers of one time ratio, over the angle of the crank pivot on its circle.
SampleResult quick_return() {
  QuickReturnProblem problem;
  problem.title = "Quick return, K = 1.25";
  problem.time_ratio = 1.25;
  Result result{.status = Status::solved};
  Family family{
      .name = "crank pivot on its circle",
      .columns = {
          {"crank_pivot_deg", {}}, {"transmission_least_deg", {}}, {"crank", {}}, {"frame", {}}}};
  for (int i = 0; i <= 120; ++i) {
    const double at = 3.0 * i;
    const bool gap = i > 50 && i < 70;
    family.columns[0].values.push_back(at);
    family.columns[1].values.push_back(gap ? kNone : 35 + 20 * std::sin(at * kPi / 180));
    family.columns[2].values.push_back(gap ? kNone : 60 + 30 * std::cos(at * kPi / 180));
    family.columns[3].values.push_back(gap ? kNone : 240 - 0.2 * at);
  }
  for (const double sign : {1.0, -1.0}) {
    const FourBar linkage{.pivot_a = {-196.07 * sign, 196.07},
                          .pivot_d = {0, 0},
                          .crank = 77.293,
                          .coupler = 215.085,
                          .rocker = 290,
                          .assembly = sign > 0 ? Assembly::open : Assembly::crossed};
    result.designs.push_back(four_bar_design(linkage, {}, "quick-return"));
    result.designs.back().metrics.quantities = {{"crank_pivot_deg", sign > 0 ? 100.0 : 240.0},
                                                {"swing_deg", 34.0}};
  }
  result.designs.back().mirror_of = 0;
  const GuideBar guide{.pivot_a = {0, 300}, .pivot_c = {0, 0}, .crank = 52.1};
  result.designs.push_back(exact_design(named(guide), {}, "quick-return"));
  result.families = {family};
  return {"quick-return", problem, result};
}

/// Chebyshev's linkage along its straight stretch, with curves of its local theory.
SampleResult straight_line() {
  StraightLineProblem problem;
  problem.title = "Straight line by local theory";
  const FourBar linkage{.pivot_a = {0, 0},
                        .pivot_d = {4, 0},
                        .crank = 5,
                        .coupler = 2,
                        .rocker = 5,
                        .assembly = Assembly::crossed,
                        .coupler_point = Vec2d{1, 0}};
  Result result{.status = Status::solved};
  result.designs = {four_bar_design(linkage, {0.95}, "inflection")};
  result.designs.front().metrics.quantities = {{"straight_length_at_0_001", 2.125},
                                               {"crank_from_deg_at_0_001", 40.1},
                                               {"crank_to_deg_at_0_001", 71.6}};
  Locus circle{.name = "inflection circle", .branches = {{}}};
  for (int i = 0; i <= 180; ++i) {
    circle.branches.front().push_back(Vec2d{2, 2.6} + polar(1.4, i * kPi / 90));
  }
  result.loci = {circle,
                 {.name = "Ball's point", .branches = {{{2, 4}}}},
                 {.name = "inflection line", .branches = {{{-40, 5}, {50, 6}}}}};
  return {"straight-line", problem, result};
}

/// Two hundred four-bars through nine points, most of them double rockers.
SampleResult nine_points() {
  PathProblem problem;
  problem.title = "Nine points, all solutions";
  problem.method = PathMethod::exact;
  FourBar linkage{.pivot_a = {0, 0},
                  .pivot_d = {4, 0.5},
                  .crank = 1,
                  .coupler = 3.4,
                  .rocker = 2.6,
                  .coupler_point = Vec2d{1.6, 1.3}};
  std::vector<double> stations;
  for (int i = 0; i < 9; ++i) {
    stations.push_back(0.7 * i);
    problem.points.push_back(*Motion(linkage).at(0.7 * i)->coupler_point);
  }
  Result result{.status = Status::solved,
                .quantities = {{"complex_solutions", 1442.0}, {"real_triplets", 64.0}}};
  for (int i = 0; i < 200; ++i) {
    linkage.rocker = 2.6 + 0.003 * i;
    linkage.crank = i % 2 == 0 ? 1 : 2.9;
    result.designs.push_back(four_bar_design(linkage, stations, "nine-point"));
    Design& design = result.designs.back();
    design.constraints = check_constraints({}, {}, {}, linkage, design.metrics);
    if (i % 3 != 0) design.cognate_of = i - i % 3;
    design.metrics.quantities = {{"certified", true}};
  }
  return {"nine-points", problem, result};
}

}  // namespace

std::vector<SampleResult> sample_designs() {
  return {motion(), quick_return(), straight_line(), nine_points()};
}

}  // namespace cognate::problems
