/// The closure held against its own equations, against 113-bit arithmetic and against dual numbers.
#include "analysis/linkage/closure.hpp"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>
#include <xsimd/xsimd.hpp>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::closure_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
constexpr double epsilon = 0x1p-53;

/// The joint C by the textbook's formulas, in 113 bits: law of cosines in the triangle B–C–D.
Vec2<Quad> textbook_joint(const Lengths<double>& links, double theta, double assembly) {
  const Quad l1 = links.crank, l2 = links.coupler, l3 = links.rocker, l4 = links.frame;
  const Quad bx = l1 * cos(Quad(theta)), by = l1 * sin(Quad(theta));
  const Quad dx = l4 - bx, dy = -by;
  const Quad diagonal = sqrt(dx * dx + dy * dy);
  const Quad at_b = acos((l2 * l2 + diagonal * diagonal - l3 * l3) / (2 * l2 * diagonal));
  const Quad direction = atan2(dy, dx) + Quad(assembly) * at_b;
  return {bx + l2 * cos(direction), by + l2 * sin(direction)};
}

struct Sample {
  Lengths<double> links;
  double theta;
  double assembly;
};

Sample random_sample(std::mt19937_64& random) {
  std::uniform_real_distribution<double> length(0.1, 1.0), angle(-4.0, 4.0);
  return {{length(random), length(random), length(random), length(random)},
          angle(random),
          random() % 2 == 0 ? 1.0 : -1.0};
}

TEST(Closure, AgreesWithTheLawOfCosinesIn113Bits) {
  std::mt19937_64 random(1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto [links, theta, assembly] = random_sample(random);
    const auto at = Closure<double>(links).at(crank_direction(theta), assembly);
    // Away from limit positions, where the joint is well conditioned.
    if (!(at.discriminant > 1e-3)) continue;
    const Vec2<Quad> joint = textbook_joint(links, theta, assembly);
    const double x = links.frame + links.rocker * at.rocker.x, y = links.rocker * at.rocker.y;
    worst = std::max(worst, std::hypot(double(x - joint.x), double(y - joint.y)));
  }
  RecordProperty("worst_error_in_eps", std::to_string(worst / epsilon));
  EXPECT_LT(worst, 200 * epsilon);  // sizes of order 1; the discriminant's root amplifies by ≤ 32
}

TEST(Closure, IsTheSameCodeIn113Bits) {
  int tested = 0;
  std::mt19937_64 random(2);
  for (int i = 0; i < 2000; ++i) {
    const auto [links, theta, assembly] = random_sample(random);
    const Lengths<Quad> exact{links.crank, links.coupler, links.rocker, links.frame};
    const auto at = Closure<Quad>(exact).at(crank_direction(Quad(theta)), Quad(assembly));
    if (!(at.discriminant > 1e-6)) continue;
    ++tested;
    const Vec2<Quad> joint = textbook_joint(links, theta, assembly);
    EXPECT_LT(abs(exact.frame + exact.rocker * at.rocker.x - joint.x), Quad(1e-28));
    EXPECT_LT(abs(exact.rocker * at.rocker.y - joint.y), Quad(1e-28));
  }
  EXPECT_GE(tested, 1000);
}

TEST(Closure, LosesNoDigitsNearALimitPosition) {
  // The condition number of the rocker grows as 1/sin μ; allow that and nothing more.
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.2, 1.0);
  int closed = 0;
  for (int i = 0; i < 4000; ++i) {
    const double gap = std::pow(10.0, -1 - i % 12);
    const double l1 = unit(random), l2 = unit(random), l3 = unit(random);
    // The frame puts B–C–D within `gap` of stretched when the crank points along the frame.
    const Lengths<double> links{l1, l2, l3, l1 + (l2 + l3) * (1 - gap)};
    const double theta = 0.3 * std::sqrt(gap) * unit(random);
    const auto at = Closure<double>(links).at(crank_direction(theta), 1.0);
    const Lengths<Quad> exact{links.crank, links.coupler, links.rocker, links.frame};
    const auto reference = Closure<Quad>(exact).at(crank_direction(Quad(theta)), Quad(1));
    if (!(reference.discriminant > 0)) continue;
    ++closed;
    const double sine = std::abs(cross(at.coupler, at.rocker));
    const double error = std::hypot(double(at.rocker.x - reference.rocker.x),
                                    double(at.rocker.y - reference.rocker.y));
    EXPECT_LT(error, 40 * epsilon / sine) << "gap " << gap << " theta " << theta;
  }
  EXPECT_GT(closed, 1000);
}

TEST(Closure, HasTheAssemblyOnTheNamedSide) {
  std::mt19937_64 random(4);
  int closed = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto [links, theta, assembly] = random_sample(random);
    const auto at = Closure<double>(links).at(crank_direction(theta), assembly);
    if (!(at.discriminant > 1e-9)) continue;
    ++closed;
    const Vec2d b{links.crank * std::cos(theta), links.crank * std::sin(theta)};
    const Vec2d to_d = Vec2d{links.frame, 0} - b, to_c = links.coupler * at.coupler;
    EXPECT_GT(assembly * cross(to_d, to_c), 0);
    EXPECT_NEAR(squared_norm(at.coupler), 1, 1e-11);
  }
  EXPECT_GT(closed, 500);
}

TEST(Closure, GradientAgreesWithDualNumbers) {
  int tested = 0;
  using Jet = ceres::Jet<double, 5>;
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    const auto [links, theta, assembly] = random_sample(random);
    const auto at = Closure<double>(links).at(crank_direction(theta), assembly);
    if (!(at.discriminant > 1e-3)) continue;
    ++tested;
    const Lengths<Jet> dual{Jet(links.crank, 0), Jet(links.coupler, 1), Jet(links.rocker, 2),
                            Jet(links.frame, 3)};
    const auto dual_at = Closure<Jet>(dual).at(crank_direction(Jet(theta, 4)), Jet(assembly));
    const auto gradient = closure_gradient(links, Vec2d{std::cos(theta), std::sin(theta)}, at);
    const auto check = [](const AngleGradient<double>& g, const Vec2<Jet>& e) {
      const double expected[5] = {g.crank, g.coupler, g.rocker, g.frame, g.crank_angle};
      for (int k = 0; k < 5; ++k) {
        const double angle = cross(Vec2d{e.x.a, e.y.a}, Vec2d{e.x.v[k], e.y.v[k]});
        EXPECT_NEAR(angle, expected[k], 1e-9 * (1 + std::abs(expected[k])));
      }
    };
    check(gradient.coupler, dual_at.coupler);
    check(gradient.rocker, dual_at.rocker);
  }
  EXPECT_GE(tested, 1000);
}

TEST(Closure, RunsOnSimdPacks) {
  using Pack = xsimd::batch<double>;
  const Lengths<double> links{1, 2.5, 2, 3};
  const HalfClosure<Pack> pack({Pack(1.0), Pack(2.5), Pack(2.0), Pack(3.0)}, +1);
  alignas(64) double sines[Pack::size], versines[Pack::size], x[Pack::size];
  for (std::size_t i = 0; i < Pack::size; ++i) {
    const auto direction = crank_direction(0.1 + 0.3 * double(i));
    sines[i] = direction.sin;
    versines[i] = direction.versine;
  }
  const auto at = pack.at(Pack::load_aligned(sines), Pack::load_aligned(versines), Pack(1.0));
  at.coupler.x.store_aligned(x);
  for (std::size_t i = 0; i < Pack::size; ++i) {
    const auto scalar = Closure<double>(links).at(crank_direction(0.1 + 0.3 * double(i)), 1.0);
    EXPECT_NEAR(x[i], scalar.coupler.x, 4 * epsilon);
  }
}

TEST(Motion, ClosesItsLoopAtAnyScale) {
  for (const double scale : {1e-90, 1.0, 1e90}) {
    const FourBar linkage{{2 * scale, 3 * scale},
                          {2.9 * scale, 4.1 * scale},
                          0.5 * scale,
                          1.3 * scale,
                          1.2 * scale,
                          Assembly::crossed,
                          Vec2d{0.4 * scale, -0.7 * scale}};
    const Motion motion(linkage);
    for (double angle = 0; angle < 6.3; angle += 0.1) {
      const auto pose = motion.at(angle);
      ASSERT_TRUE(pose);
      const Vec2d bc = (1 / scale) * (pose->c - pose->b);
      const Vec2d dc = (1 / scale) * (pose->c - linkage.pivot_d);
      const Vec2d bp = (1 / scale) * (*pose->coupler_point - pose->b);
      EXPECT_NEAR(std::hypot(bc.x, bc.y), 1.3, 2e-14);
      EXPECT_NEAR(std::hypot(dc.x, dc.y), 1.2, 2e-14);
      EXPECT_NEAR(dot(bc, bp) / 1.3, 0.4, 2e-14);
      EXPECT_NEAR(cross(bc, bp) / 1.3, -0.7, 2e-14);
    }
  }
}

TEST(Motion, DoesNotCloseBeyondItsLimits) {
  // A triple rocker whose crank reaches 60° at most: d = l₂ + l₃ there by construction.
  const double diagonal = std::sqrt(1.0 + 4.0 - 4.0 * std::cos(kPi / 3));
  const FourBar linkage{{0, 0}, {2, 0}, 1, 0.5 * diagonal, 0.5 * diagonal, Assembly::open, {}};
  EXPECT_TRUE(Motion(linkage).at(kPi / 3 - 1e-7));
  EXPECT_FALSE(Motion(linkage).at(kPi / 3 + 1e-7));
}

}  // namespace
}  // namespace cognate::closure_test
