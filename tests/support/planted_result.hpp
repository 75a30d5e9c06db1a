/// @file A result made by hand, with a value of its own in every place.
#pragma once

#include <limits>

#include "analysis/numbers/constants.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {

inline PathProblem planted_path() {
  PathProblem problem;
  problem.title = "Planted path";
  problem.points = {{0.1, 0.2}, {1.0 / 3, 2}, {3, 4}};
  problem.weights = {1, 1, 1};
  problem.bounds.crank = Range{0, 60};
  problem.bounds.rocker = Range{2, kInfinity};
  return problem;
}

inline Design planted_design() {
  Design design;
  design.mechanism = named(FourBar{.pivot_a = {-1.0 / 3, 0.1},
                                   .pivot_d = {4, 3 + 0.1},
                                   .crank = 1.1,
                                   .coupler = 2.0 / 7,
                                   .rocker = 4e-17,
                                   .assembly = Assembly::crossed,
                                   .coupler_point = Vec2d{0.3, -0.7}});
  design.crank_angles = {0, kPi / 4, 6.1};
  design.error = {.sum_of_squares = 1e-300, .rms = 0.0625, .max = 0.125};
  design.metrics = {.mobility = MobilityClass::rocker_crank,
                    .change_point = true,
                    .transmission_min = kPi / 6,
                    .transmission_max = 3 * kPi / 4,
                    .transmission_acute_min = kPi / 9,
                    .time_ratio = 1.25,
                    .defects = {Defect::branch, Defect::order},
                    .input_start = kPi / 3,
                    .output_start = -kRightAngle,
                    .precision_residual = 1e-15,
                    .condition = 12.5};
  design.constraints = {{"link_ratio_max", 7.5, 5.0, false},
                        {"class", std::string("rocker-crank"), std::string("crank-rocker"), false},
                        {"bounds.rocker", 4e-17, Range{2, kInfinity}, true}};
  design.origin = "exact:three-pairs + ceres";
  return design;
}

/// Design 1 meets everything; design 2 is its cognate and violates two constraints.
inline Result planted_result() {
  Design sound = planted_design();
  sound.metrics.defects.clear();
  sound.metrics.time_ratio.reset();
  sound.constraints = {{"link_ratio_max", 4.5, 5.0, true}};
  Design violating = planted_design();
  violating.cognate_of = 0;
  return {.status = Status::solved,
          .designs = {sound, violating},
          .work = {.seconds = 0.5,
                   .threads = 2,
                   .candidates = 11,
                   .positions = 22,
                   .velocities = 33,
                   .accelerations = 44,
                   .gradients = 55,
                   .solver_iterations = 66,
                   .skipped = {"velocities"}},
          .notes = {"A note."}};
}

inline MotionProblem planted_motion() {
  MotionProblem problem;
  problem.title = "Planted motion";
  problem.poses = {{{0, 0}, 0}, {{1, 0.5}, 0.25}, {{2, 0}, 0.5}};
  return problem;
}

/// What an exact synthesis finds: a four-bar, a slider-crank that is its mirror image, curves with
/// a gap, a family with a gap, facts of which two have no number.
inline Result planted_synthesis() {
  Design slider = planted_design();
  slider.mechanism =
      named(SliderCrank{.pivot = {1, 2}, .crank = 0.5, .coupler = 2.5, .offset = -0.125});
  slider.metrics = {.transmission_min = kPi / 4,
                    .transmission_max = 3 * kPi / 4,
                    .transmission_acute_min = kPi / 4,
                    .precision_residual = 2e-16,
                    .condition = kInfinity,
                    .quantities = {{"class", std::string("crank turns fully")},
                                   {"swing.least_deg", 12.5},
                                   {"certified", true},
                                   {"of_nothing", kInfinity}}};
  slider.constraints.clear();
  slider.mirror_of = 0;
  slider.origin = "exact:three-poses";
  const double none = std::numeric_limits<double>::quiet_NaN();
  return {.status = Status::solved,
          .designs = {planted_design(), slider},
          .loci = {{"centre-point curve", {{{0, 1}, {2, 3}, {kInfinity, 0}, {4, 5}}}},
                   {"poles", {{{6, 7}}}}},
          .families = {{"fixed pivot", {{"at", {1, 2, 3}}, {"swing_deg", {30, none, 50}}}}},
          .quantities = {{"complex_solutions", 1442.0}, {"ratio", none}, {"real.triplets", 21.0}},
          .work = {.seconds = 0.25}};
}

}  // namespace cognate::problems
