/// The path model: exact derivatives, and the linkage that its variables stand for.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/linkage/motion.hpp"
#include "problems/path/model.hpp"

namespace cognate::problems::path_model_test {
namespace {

const FourBar linkage{{0.2, -0.3}, {2.1, 0.9}, 0.8, 1.9, 1.6, Assembly::open, Vec2d{1.1, 0.7}};
const std::vector<double> angles{0.4, 0.9, 1.7, 2.2, 3.0};

PathProblem planted(Timing timing, CrankReference reference = CrankReference::first) {
  PathProblem problem;
  problem.timing = timing;
  problem.crank_reference = reference;
  for (const double angle : angles) {
    problem.points.push_back(*Motion(linkage).at(angle)->coupler_point);
    const double from_frame = angle - frame_angle(linkage);
    if (timing == Timing::mixed) problem.has_crank_angle = {false, true, false, true, true};
    if (timing != Timing::free) {
      problem.crank_angles.push_back(reference == CrankReference::frame ? from_frame : angle);
    }
  }
  return problem;
}

struct Case {
  const char* name;
  PathProblem problem;
};

std::vector<Case> cases() {
  std::vector<Case> all{{"free", planted(Timing::free)},
                        {"first", planted(Timing::prescribed, CrankReference::first)},
                        {"frame", planted(Timing::prescribed, CrankReference::frame)},
                        {"global", planted(Timing::prescribed, CrankReference::global)},
                        {"mixed, first", planted(Timing::mixed, CrankReference::first)},
                        {"mixed, frame", planted(Timing::mixed, CrankReference::frame)}};
  for (const Timing timing : {Timing::free, Timing::prescribed, Timing::mixed}) {
    PathProblem fixed = planted(timing, CrankReference::global);
    fixed.given.pivot_d = linkage.pivot_d;
    fixed.given.coupler = linkage.coupler;
    fixed.weights = {1, 2, 0.5, 1, 3};
    fixed.bounds.pivot_a = Box{{-1, -1}, {1, 1}};
    fixed.constraints.required_class = RequiredClass::crank_rocker;
    all.push_back({"anchored at D, coupler fixed, weighted", fixed});
    fixed.given.pivot_d.reset();
    fixed.constraints.pivot_region = Box{{-2, -2}, {3, 3}};
    all.push_back({"pivot region", fixed});
    fixed.given.pivot_a = linkage.pivot_a;
    fixed.given.frame_angle = frame_angle(linkage);
    all.push_back({"frame line fixed", fixed});
  }
  return all;
}

TEST(PathModel, HasNoResidualAtAPlantedDesign) {
  for (const auto& [name, problem] : cases()) {
    SCOPED_TRACE(name);
    const PathModel model(problem, linkage.assembly, false);
    const auto x = model.variables_of(linkage, angles);
    ASSERT_EQ(x.size(), model.variables().size());
    std::vector<double> r(static_cast<std::size_t>(model.residual_count()));
    ASSERT_TRUE(model.residuals(x, r, {}, {}));
    for (const double value : r) EXPECT_NEAR(value, 0, 1e-14);

    const FourBar back = model.linkage(x);
    EXPECT_NEAR(back.crank, linkage.crank, 1e-15);
    EXPECT_NEAR(back.pivot_d.x, linkage.pivot_d.x, 1e-14);
    EXPECT_NEAR(back.pivot_a.y, linkage.pivot_a.y, 1e-14);
    const auto crank = model.crank_angles(x);
    for (std::size_t j = 0; j < angles.size(); ++j) EXPECT_NEAR(crank[j], angles[j], 1e-14);
  }
}

TEST(PathModel, CountsIncrementsClockwiseOnRequest) {
  PathProblem problem = planted(Timing::prescribed);
  for (double& angle : problem.crank_angles) angle = 5 - angle;
  const PathModel model(problem, linkage.assembly, true);
  std::vector<double> r(10);
  ASSERT_TRUE(model.residuals(model.variables_of(linkage, angles), r, {}, {}));
  for (const double value : r) EXPECT_NEAR(value, 0, 1e-14);
}

TEST(PathModel, DerivativesAgreeWithCentralDifferences) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> noise(-0.05, 0.05);
  for (const auto& [name, problem] : cases()) {
    SCOPED_TRACE(name);
    const PathModel model(problem, linkage.assembly, false);
    auto x = model.variables_of(linkage, angles);
    for (double& value : x) value += noise(random);
    const auto rows = static_cast<std::size_t>(model.residual_count());
    const auto limits = static_cast<std::size_t>(model.constraint_count());
    const auto globals = static_cast<std::size_t>(model.global_count());
    const bool has_locals = model.local_count() > 0;
    std::vector<double> r(rows), up(rows), down(rows), jacobian(rows * globals);
    std::vector<double> local(has_locals ? rows : 0);
    std::vector<double> c(limits), c_up(limits), c_down(limits), c_jacobian(limits * globals);
    ASSERT_TRUE(model.residuals(x, r, jacobian, local));
    model.constraints(x, c, c_jacobian);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double step = 1e-5;
      auto higher = x, lower = x;
      higher[i] += step;
      lower[i] -= step;
      ASSERT_TRUE(model.residuals(higher, up, {}, {}));
      ASSERT_TRUE(model.residuals(lower, down, {}, {}));
      for (std::size_t row = 0; row < rows; ++row) {
        const double slope = (up[row] - down[row]) / (2 * step);
        double stated = 0;
        if (i < globals) {
          stated = jacobian[row * globals + i];
        } else if (model.local_of_residual()[row] == static_cast<int>(i - globals)) {
          stated = local[row];
        }
        EXPECT_NEAR(stated, slope, 1e-7 * (1 + std::abs(slope)))
            << "residual " << row << " by " << model.variables()[i].name;
      }
      model.constraints(higher, c_up, {});
      model.constraints(lower, c_down, {});
      for (std::size_t row = 0; row < limits; ++row) {
        const double slope = (c_up[row] - c_down[row]) / (2 * step);
        const double stated = i < globals ? c_jacobian[row * globals + i] : 0;
        EXPECT_NEAR(stated, slope, 1e-7 * (1 + std::abs(slope)))
            << "constraint " << row << " by " << model.variables()[i].name;
      }
    }
  }
}

TEST(PathModel, LimitsTheOtherPivotToItsBox) {
  PathProblem problem = planted(Timing::free);
  problem.bounds.pivot_d = Box{{2.0, 0.5}, {2.5, 0.8}};
  const PathModel model(problem, linkage.assembly, false);
  ASSERT_EQ(model.constraint_count(), 4);
  std::vector<double> c(4);
  model.constraints(model.variables_of(linkage, angles), c, {});
  EXPECT_NEAR(c[0], 0.1, 1e-14);   // 2.1 − 2.0
  EXPECT_NEAR(c[1], 0.4, 1e-14);   // 2.5 − 2.1
  EXPECT_NEAR(c[2], 0.4, 1e-14);   // 0.9 − 0.5
  EXPECT_NEAR(c[3], -0.1, 1e-14);  // 0.8 − 0.9: outside
}

TEST(PathModel, HasNoValueWhereTheLinkageDoesNotClose) {
  const PathModel model(planted(Timing::free), linkage.assembly, false);
  auto x = model.variables_of(linkage, angles);
  x[PathModel::coupler] = 0.01;
  std::vector<double> r(10);
  EXPECT_FALSE(model.residuals(x, r, {}, {}));
}

}  // namespace
}  // namespace cognate::problems::path_model_test
