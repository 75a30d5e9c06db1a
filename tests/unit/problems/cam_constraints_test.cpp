/// Every constraint of a cam, held against dense sampling; optima of searches against scans.
#include <gtest/gtest.h>

#include <functional>

#include "analysis/cam/profile.hpp"
#include "problems/cam/extremes.hpp"
#include "problems/linkage/verify.hpp"
#include "tests/support/cam_problems.hpp"

namespace cognate::cam_constraints_test {
namespace {

using cam::Cam;
using cam::CamQuantity;
using cam::MotionLaw;
using problems::CamDimension;
using problems::CamObjective;
using problems::CamProblem;
using problems::Status;

CamProblem given_roller() {
  CamProblem problem = translating_roller(45, 6, 9);
  problem.motion = {segment(MotionLaw::modified_sine, 100, 35), segment(MotionLaw::dwell, 40),
                    segment(MotionLaw::polynomial_345, 90, -35), segment(MotionLaw::dwell, 130)};
  problem.operation = {3, 8, 40, 20000, 30, 0.5, 1e-6};
  problem.preload = 20000;
  problem.has_operation = problem.has_contact = true;
  return problem;
}

/// The greatest of `of(point of the profile, motion, system)` over 10000 positions.
using Sampled = std::function<double(const cam::ProfilePoint&, const cam::FollowerMotion<double>&)>;
double greatest(const Cam& cam, const Sampled& of) {
  double most = -HUGE_VAL;
  const cam::CamCurve curve{cam.system, cam.programme,
                            -cam.system.follower.dimensions.roller_radius};
  const int pieces = int(cam.programme.pieces().size());
  for (int piece = 0; piece < pieces; ++piece) {
    constexpr int kPlaces = 2000;
    for (int i = 0; i <= kPlaces; ++i) {
      const double t = double(i) / kPlaces;
      const auto m = motion_at(cam.programme.pieces()[std::size_t(piece)], t);
      most = std::max(most, of(curve_point(curve, piece, t), m));
    }
  }
  return most;
}

/// One limit: how it is set, and the sampled value that it bounds (negative for a lower bound).
struct Limit {
  const char* name;
  std::function<void(problems::CamConstraints&, double)> set;
  Sampled value;
  double sign = 1;
};

std::vector<Limit> limits_of(const Cam& cam) {
  const auto quantity = [&cam](CamQuantity q) {
    return [&cam, q](const cam::ProfilePoint&, const cam::FollowerMotion<double>& m) {
      return value_of(q, cam.system, m);
    };
  };
  using C = problems::CamConstraints;
  const auto radius = [](const cam::ProfilePoint& p, const auto&) { return norm(p.at); };
  return {
      {"pressure_angle_deg_max", [](C& c, double v) { c.pressure_angle_max = v; },
       [&cam](const auto&, const auto& m) {
         const auto& d = cam.system.follower.dimensions;
         const double s0 = std::sqrt(d.base_radius * d.base_radius - d.offset * d.offset);
         return std::abs(std::atan((m.velocity - d.offset) / (s0 + m.displacement)));
       }},
      {"curvature_radius_min", [](C& c, double v) { c.curvature_radius_min = v; },
       [](const auto& p, const auto&) { return p.curvature > 0 ? -1 / p.curvature : -HUGE_VAL; },
       -1},
      {"concave_radius_min", [](C& c, double v) { c.concave_radius_min = v; },
       [](const auto& p, const auto&) { return p.curvature < 0 ? 1 / p.curvature : -HUGE_VAL; },
       -1},
      {"profile_radius_min", [](C& c, double v) { c.profile_radius_min = v; },
       [](const auto& p, const auto&) { return -norm(p.at); }, -1},
      {"profile_radius_max", [](C& c, double v) { c.profile_radius_max = v; }, radius},
      {"contact_force_max", [](C& c, double v) { c.contact_force_max = v; },
       quantity(CamQuantity::contact_force)},
      {"torque_max", [](C& c, double v) { c.torque_max = v; },
       [&cam](const auto&, const auto& m) {
         return std::abs(value_of(CamQuantity::torque, cam.system, m));
       }},
      {"contact_stress_max", [](C& c, double v) { c.contact_stress_max = v; },
       [&cam](const auto&, const auto& m) {
         return std::sqrt(value_of(CamQuantity::squared_stress, cam.system, m));
       }}};
}

// A bound a hair wider than the sampled extreme is kept, one a hair narrower is not.
TEST(CamConstraints, AreKeptOrMissedByAHair) {
  const CamProblem problem = given_roller();
  const Cam cam = solve(problem, {.threads = 1}).designs.at(0).cam;
  for (const Limit& limit : limits_of(cam)) {
    const double extreme = limit.sign * greatest(cam, limit.value);
    for (const double hair : {1e-5, -1e-5}) {
      CamProblem bounded = problem;
      limit.set(bounded.constraints, extreme * (1 + limit.sign * hair));
      const auto result = solve(bounded, {.threads = 1});
      EXPECT_EQ(result.status, hair > 0 ? Status::solved : Status::infeasible) << limit.name;
      const auto& checks = result.designs.at(0).constraints;
      const auto check = std::ranges::find(checks, limit.name, &problems::ConstraintCheck::name);
      ASSERT_NE(check, checks.end()) << limit.name;
      EXPECT_EQ(check->satisfied, hair > 0) << limit.name;
    }
  }
}

/// Whether a translating roller keeps the problem's limits at many positions.
bool keeps(const CamProblem& problem, const cam::MotionProgramme& programme, double offset,
           double start, double slack) {
  cam::CamSystem<double> system;
  system.follower.dimensions.base_radius = std::hypot(offset, start);
  system.follower.dimensions.offset = offset;
  const double roller = *problem.length(CamDimension::roller_radius).given;
  const auto& c = problem.constraints;
  system.start = start;
  for (int i = 0; i < 720; ++i) {
    const auto m = programme.at(i * 0.5 * kDegree);
    const auto state = roller_state(system.follower, start, m);
    if (std::abs(std::atan(state.across / state.along)) > *c.pressure_angle_max + slack)
      return false;
    const double curvature = pitch_curvature(state);
    if (curvature > 0 && 1 / curvature - roller < *c.curvature_radius_min - slack) return false;
  }
  return true;
}

// No cam of a fine scan over offset and height is smaller than what the search finds under limits
// of pressure angle and curvature.
TEST(CamConstraints, SearchIsAsGoodAsAScan) {
  std::mt19937_64 random(61);
  for (int run = 0; run < 2; ++run) {
    CamProblem problem = translating_roller({}, {}, 6);
    problem.motion = random_motion(random, 20);
    problem.constraints.pressure_angle_max = 35 * kDegree;
    problem.constraints.curvature_radius_min = 10;
    const auto result = solve(problem, {.threads = 1});
    ASSERT_EQ(result.status, Status::solved) << run;
    const auto& design = result.designs.at(0);
    const double found = design.cam.system.follower.dimensions.base_radius;
    double best = HUGE_VAL;
    for (double offset = -found; offset <= found; offset += found / 60) {
      for (double start = found / 60; start < found; start += found / 60) {
        if (std::hypot(offset, start) < std::min(best, 0.995 * found) &&
            keeps(problem, design.cam.programme, offset, start, 0)) {
          best = std::hypot(offset, start);
        }
      }
    }
    EXPECT_GE(best, 0.995 * found) << run;
    EXPECT_TRUE(keeps(problem, design.cam.programme, design.cam.system.follower.dimensions.offset,
                      design.cam.system.start, 1e-7));
  }
}

// The objectives other than size: no offset of a scan does better at the given base radius.
TEST(CamConstraints, ObjectivesAreLeastInAScan) {
  for (const auto objective : {CamObjective::pressure_angle, CamObjective::contact_force}) {
    CamProblem problem = given_roller();
    problem.length(CamDimension::offset).given.reset();
    problem.objective = objective;
    const auto value = [&](const Cam& cam) {
      return greatest(cam, [&](const auto&, const auto& m) {
        return objective == CamObjective::pressure_angle
                   ? std::abs(value_of(CamQuantity::pressure_angle, cam.system, m))
                   : value_of(CamQuantity::contact_force, cam.system, m);
      });
    };
    const double found = value(solve(problem, {.threads = 1}).designs.at(0).cam);
    for (double offset = -40; offset <= 40; offset += 5) {
      problem.length(CamDimension::offset).given = offset;
      const double other = value(solve(problem, {.threads = 1}).designs.at(0).cam);
      EXPECT_GE(other, found * (1 - 1e-6)) << offset;
    }
  }
}

// A free roller is the largest that keeps every limit: one a hair larger breaks one, or the rule's
// own bounds.
TEST(CamConstraints, FreeRollersAreAsLargeAsTheyMayBe) {
  CamProblem problem = given_roller();
  problem.constraints.curvature_radius_min = 25;
  problem.length(CamDimension::roller_radius).given.reset();
  problem.length(CamDimension::roller_radius).bounds = {1, 30};
  const auto result = solve(problem, {.threads = 1});
  ASSERT_EQ(result.status, Status::solved);
  const double found = result.designs.at(0).cam.system.follower.dimensions.roller_radius;
  EXPECT_GT(found, 1);
  EXPECT_LT(found, 29);
  for (const double share : {1 - 1e-8, 1 + 1e-8}) {
    problem.length(CamDimension::roller_radius).given = share * found;
    EXPECT_EQ(solve(problem, {.threads = 1}).status,
              share < 1 ? Status::solved : Status::infeasible);
  }
  // Without an upper bound: 0.4 of the base radius here, the profile being round enough.
  problem.constraints.curvature_radius_min = 0.0;
  problem.length(CamDimension::roller_radius).given.reset();
  problem.length(CamDimension::roller_radius).bounds = {0, HUGE_VAL};
  problem.motion[0].rise = 1;
  problem.motion[2].rise = -1;
  const auto usual = solve(problem, {.threads = 1});
  EXPECT_NEAR(usual.designs.at(0).cam.system.follower.dimensions.roller_radius, 0.4 * 45, 1e-12);
}

// Where the pitch curve is sharp the roller is 0.8 of its least radius, by dense sampling.
TEST(CamConstraints, FreeRollersLeaveTheProfileRound) {
  CamProblem problem = translating_roller(30, 0, {});
  problem.motion = {segment(MotionLaw::harmonic, 40, 20), segment(MotionLaw::harmonic, 40, -20),
                    segment(MotionLaw::dwell, 280)};
  const Cam cam = solve(problem, {.threads = 1}).designs.at(0).cam;
  const double sharpest = greatest(cam, [&cam](const auto&, const auto& m) {
    return value_of(CamQuantity::pitch_curvature, cam.system, m);
  });
  ASSERT_LT(0.8 / sharpest, 0.4 * 30);
  EXPECT_NEAR(cam.system.follower.dimensions.roller_radius, 0.8 / sharpest, 1e-6);
}

// A sudden drop of the velocity is a corner that any roller undercuts; a sudden growth leaves an
// arc of the roller's own radius.
TEST(CamConstraints, CornersOfThePitchCurve) {
  CamProblem problem = translating_roller(30, 0, 10);
  problem.motion = {segment(MotionLaw::constant_velocity, 180, 20),
                    segment(MotionLaw::constant_velocity, 180, -20)};
  auto result = solve(problem, {.threads = 1});
  EXPECT_EQ(result.status, Status::infeasible);
  const problems::CamExtremes extremes(result.designs.at(0).cam);
  EXPECT_EQ(extremes.convex_radius()->value, -10);
  EXPECT_NEAR(extremes.convex_radius()->angle, 180 * kDegree, 1e-12);
  EXPECT_EQ(extremes.concave_radius()->value, 10);
  problem.constraints.curvature_radius_min.reset();
  EXPECT_EQ(solve(problem, {.threads = 1}).status, Status::solved);
}

// Free shares never exceed 1 together, and no fixed ones of a scan have a smaller greatest force.
TEST(CamConstraints, FreeSharesAreLeastInAScan) {
  int tested = 0;
  using problems::MotionParameter;
  CamProblem problem = translating_roller(45, 0, 6);
  problem.motion = {segment(MotionLaw::universal, 60, 25), segment(MotionLaw::dwell, 20),
                    segment(MotionLaw::modified_sine, 250, -25), segment(MotionLaw::dwell, 30)};
  problem.motion[0].shape = {1.0 / 3, 1.0 / 3, 1.0 / 3};
  problem.free_motion = {{0, MotionParameter::sine, {0.2, 0.8}},
                         {0, MotionParameter::constant, {0.2, 0.8}},
                         {0, MotionParameter::cosine, {0.2, 0.8}}};
  problem.operation.speed = 100;
  problem.operation.inertia = 1;
  problem.operation.preload = 1e5;
  problem.preload = 1e5;
  problem.has_operation = true;
  problem.constraints.no_separation = false;
  problem.objective = CamObjective::contact_force;
  const auto found = solve(problem, {.threads = 1});
  ASSERT_EQ(found.status, Status::solved);
  const auto& shape = found.designs.at(0).motion[0].shape;
  EXPECT_LE(shape.sine + shape.constant + shape.cosine, 1 + 1e-12);
  const auto force = [](const problems::CamResult& result) {
    return problems::CamExtremes(result.designs.at(0).cam).contact_force(false).value;
  };
  problem.free_motion.clear();
  for (const double sine : {0.2, 0.3, 0.4, 0.5, 0.6}) {
    for (const double constant : {0.2, 0.3, 0.4, 0.5, 0.6}) {
      for (const double cosine : {0.2, 0.3, 0.4, 0.5, 0.6}) {
        if (sine + constant + cosine > 1) continue;
        ++tested;
        problem.motion[0].shape = {sine, constant, cosine};
        EXPECT_LE(force(found), force(solve(problem, {.threads = 1})) * (1 + 1e-6))
            << sine << ' ' << constant << ' ' << cosine;
      }
    }
  }
  EXPECT_GE(tested, 31);
}

// Bounds larger than what the limits need: the cam is as large as its bound, in the same direction.
TEST(CamConstraints, BoundsOfTheBaseRadiusHold) {
  CamProblem problem = translating_roller({}, {}, 2);
  problem.motion = given_roller().motion;
  problem.constraints.pressure_angle_max = 30 * kDegree;
  const auto free = solve(problem, {.threads = 1});
  const double least = free.designs.at(0).cam.system.follower.dimensions.base_radius;
  problem.length(CamDimension::base_radius).bounds = {1.5 * least, HUGE_VAL};
  auto result = solve(problem, {.threads = 1});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_NEAR(result.designs.at(0).cam.system.follower.dimensions.base_radius, 1.5 * least,
              1e-12 * least);
  problem.length(CamDimension::base_radius).bounds = {0, 0.9 * least};
  result = solve(problem, {.threads = 1});
  EXPECT_EQ(result.status, Status::infeasible);
  // What the limits need is shown with its proof, not searched for.
  EXPECT_NEAR(result.designs.at(0).cam.system.follower.dimensions.base_radius, least,
              1e-12 * least);
  EXPECT_TRUE(result.designs[0].proof);
  // For a given cam that is too small, the message says what it needs.
  problem = translating_roller(0.8 * least, 0, 2);
  problem.motion = given_roller().motion;
  problem.constraints.pressure_angle_max = 30 * kDegree;
  result = solve(problem, {.threads = 1});
  EXPECT_EQ(result.status, Status::infeasible);
  EXPECT_TRUE(std::ranges::any_of(result.notes, [](const std::string& note) {
    return note.find("need a base radius of at least") != std::string::npos;
  }));
}

}  // namespace
}  // namespace cognate::cam_constraints_test
