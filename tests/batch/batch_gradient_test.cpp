/// The hand-written gradient of batches against dual numbers, on every instruction set.
#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "batch_samples.hpp"

namespace cognate {
namespace {

/// The nine dimensions and the crank angle.
constexpr int kDuals = kDesignVariables + 1;
using Jet = ceres::Jet<double, kDuals>;

/// The coupler point as a function of the dimensions and the crank angle counted from A→D.
Vec2<Jet> dual_point(const SampleDesign& design, double theta) {
  std::array<Jet, kDesignVariables> v;
  for (int k = 0; k < kDuals - 1; ++k) v[k] = Jet(design.variables[k], k);
  const Vec2<Jet> base{v[2] - v[0], v[3] - v[1]};
  const Jet frame = sqrt(squared_norm(base));
  const Vec2<Jet> axis = (Jet(1) / frame) * base;
  const auto crank = crank_direction(Jet(theta, kDuals - 1));
  const auto links =
      Closure<Jet>(Lengths<Jet>{v[4], v[5], v[6], frame}).at(crank, Jet(design.assembly));
  return Vec2<Jet>{v[0], v[1]} +
         axis * (v[4] * Vec2<Jet>{crank.cos, crank.sin} + links.coupler * Vec2<Jet>{v[7], v[8]});
}

template <class Real>
class BatchGradient : public ::testing::Test {};
using Reals = ::testing::Types<double, float>;
TYPED_TEST_SUITE(BatchGradient, Reals);

/// Compares one row of one design; false where the derivatives are too large to compare.
template <class Real>
bool check_row(const SampleDesign& given, double theta, const AllColumns<Real>& out,
               std::size_t at) {
  const SampleDesign design = rounded<Real>(given);
  const double sine = std::abs(double(out.motion[7][at]));
  if (!(sine > 0.1)) return false;
  const Vec2<Jet> exact = dual_point(design, theta);
  const double least =
      *std::min_element(design.variables.begin() + 4, design.variables.begin() + 7);
  const double frame = std::hypot(design.variables[2] - design.variables[0],
                                  design.variables[3] - design.variables[1]);
  if (frame < 0.1 || least < 0.1) return false;
  const double tolerance = 60 * std::numeric_limits<Real>::epsilon() / (sine * sine * frame);
  for (int k = 0; k < kDuals - 1; ++k) {
    EXPECT_NEAR(out.by_x[k][at], exact.x.v[k], tolerance * (1 + std::abs(exact.x.v[k]))) << k;
    EXPECT_NEAR(out.by_y[k][at], exact.y.v[k], tolerance * (1 + std::abs(exact.y.v[k]))) << k;
  }
  EXPECT_NEAR(out.motion[2][at], exact.x.v[kDuals - 1], tolerance * 10);
  EXPECT_NEAR(out.motion[3][at], exact.y.v[kDuals - 1], tolerance * 10);
  return true;
}

TYPED_TEST(BatchGradient, AgreesWithDualNumbers) {
  using Real = TypeParam;
  const auto designs = sample_designs(40, 21);
  const auto angles = sample_angles(40, 22);
  const CrankTable<Real> cranks(angles);
  for (const InstructionSet set : instruction_sets()) {
    AllColumns<Real> many(40 * 40);
    ASSERT_EQ(evaluate_batch(DesignArrays<Real>(designs).arrays(), cranks, many.columns(),
                             {.instruction_set = set}),
              BatchStatus::done);
    int compared = 0;
    for (std::size_t i = 0; i < 40; ++i) {
      for (std::size_t j = 0; j < 40; ++j) {
        compared += check_row(designs[i], angles[j], many, j * 40 + i);
      }
    }
    EXPECT_GT(compared, 300) << name(set);
    for (std::size_t i = 0; i < 5; ++i) {
      const SampleDesign design = rounded<Real>(designs[i]);
      AllColumns<Real> one(40);
      ASSERT_EQ(evaluate_batch(design.four_bar(), cranks, one.columns(), {.instruction_set = set}),
                BatchStatus::done);
      for (std::size_t j = 0; j < 40; ++j) check_row(design, angles[j], one, j);
    }
  }
}

}  // namespace
}  // namespace cognate
