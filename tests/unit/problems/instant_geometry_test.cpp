// Poles, circles and Ball's point of bodies, held against intersections of lines and against
// differences of positions with 113 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/linkage/four_bar.hpp"
#include "problems/evaluation/result.hpp"
#include "tests/support/named_mechanisms.hpp"
#include "tests/support/quad_motion.hpp"

namespace cognate::problems::instant_geometry_test {
namespace {

using test::Quad;

const FourBar kCrankRocker{{1, 2}, {5, 3}, 1, 4, 3, Assembly::open, Vec2d{2, 0.5}};
constexpr int kSteps = 24;

AnalysisProblem with_geometry(NamedMechanism mechanism, std::vector<int> bodies) {
  auto problem = analysis_of(std::move(mechanism), kSteps);
  problem.drive.start = 0.3;
  problem.drive.end = 0.3 + kTurn;
  problem.output.instant_geometry = std::move(bodies);
  return problem;
}

// The rows of an analysis.
class Rows {
 public:
  explicit Rows(const AnalysisProblem& problem)
      : problem_(problem), result_(analyse(problem, problems::Run{.threads = 1})) {}

  const AnalysisResult& result() const { return result_; }

  double value(const std::string& name, int row) const {
    const auto found = std::ranges::find(result_.columns, name, &Column::name);
    EXPECT_NE(found, result_.columns.end()) << "no column " << name;
    return found == result_.columns.end() ? NAN : found->values.at(static_cast<std::size_t>(row));
  }

  Vec2d vector(const std::string& name, int row, const char* x = "_x", const char* y = "_y") const {
    return {value(name + x, row), value(name + y, row)};
  }

  double drive(int row) const {
    return problem_.drive.start + (problem_.drive.end - problem_.drive.start) * row / kSteps;
  }

 private:
  AnalysisProblem problem_;
  AnalysisResult result_;
};

// The path of the point of the four-bar's coupler that is at `here` when the drive is at `q`, by
// positions alone.
class Path {
 public:
  Path(const FourBar& linkage, double q, const Vec2d& here)
      : motion_(as_mechanism(linkage)), q_(q) {
    const auto coupler = motion_.at(q_)->at(2);
    at_ = conjugate(coupler.direction) * (test::quad(here) - coupler.origin[0]);
  }

  Vec2<Quad> at(const Quad& step) {
    const auto coupler = motion_.at(q_ + step)->at(2);
    return coupler.origin[0] + coupler.direction * at_;
  }

  // Derivatives by the drive.
  struct Motion {
    Vec2<Quad> v, a, j;

    // κ = 0, as v × a relative to what it is made of; zero in the pole, too.
    double bend() const {
      const Quad size = sqrt(squared_norm(a));
      return static_cast<double>(cross(v, a) / (size * (size + sqrt(squared_norm(v)))));
    }

    // The numerator of dκ/ds, relative likewise.
    double bend_rate() const {
      const Quad v2 = squared_norm(v);
      const Quad rate = cross(v, j) * v2 - 3 * cross(v, a) * dot(v, a);
      return static_cast<double>(rate / (v2 * (sqrt(v2 * squared_norm(j)) + squared_norm(a))));
    }
  };
  Motion motion() {
    const Quad h = 1e-6;
    const auto b2 = at(-2 * h), b1 = at(-h), here = at(0), f1 = at(h), f2 = at(2 * h);
    return {(1 / (2 * h)) * (f1 - b1), (1 / (h * h)) * (f1 - here + (b1 - here)),
            (1 / (2 * h * h * h)) * (f2 - b2 - Quad(2) * (f1 - b1))};
  }

 private:
  static Vec2<Quad> conjugate(const Vec2<Quad>& v) { return {v.x, -v.y}; }

  test::QuadMotion motion_;
  Quad q_;
  Vec2<Quad> at_;
};

TEST(InstantGeometry, PoleIsWhereTheLinesOfCrankAndRockerMeet) {
  const Rows rows(with_geometry(named(kCrankRocker), {2}));
  for (int row = 0; row <= kSteps; ++row) {
    const Vec2d pole = rows.vector("coupler_pole", row);
    const Vec2d b = rows.vector("B", row), c = rows.vector("C", row);
    const Vec2d a = kCrankRocker.pivot_a, d = kCrankRocker.pivot_d;
    EXPECT_NEAR(cross(pole - a, b - a), 0, 1e-12 * norm(pole - a)) << row;
    EXPECT_NEAR(cross(pole - d, c - d), 0, 1e-12 * norm(pole - d)) << row;
    // The moving centrode's point is that of the body which is there.
    const double angle = rows.value("coupler_deg", row) * kTurn / 360;
    const Vec2d axis{std::cos(angle), std::sin(angle)};
    const Vec2d moving = b + axis * rows.vector("coupler_moving_centrode", row, "_u", "_v");
    EXPECT_NEAR(norm(moving - pole), 0, 1e-12 * (1 + norm(pole))) << row;
  }
}

TEST(InstantGeometry, PoleOfASliderCrankIsAboveTheSlider) {
  const Rows rows(with_geometry(named(SliderCrank{.crank = 1, .coupler = 3, .offset = 0.4}), {2}));
  for (int row = 0; row <= kSteps; ++row) {
    const Vec2d pole = rows.vector("coupler_pole", row), b = rows.vector("B", row);
    EXPECT_NEAR(cross(pole, b), 0, 1e-12 * norm(pole)) << row;
    EXPECT_NEAR(pole.x, rows.vector("C", row).x, 1e-12 * norm(pole)) << row;
  }
}

TEST(InstantGeometry, CirclesAreThoseOfTheirPoints) {
  const Rows rows(with_geometry(named(kCrankRocker), {2}));
  for (int row = 0; row <= kSteps; ++row) {
    const double q = rows.drive(row);
    const Vec2d pole = rows.vector("coupler_pole", row);
    const Vec2d centre = rows.vector("coupler_inflection_centre", row);
    const double size = rows.value("coupler_inflection_diameter", row);
    EXPECT_NEAR(2 * norm(centre - pole), size, 1e-11 * size);
    EXPECT_NEAR(norm(centre + rows.vector("coupler_return_centre", row) - 2 * pole), 0,
                1e-11 * size);
    const Vec2d bresse = rows.vector("coupler_tangential_centre", row);
    EXPECT_NEAR(2 * norm(bresse - pole), rows.value("coupler_tangential_diameter", row),
                1e-11 * norm(bresse - pole));
    for (const double angle : {0.5, 1.8, -2.0}) {
      const Vec2d turned{std::cos(angle), std::sin(angle)};
      const Vec2d straight = centre + turned * (centre - pole);
      EXPECT_NEAR(Path(kCrankRocker, q, straight).motion().bend(), 0, 1e-10) << row;
      const Vec2d even = bresse + turned * (bresse - pole);
      const auto [v, a, j] = Path(kCrankRocker, q, even).motion();
      EXPECT_NEAR(static_cast<double>(dot(v, a) / (squared_norm(v) + squared_norm(a))), 0, 1e-10)
          << row;
    }
  }
}

TEST(InstantGeometry, BallsPointAndTheCubicKeepTheirCurvature) {
  const Rows rows(with_geometry(named(kCrankRocker), {2}));
  for (int row = 0; row <= kSteps; ++row) {
    const double q = rows.drive(row);
    const double size = rows.value("coupler_inflection_diameter", row);
    const auto ball = Path(kCrankRocker, q, rows.vector("coupler_ball", row)).motion();
    EXPECT_NEAR(ball.bend(), 0, 1e-10) << row;
    EXPECT_NEAR(ball.bend_rate(), 0, 1e-9) << row;

    const Vec2d pole = rows.vector("coupler_pole", row);
    const Vec2d normal = (2 / size) * (rows.vector("coupler_inflection_centre", row) - pole);
    const Vec2d tangent{normal.y, -normal.x};
    const double m = rows.value("coupler_stationary_m", row);
    const double n = rows.value("coupler_stationary_n", row);
    for (const double psi : {0.7, 2.1}) {
      const double r = 1 / (1 / (m * std::sin(psi)) + 1 / (n * std::cos(psi)));
      const Vec2d point = pole + r * (std::cos(psi) * tangent + std::sin(psi) * normal);
      EXPECT_NEAR(Path(kCrankRocker, q, point).motion().bend_rate(), 0, 1e-9) << row << ' ' << psi;
    }
  }
}

// By the time, for a drive that gathers speed: second differences of the position.
TEST(InstantGeometry, AccelerationPoleStandsStillToTheSecondOrder) {
  auto problem = with_geometry(named(kCrankRocker), {2});
  problem.drive.rate = {.speed = 2, .acceleration = 5};
  const Rows rows(problem);
  for (int row = 0; row <= kSteps; ++row) {
    const Vec2d point = rows.vector("coupler_acceleration_pole", row);
    const auto [v, a, j] = Path(kCrankRocker, rows.drive(row), point).motion();
    const auto acceleration = Quad(4) * a + Quad(5) * v;
    EXPECT_NEAR(static_cast<double>(sqrt(squared_norm(acceleration))), 0, 1e-9 * (1 + norm(point)))
        << row;
  }
}

TEST(InstantGeometry, WhatIsNotDefinedIsEmpty) {
  int tested = 0;
  const Rows rows(with_geometry(named(SliderCrank{.crank = 1, .coupler = 3}), {1, 3}));
  for (const auto& column : rows.result().columns) {
    if (column.quantity != "instant-geometry") continue;
    ++tested;
    EXPECT_EQ(column.unit, "length");
    if (column.of == "slider") {
      EXPECT_TRUE(std::ranges::all_of(column.values, [](double v) { return std::isnan(v); }))
          << column.name;
    }
  }
  EXPECT_EQ(rows.value("crank_pole_x", 5), 0);
  EXPECT_EQ(rows.value("crank_inflection_diameter", 5), 0);
  EXPECT_TRUE(std::isnan(rows.value("crank_ball_x", 5)));
  EXPECT_TRUE(std::isnan(rows.value("crank_stationary_m", 5)));
  EXPECT_GE(tested, 32);
}

// Wang, Zhu, Liao & Yang 2007: cranks of 1 and 1.6 along y, a coupler of 1.2 at 20 degrees; the
// inflection line is parallel to the cranks at x = b cos(phi) c/(c - a) from B.
TEST(InstantGeometry, OfASlidingCouplerIsTheInflectionLine) {
  const double phi = kTurn / 18;
  const Vec2d c{1.2 * std::cos(phi), 1 + 1.2 * std::sin(phi)};
  const FourBar linkage{{0, 0}, c - Vec2d{0, 1.6}, 1, 1.2, 1.6, Assembly::open, {}};
  auto problem = with_geometry(named(linkage), {2});
  problem.drive.start = kTurn / 4 - 0.12;
  problem.drive.end = kTurn / 4 + 0.12;
  problem.drive.rate = {.speed = 2, .acceleration = 5};
  const Rows rows(problem);
  const int row = kSteps / 2;
  ASSERT_TRUE(std::isnan(rows.value("coupler_pole_x", row)));
  const double x = 1.2 * std::cos(phi) * 1.6 / 0.6;
  EXPECT_NEAR(rows.value("coupler_inflection_line_x", row), x, 1e-12);
  EXPECT_NEAR(std::abs(rows.value("coupler_inflection_line_deg", row)), 90, 1e-12);
  EXPECT_NEAR(rows.value("coupler_acceleration_pole_x", row), x, 1e-12);
  const Vec2d still = rows.vector("coupler_acceleration_pole", row);
  const auto [v, a, j] = Path(linkage, rows.drive(row), still).motion();
  EXPECT_LT(static_cast<double>(sqrt(squared_norm(Quad(4) * a + Quad(5) * v))), 1e-9);
  EXPECT_TRUE(std::isnan(rows.value("coupler_inflection_line_x", row + 1)));
  EXPECT_FALSE(std::isnan(rows.value("coupler_pole_x", row + 1)));
}

TEST(InstantGeometry, IsComputedOnlyWhereAskedFor) {
  const auto has_third = [](const AnalysisResult& result) {
    return std::ranges::find(result.work.skipped, "third derivatives") == result.work.skipped.end();
  };
  auto problem = with_geometry(named(kCrankRocker), {2});
  problem.output.velocity = problem.output.acceleration = false;
  const auto asked = analyse(problem, problems::Run{.threads = 2});
  EXPECT_TRUE(has_third(asked));
  EXPECT_EQ(asked.work.accelerations, static_cast<std::uint64_t>(kSteps + 1));
  problem.output.instant_geometry.clear();
  const auto plain = analyse(problem, problems::Run{.threads = 2});
  EXPECT_FALSE(has_third(plain));
  EXPECT_EQ(asked.columns.size(), plain.columns.size() + 18);
}

TEST(InstantGeometry, OfAnIdleDriveHasNoInfinity) {
  auto problem = with_geometry(named(kCrankRocker), {2});
  problem.drive.rate = {.speed = 0, .acceleration = 1};
  const Rows rows(problem);
  for (const auto& column : rows.result().columns) {
    EXPECT_TRUE(std::ranges::none_of(column.values, [](double v) { return std::isinf(v); }))
        << column.name;
  }
}

}  // namespace
}  // namespace cognate::problems::instant_geometry_test
