// Atlases as starts: curves planted in one are found again by their shape wherever they are put,
// and files that are no atlas are refused in words.
#include "problems/path/atlas_starts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "analysis/coupler_curve/circuit_samples.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "app/study/atlas_file.hpp"
#include "app/study/database.hpp"
#include "problems/read.hpp"
#include "problems/study/four_bar_study.hpp"
#include "tests/support/study_samples.hpp"

namespace cognate::problems::atlas_starts_test {
namespace {

using namespace std::string_literals;

CurveRoom curve_of(const FourBar& linkage, std::size_t steps) {
  CurveRoom curve;
  sample_circuit(linkage, {linkage.assembly, 1}, CycleTable(steps), curve);
  return curve;
}

std::vector<Vec2d> points_of(const FourBar& linkage, std::size_t steps) {
  const CurveRoom curve = curve_of(linkage, steps);
  std::vector<Vec2d> points;
  for (std::size_t i = 0; i < steps; ++i) points.push_back({curve.x[i], curve.y[i]});
  return points;
}

/// Crank-rockers with points all about the coupler.
std::vector<AtlasCurve> atlas() {
  std::mt19937_64 random(5);
  const auto draw = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  std::vector<AtlasCurve> curves;
  while (curves.size() < 300) {
    const FourBar linkage{{0, 0},
                          {draw(1.5, 5), 0},
                          1,
                          draw(1.5, 5),
                          draw(1.5, 5),
                          Assembly::open,
                          Vec2d{draw(-1, 4), draw(-3, 3)}};
    const auto links = lengths(linkage);
    if (!crank_rotates(links) || transmission_angles(links).acute_min < 0.4) continue;
    curves.push_back({linkage, DescriptorFinder()(curve_of(linkage, 512).samples())});
  }
  return curves;
}

/// The problem of `target`, moved by p → shift + factor·p after a mirroring or none.
PathProblem problem_of(std::vector<Vec2d> target, const Vec2d& factor, const Vec2d& shift,
                       bool mirrored) {
  for (Vec2d& point : target) point = shift + factor * (mirrored ? conj(point) : point);
  PathProblem problem;
  problem.curve = TargetCurve{ClosedCurve(target), "", CurvePlace::given};
  problem.points = problem.curve->curve.equally_spaced(40);
  problem.constraints.full_turn = true;
  return problem;
}

TEST(AtlasStarts, APlantedCurveComesFirstWhereverItIsPut) {
  const auto curves = atlas();
  for (const std::size_t planted : {3, 77, 150, 222, 290}) {
    for (const bool mirrored : {false, true}) {
      std::vector<Vec2d> target = points_of(curves[planted].linkage, 720);
      if (planted % 2 == 1) std::ranges::reverse(target);
      std::ranges::rotate(target, target.begin() + 100);
      const Vec2d factor{0.7, -1.9};
      const PathProblem problem = problem_of(target, factor, {30, -12}, mirrored);
      const auto starts = atlas_starts(problem, curves, 10);
      ASSERT_EQ(starts.size(), 10U);
      const FourBar& found = *starts.front().mechanism.four_bar();
      EXPECT_NEAR(found.crank, norm(factor) * curves[planted].linkage.crank, 0.02);
      EXPECT_NEAR(found.coupler, norm(factor) * curves[planted].linkage.coupler, 0.05);
      const Motion motion(found);
      ASSERT_EQ(starts.front().crank_angles.size(), 40U);
      for (std::size_t i = 0; i < 40; ++i) {
        const auto pose = motion.at(starts.front().crank_angles[i]);
        ASSERT_TRUE(pose.has_value());
        // Within the step of the crank, a 256th of a turn.
        EXPECT_LT(norm(*pose->coupler_point - problem.points[i]), 0.3) << i;
      }
    }
  }
}

TEST(AtlasStarts, ASearchOfNothingElseEndsAtThePlantedCurve) {
  const auto curves = atlas();
  PathProblem problem = problem_of(points_of(curves[41].linkage, 720), {2, 1}, {5, 5}, false);
  problem.bounds.crank = problem.bounds.coupler = problem.bounds.rocker = Range{0.1, 100};
  problem.solve.starts = 0;
  problem.solve.designs = 1;
  problems::Run run{.threads = 1};
  run.known = atlas_starts(problem, curves, 5);
  const Result result = solve(problem, run);
  ASSERT_FALSE(result.designs.empty()) << (result.notes.empty() ? "" : result.notes[0]);
  EXPECT_LT(result.designs.front().error.max, 1e-3);
}

TEST(SquaredDistance, IsThatOfTheShapesAlone) {
  const auto curves = atlas();
  for (const std::size_t i : {0, 50, 100}) {
    const auto& own = curves[i].descriptors;
    std::vector<Vec2d> mirrored;
    for (const Vec2d& p : ClosedCurve(points_of(curves[i].linkage, 2048)).equally_spaced(512)) {
      mirrored.push_back(conj(p));
    }
    double length = 0;
    for (std::size_t k = 0; k < 512; ++k) length += norm(mirrored[(k + 1) % 512] - mirrored[k]);
    EXPECT_LT(squared_distance(own, descriptors_of(mirrored, length)), 1e-5) << i;
    EXPECT_GT(squared_distance(own, curves[i + 1].descriptors), 1e-4) << i;
  }
}

/// A study of 3 × 2 linkages, stored; without `left_out` among its metrics.
std::filesystem::path stored_study(const tests::TestFolder& folder, const std::string& left_out) {
  Study study;
  study.title = "Six";
  study.base = "base.toml";
  study.base_text =
      "kind = \"analysis\"\n[mechanism]\ntype = \"four-bar\"\nfixed_pivots = [[0, 0], [3, 0]]\n"
      "crank = 1.0\ncoupler = 3.1\nrocker = 2.5\ncoupler_point = [1, 1]\n";
  study.variables = {{.key = "mechanism.coupler", .path = {"mechanism"s, "coupler"s}},
                     {.key = "mechanism.coupler_point[1]",
                      .path = {"mechanism"s, "coupler_point"s, std::size_t{1}}}};
  study.variables[0].values = {2.6, 3.1, 9};  // the last cannot be assembled
  study.variables[1].values = {-1.5, 2};
  for (const char* name : {"m4", "m3", "m2", "m1", "p1", "p2", "p3", "p4"}) {
    study.metrics.push_back("fourier."s + name);
    if (name[1] != '1') study.metrics.push_back("fourier_phase_deg."s + name);
  }
  std::erase(study.metrics, left_out);
  const auto file = folder / "six.study.db";
  app::StudyDatabase database(file, study, {"text", "version", 1});
  database.store((*four_bar_evaluator(study, 1, nullptr))(0, 6).value());
  database.commit();
  return file;
}

TEST(AtlasFile, GivesTheCurvesOfItsRows) {
  const tests::TestFolder folder;
  const auto curves = app::read_atlas(stored_study(folder, ""));
  ASSERT_TRUE(curves.has_value()) << curves.error();
  ASSERT_EQ(curves->size(), 4U);
  for (const AtlasCurve& curve : *curves) {
    const auto own = DescriptorFinder()(curve_of(curve.linkage, 512).samples());
    for (int k = -kHarmonics; k <= kHarmonics; ++k) {
      EXPECT_LT(norm(own.of(k) - curve.descriptors.of(k)), 1e-6);
    }
  }
  EXPECT_EQ((*curves)[3].linkage.coupler, 3.1);
  EXPECT_EQ((*curves)[3].linkage.coupler_point->y, 2);
}

TEST(AtlasFile, RefusesWhatIsNone) {
  const tests::TestFolder folder;
  const auto expect_refused = [](const std::filesystem::path& file, const char* why) {
    const auto curves = app::read_atlas(file);
    ASSERT_FALSE(curves.has_value());
    EXPECT_NE(curves.error().find(why), std::string::npos) << curves.error();
  };
  expect_refused(stored_study(folder, "fourier_phase_deg.p3"),
                 "it has no column fourier_phase_deg.p3; an atlas is");
  expect_refused(folder / "none.study.db", "it cannot be read");
  std::ofstream(folder / "text.study.db") << std::string(5000, 'x');
  expect_refused(folder / "text.study.db", "it cannot be read");
  std::ofstream(folder / "empty.study.db");
  expect_refused(folder / "empty.study.db", "it is no study file");
}

TEST(AtlasFile, IsNamedInFilesOfClosedCurvesAlone) {
  const tests::TestFolder folder;
  const auto fault_of = [&](const std::string& target) -> std::string {
    const auto file = folder / "problem.toml";
    std::ofstream(file) << "kind = \"path-generation\"\n[target]\n" + target +
                               "\n[bounds]\nlength = [0.2, 20]\n[solve]\natlas = \"a.db\"\n";
    const auto read = read_task(file);
    return read ? "" : read.error().front().message;
  };
  EXPECT_NE(fault_of("points = [[0, 0], [1, 0], [1, 1]]").find("given without a closed curve"),
            std::string::npos);
  const std::string closed = "curve = [[0, 0], [2, 0], [2, 1], [0, 1]]";
  EXPECT_NE(fault_of(closed).find("is \"a.db\", where there is no file"), std::string::npos);
  std::ofstream(folder / "a.db");
  EXPECT_EQ(fault_of(closed), "");
}

}  // namespace
}  // namespace cognate::problems::atlas_starts_test
