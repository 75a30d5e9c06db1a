/// Batches on every instruction set that the machine has, against the textbook in 113 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>

#include "batch_samples.hpp"

namespace cognate {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

std::array<Quad, kDesignVariables> in_quad(const SampleDesign& design) {
  std::array<Quad, kDesignVariables> v;
  std::copy(design.variables.begin(), design.variables.end(), v.begin());
  return v;
}

/// Positions and the first two derivatives by central differences in 113 bits, and sin μ.
struct Reference {
  Vec2<Quad> point, first, second;
};

Reference reference(const SampleDesign& design, double theta) {
  const auto v = in_quad(design);
  const auto at = [&](const Quad& angle) { return textbook_point(v, angle, design.assembly); };
  const Quad h = 1e-9;
  const Vec2<Quad> here = at(theta), before = at(theta - h), after = at(theta + h);
  return {here, Quad(1 / (2 * h)) * (after - before),
          Quad(1 / (h * h)) * ((after - here) - (here - before))};
}

/// The worst error of a column pair, in units of the roundoff, of `allowed` for each value.
struct Worst {
  double units = 0;
  int compared = 0;
  void see(double error, double unit) {
    units = std::max(units, error / unit);
    ++compared;
  }
};

template <class Real>
class Batch : public ::testing::Test {};
using Reals = ::testing::Types<double, float>;
TYPED_TEST_SUITE(Batch, Reals);

TYPED_TEST(Batch, AgreesWithTheTextbookIn113BitsOnEveryInstructionSet) {
  using Real = TypeParam;
  const auto designs = sample_designs(45, 1);
  const auto angles = sample_angles(37, 2);
  const auto cranks = CrankTable<Real>(angles);
  const DesignArrays<Real> arrays(designs);
  const double eps = unit_roundoff<Real>;
  for (const InstructionSet set : instruction_sets()) {
    AllColumns<Real> out(designs.size() * angles.size());
    ASSERT_EQ(evaluate_batch(arrays.arrays(), cranks, out.columns(), {.instruction_set = set}),
              BatchStatus::done);
    Worst position, velocity, acceleration, curvature;
    for (std::size_t j = 0; j < angles.size(); ++j) {
      for (std::size_t i = 0; i < designs.size(); ++i) {
        const std::size_t at = j * designs.size() + i;
        const double sine = std::abs(double(out.motion[7][at]));
        if (!(sine > 0.2)) continue;
        const SampleDesign design = rounded<Real>(designs[i]);
        const Reference exact = reference(design, angles[j]);
        const auto error = [&](std::size_t column, const Vec2<Quad>& value) {
          return std::hypot(double(Quad(out.motion[column][at]) - value.x),
                            double(Quad(out.motion[column + 1][at]) - value.y));
        };
        const double speed = std::hypot(double(exact.first.x), double(exact.first.y));
        const double unit = eps / sine;
        position.see(error(0, exact.point), unit);
        velocity.see(error(2, exact.first), unit / sine);
        acceleration.see(error(4, exact.second), unit / (sine * sine * sine));
        if (speed < 0.2) continue;
        const double curved = double(cross(exact.first, exact.second)) / std::pow(speed, 3);
        curvature.see(std::abs(double(out.motion[6][at]) - curved),
                      unit / (sine * sine * sine * std::pow(speed, 3)));
      }
    }
    EXPECT_GT(position.compared, 300);
    EXPECT_LT(position.units, 40) << name(set);
    EXPECT_LT(velocity.units, 200) << name(set);
    EXPECT_LT(acceleration.units, 400) << name(set);
    EXPECT_LT(curvature.units, 1200) << name(set);
    const std::string type = sizeof(Real) == 8 ? "_double" : "_float";
    this->RecordProperty(name(set) + type + "_position_units", std::to_string(position.units));
  }
}

TYPED_TEST(Batch, HasTheTransmissionAngleOfTheLinks) {
  using Real = TypeParam;
  const auto designs = sample_designs(33, 3);
  const auto angles = sample_angles(20, 4);
  const DesignArrays<Real> arrays(designs);
  for (const InstructionSet set : instruction_sets()) {
    std::vector<Real> sine(33 * 20), cosine(33 * 20);
    ASSERT_EQ(evaluate_batch(arrays.arrays(), CrankTable<Real>(angles),
                             {.transmission_sin = sine, .transmission_cos = cosine},
                             {.instruction_set = set}),
              BatchStatus::done);
    int closed = 0;
    for (std::size_t at = 0; at < sine.size(); ++at) {
      const SampleDesign design = rounded<Real>(designs[at % 33]);
      const FourBar bar = design.four_bar();
      const Lengths<double> links = lengths(bar);
      const auto found = Closure<double>(links).at(crank_direction(angles[at / 33]), 1.0);
      EXPECT_EQ(std::isnan(sine[at]), std::isnan(cosine[at]));
      if (std::abs(found.discriminant) < 1e-4) continue;
      EXPECT_EQ(std::isnan(sine[at]), found.discriminant < 0);
      if (std::isnan(sine[at])) continue;
      ++closed;
      const double tolerance = 200 * unit_roundoff<Real>;
      EXPECT_NEAR(sine[at], design.assembly * cross(found.coupler, found.rocker), tolerance);
      EXPECT_NEAR(cosine[at], dot(found.coupler, found.rocker), tolerance);
    }
    EXPECT_GT(closed, 150);
  }
}

TEST(BatchAccuracy, HoldsNearChangePointsAndDeadPoints) {
  // Parallelograms and stretched dyads within `gap` of them, pivots as coordinates.
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> unit(0.3, 1);
  std::vector<SampleDesign> designs;
  std::vector<double> angles;
  for (int i = 0; i < 64; ++i) {
    const double gap = std::pow(10.0, -1 - i % 12), l1 = unit(random), l2 = unit(random);
    const double l3 = i % 2 ? l1 : unit(random);
    const double frame = i % 2 ? l2 * (1 + gap) : l1 + (l2 + l3) * (1 - gap);
    const double turn = 3 * unit(random), x = unit(random), y = unit(random);
    designs.push_back({{x, y, x + frame * std::cos(turn), y + frame * std::sin(turn), l1, l2, l3,
                        0.4 * l2, 0.3 * l2},
                       i % 4 < 2 ? 1.0 : -1.0});
    angles.push_back(0.3 * std::sqrt(gap) * unit(random));
  }
  for (const InstructionSet set : instruction_sets()) {
    std::vector<double> x(64 * 64), y(64 * 64);
    ASSERT_EQ(evaluate_batch(DesignArrays<double>(designs).arrays(), CrankTable<double>(angles),
                             {.x = x, .y = y}, {.instruction_set = set}),
              BatchStatus::done);
    Worst worst;
    for (std::size_t i = 0; i < 64; ++i) {
      const auto v = in_quad(designs[i]);
      const Quad fx = v[2] - v[0], fy = v[3] - v[1];
      const Lengths<Quad> links{v[4], v[5], v[6], sqrt(Quad(fx * fx + fy * fy))};
      const auto at =
          Closure<Quad>(links).at(crank_direction(Quad(angles[i])), Quad(designs[i].assembly));
      const std::size_t row = i * 64 + i;
      if (!(at.discriminant > 0)) continue;
      const double sine = std::abs(double(cross(at.coupler, at.rocker)));
      const Vec2<Quad> exact = textbook_point(v, Quad(angles[i]), designs[i].assembly);
      worst.see(std::hypot(double(x[row] - exact.x), double(y[row] - exact.y)), 0x1p-53 / sine);
    }
    EXPECT_GT(worst.compared, 40);
    EXPECT_LT(worst.units, 20) << name(set);
    RecordProperty(std::string(name(set)) + "_units", std::to_string(worst.units));
  }
}

TEST(BatchDeadPoint, HasAPositionButNoVelocity) {
  // Stretched at θ = 0, to the last bit: 5 = 1 + 2 + 2.
  const FourBar linkage{{0, 0}, {5, 0}, 1, 2, 2, Assembly::open, Vec2d{1, 0.5}};
  for (const InstructionSet set : instruction_sets()) {
    AllColumns<double> out(1);
    ASSERT_EQ(evaluate_batch(linkage, CrankTable<double>(std::vector<double>{0}), out.columns(),
                             {.instruction_set = set}),
              BatchStatus::done);
    EXPECT_DOUBLE_EQ(out.motion[0][0], 2) << name(set);
    EXPECT_DOUBLE_EQ(out.motion[1][0], 0.5) << name(set);
    EXPECT_FALSE(std::isfinite(out.motion[3][0])) << name(set);
    EXPECT_EQ(out.motion[7][0], 0) << name(set);
    EXPECT_DOUBLE_EQ(out.motion[8][0], -1) << name(set);
  }
}

}  // namespace
}  // namespace cognate
