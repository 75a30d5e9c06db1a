/// Poses from pivots as coordinates and a crank angle, at any scale and anywhere in the plane,
/// against 237 bits on the same doubles.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "analysis/linkage/motion.hpp"
#include "tests/stress/accuracy.hpp"
#include "tests/stress/closure_families.hpp"

namespace cognate::stress {
namespace {

/// Pivots A and D, crank, coupler, rocker, coupler point, crank angle.
constexpr std::size_t kInputs = 10;
using Inputs = std::array<Exact, kInputs>;

struct Joints {
  bool closes = false;
  Vec2<Exact> c, point;
};

/// Circle–circle intersection in the plane of the pivots.
Joints exact_joints(const Inputs& x, double assembly) {
  const Vec2<Exact> a{x[0], x[1]}, d{x[2], x[3]};
  const Exact cosine = cos(x[9]), sine = sin(x[9]);
  const Vec2<Exact> b = a + x[4] * Vec2<Exact>{cosine, sine};
  const Vec2<Exact> bd = d - b;
  const Exact d2 = squared_norm(bd);
  const Exact m = d2 + x[5] * x[5] - x[6] * x[6];
  const Exact h2 = 4 * d2 * x[5] * x[5] - m * m;
  if (!(h2 > 0)) return {};
  const Vec2<Exact> bc = Exact(1 / (2 * d2)) * (Vec2<Exact>{m, assembly * sqrt(h2)} * bd);
  return {true, b + bc, b + Exact(1 / x[5]) * (bc * Vec2<Exact>{x[7], x[8]})};
}

void include(Accuracy& accuracy, const FourBar& linkage, double crank_angle) {
  const Vec2d &a = linkage.pivot_a, &d = linkage.pivot_d, &uv = *linkage.coupler_point;
  const Inputs inputs{a.x,  a.y,  d.x,        d.y, linkage.crank, linkage.coupler, linkage.rocker,
                      uv.x, uv.y, crank_angle};
  const double side = sign(linkage.assembly);
  const Joints exact = exact_joints(inputs, side);
  const auto pose = Motion(linkage).at(crank_angle);
  if (!exact.closes || !pose) {
    accuracy.include_flag(exact.closes, pose.has_value(), 1);
    return;
  }
  const double size = linkage.crank + linkage.rocker + std::hypot(uv.x, uv.y);
  double c_condition = 0, point_condition = 0;
  const Exact step = ldexp(Exact(1), -80);
  for (std::size_t i = 0; i < kInputs; ++i) {
    Inputs more = inputs;
    more[i] *= 1 + step;
    const Joints moved = exact_joints(more, side);
    const auto rate = [&](const Vec2<Exact>& p, const Vec2<Exact>& q) {
      return double(sqrt(squared_norm(p - q)) / step) / size;
    };
    c_condition += rate(moved.c, exact.c);
    point_condition += rate(moved.point, exact.point);
  }
  accuracy.include_flag(true, true, 0);
  accuracy.include_error(distance(pose->c, exact.c) / size, c_condition);
  accuracy.include_error(distance(*pose->coupler_point, exact.point) / size, point_condition);
}

/// Linkages of `family` with A at a place of size `offset`, all times 10^`exponent`.
Accuracy measure(const Family& family, double offset, double exponent_range) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> within(-1, 1);
  Accuracy accuracy;
  for (int i = 0; i < 150; ++i) {
    const Configuration at = family.draw(family.distances.front(), random);
    const double scale = std::pow(10.0, exponent_range * within(random));
    const double frame_angle = 3.2 * within(random);
    const Vec2d a{scale * offset * within(random), scale * offset * within(random)};
    const Vec2d frame =
        scale * at.links.frame * Vec2d{std::cos(frame_angle), std::sin(frame_angle)};
    const FourBar linkage{a,
                          a + frame,
                          scale * at.links.crank,
                          scale * at.links.coupler,
                          scale * at.links.rocker,
                          at.assembly > 0 ? Assembly::open : Assembly::crossed,
                          scale * at.coupler_point};
    include(accuracy, linkage, 3.2 * within(random));
  }
  return accuracy;
}

TEST(MotionAccuracy, HoldsAtAnyScaleAndAnywhere) {
  const auto families = closure_families();
  for (const std::size_t k : {0, 1, 2}) {
    for (const double offset : {0.0, 1.0, 1e8}) {
      for (const double exponent_range : {0.0, 150.0}) {
        const Accuracy accuracy = measure(families[k], offset, exponent_range);
        EXPECT_GT(accuracy.closed, 20);
        EXPECT_EQ(accuracy.wrong_flags, 0) << families[k].name << " at " << offset;
        EXPECT_LE(accuracy.well_conditioned, 10) << families[k].name << " at " << offset;
        EXPECT_LE(accuracy.per_condition, 2) << families[k].name << " at " << offset;
      }
    }
  }
}

}  // namespace
}  // namespace cognate::stress
