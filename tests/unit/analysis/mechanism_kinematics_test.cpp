/// Every dyad and drive: closures satisfied, derivatives against truncated Taylor series.
#include <gtest/gtest.h>

#include "analysis/mechanism/kinematics.hpp"
#include "tests/support/random_chains.hpp"
#include "tests/support/taylor.hpp"

namespace cognate::mechanism_kinematics_test {
namespace {

using test::ChainMaker;

std::vector<std::vector<int>> chain_types() {
  std::vector<std::vector<int>> all;
  for (int a = 0; a < 5; ++a) {
    for (int b = 0; b < 5; ++b) {
      for (int c = 0; c < 5; ++c) all.push_back({a, b, c});
    }
  }
  return all;
}

using Bodies = std::span<const BodyMotion<double, 0>>;

/// How far the two bodies `n` and `n` + 1 of a dyad are from what it says they are: points that
/// should coincide, points off their guides, axes off their directions.
class Misfit {
 public:
  Misfit(Bodies bodies, int n) : bodies_(bodies), n_(n) {}

  double operator()(const Rrr<double>& dyad) const {
    const Vec2d d = at(dyad.second) - at(dyad.first);
    const Vec2d inner = at({n_, {dyad.first_length, 0}});
    EXPECT_GT(sign(dyad.assembly) * cross(d, inner - at(dyad.first)), 0);
    return worst({at({n_, {}}) - at(dyad.first), at({n_ + 1, {}}) - at(dyad.second),
                  inner - at({n_ + 1, {dyad.second_length, 0}})});
  }
  double operator()(const Rrp<double>& dyad) const {
    const Vec2d pin = at({n_ + 1, {}});
    EXPECT_GT(sign(dyad.assembly) * dot(axis(dyad.guide), pin - at(dyad.point)), 0);
    return worst({at({n_, {}}) - at(dyad.point), at({n_, {dyad.length, 0}}) - pin,
                  off_guide(dyad.guide, n_ + 1)});
  }
  double operator()(const Rpr<double>& dyad) const {
    const Vec2d u = axis(n_ + 1);
    const Vec2d reach = conj(u) * (at(dyad.block) - at(dyad.pivot));
    EXPECT_GT(sign(dyad.assembly) * reach.x, 0);
    return worst({at({n_, {}}) - at(dyad.block),
                  at({n_ + 1, {}}) - at(dyad.pivot),
                  axis(n_) - u,
                  {0, reach.y - dyad.offset}});
  }
  double operator()(const Prp<double>& dyad) const {
    return worst({at({n_, {}}) - at({n_ + 1, {}}), off_guide(dyad.first, n_),
                  off_guide(dyad.second, n_ + 1)});
  }
  double operator()(const Rpp<double>& dyad) const {
    const Vec2d slot = axis(n_ + 1) * dyad.slot;
    return worst({at({n_, {}}) - at(dyad.point),
                  axis(n_) - slot,
                  off_guide(dyad.guide, n_ + 1),
                  {0, cross(slot, at(dyad.point) - at({n_ + 1, {}}))}});
  }
  double operator()(const Cylinder<double>& dyad) const {
    const Vec2d pin = at({1, {}}), base = at(dyad.base);
    EXPECT_GT(sign(dyad.assembly) * cross(at(dyad.pivot) - base, pin - base), 0);
    return worst({at({n_, {}}) - base, at({n_ + 1, {}}) - at(dyad.pivot),
                  pin - at({n_ + 1, {dyad.length, 0}}), axis(1) - axis(n_)});
  }
  // No mechanism here has a group (group_test.cpp).
  double operator()(const Group&) const { return 0; }
  double operator()(const GroupRest&) const { return 0; }
  double operator()(const DrivingRod<double>&) const {
    return worst({{0, norm(at({1, {}}) - at({2, {}})) - ChainMaker::kStart}});
  }
  double operator()(const Crank<double>& crank) const { return worst({at({1, {}}) - crank.pivot}); }
  double operator()(const DrivingSlider<double>& slider) const {
    const Vec2d along = at({1, {}}) - slider.guide.through;
    return worst(
        {off_guide(slider.guide, 1), {0, dot(slider.guide.direction, along) - ChainMaker::kStart}});
  }
  double operator()(const FloatingLink<double>& link) const {
    return worst({off_guide(link.first, 2), off_guide(link.second, 3), at({1, {}}) - at({2, {}}),
                  at({1, {link.length, 0}}) - at({3, {}})});
  }

 private:
  Vec2d axis(int body) const { return bodies_[static_cast<std::size_t>(body)].direction; }
  Vec2d axis(const Guide<double>& guide) const { return axis(guide.body) * guide.direction; }
  Vec2d at(const Attached<double>& point) const {
    return bodies_[static_cast<std::size_t>(point.body)].origin[0] + axis(point.body) * point.at;
  }
  /// How far the slider `body` is off its guide, and its axis off the guide's.
  Vec2d off_guide(const Guide<double>& guide, int body) const {
    const Vec2d arm = at({body, {}}) - at({guide.body, guide.through});
    return {std::sqrt(squared_norm(axis(body) - axis(guide))),
            cross(axis(guide), arm) - guide.offset};
  }
  static double worst(std::initializer_list<Vec2d> differences) {
    double result = 0;
    for (const Vec2d& d : differences) result = std::max(result, std::sqrt(squared_norm(d)));
    return result;
  }

  Bodies bodies_;
  int n_;
};

class Chains : public ::testing::TestWithParam<int> {};

/// Derivatives of all bodies up to the third order against the Taylor series of the positions.
TEST_P(Chains, DerivativesEqualTaylorCoefficients) {
  ChainMaker maker(7u + static_cast<unsigned>(GetParam()));
  for (const auto& types : chain_types()) {
    const Mechanism<double> mechanism = maker.make(GetParam(), types);
    MechanismMotion<3> motion(mechanism);
    ASSERT_TRUE(motion.move_to(ChainMaker::kStart));
    const auto series = test::taylor_motion(mechanism, ChainMaker::kStart);
    for (std::size_t i = 0; i < series.size(); ++i) {
      const auto& body = motion.bodies()[i];
      const auto tip = point_motion(body, Vec2d{1, 0});
      const auto expected_tip = series[i].origin[0] + series[i].direction;
      double scale = 1;
      for (int k = 0; k <= 3; ++k) {
        const auto order = static_cast<std::size_t>(k);
        const Vec2d origin{series[i].origin[0].x.derivative(k),
                           series[i].origin[0].y.derivative(k)};
        const Vec2d end{expected_tip.x.derivative(k), expected_tip.y.derivative(k)};
        scale = std::max(
            {scale, std::abs(origin.x), std::abs(origin.y), std::abs(end.x), std::abs(end.y)});
        const double bound = 1e-9 * scale;
        EXPECT_NEAR(body.origin[order].x, origin.x, bound) << "body " << i << " order " << k;
        EXPECT_NEAR(body.origin[order].y, origin.y, bound) << "body " << i << " order " << k;
        EXPECT_NEAR(tip[order].x, end.x, bound) << "body " << i << " order " << k;
        EXPECT_NEAR(tip[order].y, end.y, bound) << "body " << i << " order " << k;
      }
    }
  }
}

/// Positions close every loop, on the side that the assembly says.
TEST_P(Chains, PositionsCloseEveryLoop) {
  ChainMaker maker(107u + static_cast<unsigned>(GetParam()));
  for (const auto& types : chain_types()) {
    const Mechanism<double> mechanism = maker.make(GetParam(), types);
    MechanismMotion<0> motion(mechanism);
    ASSERT_TRUE(motion.move_to(ChainMaker::kStart));
    double size = 1;
    for (const auto& body : motion.bodies()) {
      size = std::max({size, std::abs(body.origin[0].x), std::abs(body.origin[0].y)});
      EXPECT_NEAR(squared_norm(body.direction), 1, 1e-14);
    }
    EXPECT_LE(std::visit(Misfit(motion.bodies(), 1), mechanism.drive), 1e-14 * size);
    for (int i = 0; i < static_cast<int>(mechanism.dyads.size()); ++i) {
      const double misfit = std::visit(Misfit(motion.bodies(), first_body(mechanism, i)),
                                       mechanism.dyads[static_cast<std::size_t>(i)]);
      EXPECT_LE(misfit, 1e-14 * size) << "dyad " << i;
    }
  }
}

/// In another unit of length, which is a power of two, the same digits: from 1e-120 to 1e120.
TEST_P(Chains, TheUnitOfLengthDoesNotMatter) {
  ChainMaker maker(207u + static_cast<unsigned>(GetParam()));
  for (const auto& types : chain_types()) {
    const Mechanism<double> mechanism = maker.make(GetParam(), types);
    MechanismMotion<3> motion(mechanism);
    ASSERT_TRUE(motion.move_to(ChainMaker::kStart));
    for (const int power : {-400, 400}) {
      const double unit = std::ldexp(1.0, power);
      MechanismMotion<3> scaled(test::scaled(mechanism, unit));
      DrivePosition<double> drive = drive_position(mechanism, ChainMaker::kStart);
      // By a displacement, the derivatives of angles go with its unit, too: leave those out.
      drive.displacement *= unit;
      ASSERT_TRUE(scaled.move_to(drive));
      for (std::size_t i = 0; i < motion.bodies().size(); ++i) {
        EXPECT_EQ(scaled.bodies()[i].direction.x, motion.bodies()[i].direction.x);
        EXPECT_EQ(scaled.bodies()[i].origin[0].y / unit, motion.bodies()[i].origin[0].y);
        if (driven_by_length(mechanism.drive)) continue;
        EXPECT_EQ(scaled.bodies()[i].origin[3].x / unit, motion.bodies()[i].origin[3].x);
        EXPECT_EQ(scaled.bodies()[i].turn[2], motion.bodies()[i].turn[2]);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Drives, Chains, ::testing::Values(0, 1, 2, 3));

}  // namespace
}  // namespace cognate::mechanism_kinematics_test
