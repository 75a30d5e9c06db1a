/// A search for a cam on several threads, and one that is stopped.
#include <gtest/gtest.h>

#include <atomic>
#include <bit>

#include "tests/support/cam_problems.hpp"

namespace cognate::cam_run_test {
namespace {

using cam::MotionLaw;

/// A cam whose size the curvature limits, so that no half planes give it.
problems::CamProblem searched() {
  problems::CamProblem problem = translating_roller({}, {}, 6);
  problem.motion = {segment(MotionLaw::cycloidal, 70, 20), segment(MotionLaw::cycloidal, 90, -20),
                    segment(MotionLaw::dwell, 200)};
  problem.constraints.pressure_angle_max_rise = 40 * kDegree;
  problem.constraints.pressure_angle_max_return = 50 * kDegree;
  problem.constraints.curvature_radius_min = 12;
  problem.solve.starts = 4;
  problem.solve.designs = 3;
  return problem;
}

std::vector<std::uint64_t> bits_of(const problems::CamResult& result) {
  std::vector<std::uint64_t> bits;
  for (const auto& design : result.designs) {
    const auto& d = design.cam.system.follower.dimensions;
    for (const double number : {d.base_radius, d.offset, d.roller_radius}) {
      bits.push_back(std::bit_cast<std::uint64_t>(number));
    }
    for (const auto& quantity : design.metrics) {
      if (const double* number = std::get_if<double>(&quantity.value)) {
        bits.push_back(std::bit_cast<std::uint64_t>(*number));
      }
    }
  }
  return bits;
}

TEST(CamSolve, ThreadsChangeNoBit) {
  const auto one = solve(searched(), {.threads = 1});
  EXPECT_EQ(one.status, problems::Status::solved);
  ASSERT_FALSE(one.designs.empty());
  EXPECT_TRUE(one.designs[0].origin.starts_with("search")) << one.designs[0].origin;
  for (const int threads : {2, 3}) {
    const auto more = solve(searched(), {.threads = threads});
    EXPECT_EQ(more.work.threads, threads);
    EXPECT_EQ(more.status, one.status);
    EXPECT_EQ(bits_of(more), bits_of(one)) << threads;
    EXPECT_EQ(more.work.positions, one.work.positions);
    EXPECT_EQ(more.work.gradients, one.work.gradients);
  }
}

void expect_some_cam(const problems::CamResult& result) {
  ASSERT_FALSE(result.designs.empty());
  const auto& d = result.designs[0].cam.system.follower.dimensions;
  EXPECT_TRUE(std::isfinite(d.base_radius) && d.base_radius > 0) << d.base_radius;
  EXPECT_LT(std::abs(d.offset), d.base_radius);
  EXPECT_FALSE(result.designs[0].constraints.empty());
}

TEST(CamSolve, RunOutOfTimeStillGivesACam) {
  const auto result = solve(searched(), {.threads = 1, .time_limit = 1e-9});
  EXPECT_EQ(result.status, problems::Status::time_limit);
  expect_some_cam(result);
}

TEST(CamSolve, InterruptedRunStillGivesACam) {
  const std::atomic<bool> interrupted = true;
  const auto result = solve(searched(), {.threads = 2, .interrupted = &interrupted});
  EXPECT_EQ(result.status, problems::Status::interrupted);
  expect_some_cam(result);
}

}  // namespace
}  // namespace cognate::cam_run_test
