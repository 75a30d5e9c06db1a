// Landmarks of coupler curves and cognates in an analysis, held against sampled curves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "problems/evaluation/result.hpp"
#include "tests/support/named_mechanisms.hpp"

namespace cognate::problems::curve_landmarks_test {
namespace {

// Of each assembly a curve with crossings and inflections.
const FourBar kLooping{{0.2, -0.1}, {3.4, 2.3}, 2, 3.5, 3.5, Assembly::open, Vec2d{4, 2}};

AnalysisProblem curves_of(const FourBar& linkage, double start = 0, double end = kTurn) {
  auto problem = analysis_of(named(linkage), 3600);
  problem.drive.start = start;
  problem.drive.end = end;
  problem.output = {.velocity = false, .acceleration = false, .curvature = true};
  return problem;
}

AnalysisResult analyse(const AnalysisProblem& problem) {
  return problems::analyse(problem, Run{.threads = 1});
}

std::vector<Landmark> of_kind(const AnalysisResult& result, const std::string& kind) {
  std::vector<Landmark> found;
  std::ranges::copy_if(result.landmarks, std::back_inserter(found),
                       [&](const Landmark& landmark) { return landmark.kind == kind; });
  return found;
}

const std::vector<double>& values(const AnalysisResult& result, const std::string& name) {
  return std::ranges::find(result.columns, name, &Column::name)->values;
}

Vec2d coupler_point(const FourBar& linkage, double crank_angle) {
  MechanismMotion<0> motion(as_mechanism(linkage));
  EXPECT_TRUE(motion.move_to(crank_angle));
  return motion.point({2, *linkage.coupler_point})[0];
}

// How often the polygon of the sampled curve crosses itself.
int crossings(const AnalysisResult& result) {
  const auto& x = values(result, "P_x");
  const auto& y = values(result, "P_y");
  const auto at = [&](std::size_t i) { return Vec2d{x[i], y[i]}; };
  const auto side = [&](std::size_t i, const Vec2d& p) {
    return cross(at(i + 1) - at(i), p - at(i)) > 0;
  };
  int count = 0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    for (std::size_t j = i + 2; j + 1 < x.size(); ++j) {
      if (i == 0 && j + 2 == x.size()) continue;  // neighbours, where the curve closes
      count += side(i, at(j)) != side(i, at(j + 1)) && side(j, at(i)) != side(j, at(i + 1));
    }
  }
  return count;
}

TEST(CurveLandmarks, DoublePointsArePassedTwice) {
  int found = 0;
  for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
    FourBar linkage = kLooping;
    linkage.assembly = assembly;
    for (const Vec2d point : {Vec2d{4, 2}, Vec2d{5, 3}, Vec2d{5, 4}}) {
      linkage.coupler_point = point;
      auto problem = curves_of(linkage);
      problem.drive.steps = 720;
      const auto result = analyse(problem);
      const auto doubles = of_kind(result, "double point");
      EXPECT_EQ(static_cast<int>(doubles.size()), 2 * crossings(result));
      for (const Landmark& landmark : doubles) {
        EXPECT_EQ(landmark.of, "P");
        ASSERT_TRUE(landmark.again);
        EXPECT_GT(std::abs(*landmark.again - landmark.drive), 0.01);
        EXPECT_NEAR(
            norm(coupler_point(linkage, landmark.drive) - coupler_point(linkage, *landmark.again)),
            0, 1e-12);
      }
      found += static_cast<int>(doubles.size());
    }
  }
  EXPECT_GT(found, 4);
}

TEST(CurveLandmarks, InflectionsAreWhereTheCurvatureChangesItsSign) {
  const auto result = analyse(curves_of(kLooping));
  const auto& curvature = values(result, "P_curvature");
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i + 1 < curvature.size(); ++i) {
    if (std::signbit(curvature[i]) != std::signbit(curvature[i + 1])) rows.push_back(i);
  }
  const auto inflections = of_kind(result, "inflection");
  ASSERT_EQ(inflections.size(), rows.size());
  ASSERT_FALSE(rows.empty());
  for (std::size_t i = 0; i < rows.size(); ++i) {  // both in the order of the motion
    const double row = inflections[i].drive / kTurn * 3600;
    EXPECT_GE(row, static_cast<double>(rows[i]));
    EXPECT_LE(row, static_cast<double>(rows[i] + 1));
  }
}

TEST(CurveLandmarks, OnlyWhatTheDriveComesTo) {
  const auto whole = of_kind(analyse(curves_of(kLooping)), "double point");
  ASSERT_EQ(whole.size() % 2, 0u);
  ASSERT_FALSE(whole.empty());
  const Landmark& first = whole.front();
  const double past = first.drive + 0.01;
  for (const Landmark& landmark : of_kind(analyse(curves_of(kLooping, 0, past)), "double point")) {
    EXPECT_LE(std::max(landmark.drive, *landmark.again), past);
  }
  // Backwards, and from elsewhere, the same places.
  const auto back = of_kind(analyse(curves_of(kLooping, kTurn, 0)), "double point");
  ASSERT_EQ(back.size(), whole.size());
  EXPECT_NEAR(back.back().drive, first.drive, 1e-12);
  const auto later = of_kind(analyse(curves_of(kLooping, -3, kTurn - 3)), "double point");
  EXPECT_EQ(later.size(), whole.size());
}

// A point of the moving centrode stands still when it is the pole.
TEST(CurveLandmarks, PlantedCusp) {
  auto problem = curves_of(kLooping, 0.7, 0.7 + kTurn);
  problem.drive.steps = 1;
  problem.output.instant_geometry = {2};
  const auto geometry = analyse(problem);
  FourBar linkage = kLooping;
  linkage.coupler_point = {values(geometry, "coupler_moving_centrode_u").front(),
                           values(geometry, "coupler_moving_centrode_v").front()};
  const auto cusps = of_kind(analyse(curves_of(linkage)), "cusp");
  ASSERT_EQ(cusps.size(), 1u);
  EXPECT_NEAR(cusps.front().drive, 0.7, 1e-9);
  linkage.assembly = Assembly::crossed;  // the cusp is on the other circuit
  EXPECT_TRUE(of_kind(analyse(curves_of(linkage)), "cusp").empty());
}

TEST(CurveLandmarks, NoneUnlessAskedForAndOnOtherMechanisms) {
  auto problem = curves_of(kLooping);
  problem.output.curvature = false;
  problem.output.position = true;
  const std::set<std::string> kinds{"cusp", "inflection", "double point"};
  const auto has_any = [&](const AnalysisResult& result) {
    return std::ranges::any_of(result.landmarks,
                               [&](const Landmark& l) { return kinds.contains(l.kind); });
  };
  EXPECT_FALSE(has_any(analyse(problem)));
  auto other = analysis_of(named(SliderCrank{.crank = 1, .coupler = 3}), 10);
  other.output.curvature = true;
  EXPECT_FALSE(has_any(analyse(other)));
}

// The timed cognate turns its crank with the linkage; that of the other one stands where it must at
// each start of the drive.
TEST(AnalysedCognates, TraceTheSamePath) {
  for (const double start : {0.0, 1.0, 2.5, -2.0}) {
    auto problem = curves_of(kLooping, start, start + kTurn);
    problem.drive.steps = 10;
    EXPECT_TRUE(analyse(problem).cognates.empty());
    problem.output.cognates = true;
    const auto cognates = analyse(problem).cognates;
    ASSERT_EQ(cognates.size(), 2u);
    ASSERT_TRUE(cognates[0].timed && !cognates[1].timed);
    for (const auto& cognate : cognates) {
      EXPECT_NEAR(norm(coupler_point(cognate.linkage, cognate.crank_angle) -
                       coupler_point(kLooping, start)),
                  0, 1e-12);
    }
    for (const double turn : {0.4, 2.0, 4.0}) {
      EXPECT_NEAR(norm(coupler_point(cognates[0].linkage, cognates[0].crank_angle + turn) -
                       coupler_point(kLooping, start + turn)),
                  0, 1e-12);
    }
  }
}

}  // namespace
}  // namespace cognate::problems::curve_landmarks_test
