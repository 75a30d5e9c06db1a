/// Batches against themselves: in other sizes, orders, layouts and numbers of threads.
#include <gtest/gtest.h>

#include <algorithm>

#include "batch_samples.hpp"

namespace cognate {
namespace {

template <class Real>
class BatchInvariance : public ::testing::Test {};
using Reals = ::testing::Types<double, float>;
TYPED_TEST_SUITE(BatchInvariance, Reals);

/// Bitwise equality, NaN included.
template <class Real>
[[nodiscard]] bool same_bits(const std::vector<Real>& a, const std::vector<Real>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](Real x, Real y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

TYPED_TEST(BatchInvariance, DoesNotDependOnThreadsOrNeighbours) {
  using Real = TypeParam;
  const auto designs = sample_designs(1100, 5);
  const auto angles = sample_angles(5, 6);
  const auto cranks = CrankTable<Real>(angles);
  const DesignArrays<Real> arrays(designs);
  for (const InstructionSet set : instruction_sets()) {
    AllColumns<Real> one(1100 * 5), three(1100 * 5);
    ASSERT_EQ(evaluate_batch(arrays.arrays(), cranks, one.columns(), {.instruction_set = set}),
              BatchStatus::done);
    ASSERT_EQ(evaluate_batch(arrays.arrays(), cranks, three.columns(),
                             {.threads = 3, .instruction_set = set}),
              BatchStatus::done);
    EXPECT_TRUE(same_bits(one.values(), three.values())) << name(set);
    for (const std::size_t i : {0, 517, 1099}) {
      const DesignArrays<Real> alone({designs[i]});
      AllColumns<Real> few(5);
      ASSERT_EQ(evaluate_batch(alone.arrays(), cranks, few.columns(), {.instruction_set = set}),
                BatchStatus::done);
      for (std::size_t j = 0; j < 5; ++j) {
        const Real x = few.motion[0][j], expected = one.motion[0][j * 1100 + i];
        EXPECT_TRUE(x == expected || (std::isnan(x) && std::isnan(expected))) << name(set);
      }
    }
  }
}

TYPED_TEST(BatchInvariance, GivesARowTheSameValueInAnyTable) {
  using Real = TypeParam;
  const FourBar linkage = sample_designs(1, 7)[0].four_bar();
  std::vector<double> sweep(20001);
  for (std::size_t i = 0; i < sweep.size(); ++i) sweep[i] = 1e-3 * static_cast<double>(i) - 4;
  std::vector<double> jumping = sweep;
  std::shuffle(jumping.begin(), jumping.end(), std::mt19937(1));
  std::vector<std::size_t> row(sweep.size());
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    row[i] = static_cast<std::size_t>(std::lround((jumping[i] + 4) * 1000));
  }
  for (const InstructionSet set : instruction_sets()) {
    AllColumns<Real> straight(sweep.size()), threaded(sweep.size()), mixed(sweep.size());
    ASSERT_EQ(evaluate_batch(linkage, CrankTable<Real>(sweep), straight.columns(),
                             {.instruction_set = set}),
              BatchStatus::done);
    ASSERT_EQ(evaluate_batch(linkage, CrankTable<Real>(sweep), threaded.columns(),
                             {.threads = 2, .instruction_set = set}),
              BatchStatus::done);
    EXPECT_TRUE(same_bits(straight.values(), threaded.values()));
    ASSERT_EQ(evaluate_batch(linkage, CrankTable<Real>(jumping), mixed.columns(),
                             {.instruction_set = set}),
              BatchStatus::done);
    std::vector<Real> expected(sweep.size());
    for (std::size_t column = 0; column < straight.motion.size(); ++column) {
      for (std::size_t i = 0; i < sweep.size(); ++i) {
        expected[i] = straight.motion[column][row[i]];
      }
      EXPECT_TRUE(same_bits(mixed.motion[column], expected)) << name(set) << " " << column;
    }
  }
}

TYPED_TEST(BatchInvariance, AgreesBetweenItsLayoutsAndSets) {
  using Real = TypeParam;
  const auto designs = sample_designs(21, 8);
  const auto angles = sample_angles(50, 9);
  const auto cranks = CrankTable<Real>(angles);
  const double eps = unit_roundoff<Real>;
  for (const InstructionSet set : instruction_sets()) {
    AllColumns<Real> many(21 * 50);
    const DesignArrays<Real> arrays(designs);
    ASSERT_EQ(evaluate_batch(arrays.arrays(), cranks, many.columns(), {.instruction_set = set}),
              BatchStatus::done);
    for (std::size_t i = 0; i < designs.size(); ++i) {
      std::vector<Real> x(50), y(50);
      ASSERT_EQ(evaluate_batch(rounded<Real>(designs[i]).four_bar(), cranks, {.x = x, .y = y},
                               {.instruction_set = set}),
                BatchStatus::done);
      for (std::size_t j = 0; j < 50; ++j) {
        const std::size_t at = j * 21 + i;
        const double sine = std::abs(double(many.motion[7][at]));
        if (!(sine > 1e-2)) continue;
        EXPECT_NEAR(x[j], many.motion[0][at], 60 * eps / sine) << name(set);
        EXPECT_NEAR(y[j], many.motion[1][at], 60 * eps / sine) << name(set);
      }
    }
  }
}

TYPED_TEST(BatchInvariance, TakesManyPointsOfManyDesigns) {
  using Real = TypeParam;
  constexpr std::size_t count = 19, points = 3, rows = 7;
  const auto designs = sample_designs(count, 10);
  const auto angles = sample_angles(rows, 11);
  const auto cranks = CrankTable<Real>(angles);
  const DesignArrays<Real> arrays(designs);
  std::vector<Real> u, v;
  for (std::size_t k = 0; k < points * count; ++k) {
    u.push_back(Real(0.1) * Real(k));
    v.push_back(Real(1) - Real(0.05) * Real(k));
  }
  FourBarArrays<Real> pointed = arrays.arrays();
  pointed.point_u = u;
  pointed.point_v = v;
  for (const InstructionSet set : instruction_sets()) {
    std::vector<Real> x(points * rows * count), y(x.size()), curvature(x.size());
    std::vector<Real> sine(rows * count), cosine(rows * count);
    ASSERT_EQ(evaluate_batch(pointed, cranks,
                             {.x = x,
                              .y = y,
                              .curvature = curvature,
                              .transmission_sin = sine,
                              .transmission_cos = cosine},
                             {.instruction_set = set}),
              BatchStatus::done);
    for (std::size_t p = 0; p < points; ++p) {
      FourBarArrays<Real> single = arrays.arrays();
      single.point_u = std::span(u).subspan(p * count, count);
      single.point_v = std::span(v).subspan(p * count, count);
      std::vector<Real> x1(rows * count), y1(rows * count), curvature1(rows * count);
      ASSERT_EQ(evaluate_batch(single, cranks, {.x = x1, .y = y1, .curvature = curvature1},
                               {.instruction_set = set}),
                BatchStatus::done);
      const auto part = [&](const std::vector<Real>& all) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(p * rows * count);
        return std::vector<Real>(begin, begin + rows * count);
      };
      EXPECT_TRUE(same_bits(part(x), x1));
      EXPECT_TRUE(same_bits(part(y), y1));
      EXPECT_TRUE(same_bits(part(curvature), curvature1));
    }
  }
}

TEST(BatchScale, IsExactForPowersOfTwo) {
  const auto designs = sample_designs(24, 12);
  const auto angles = sample_angles(30, 13);
  for (const InstructionSet set : instruction_sets()) {
    AllColumns<double> normal(24 * 30);
    ASSERT_EQ(evaluate_batch(DesignArrays<double>(designs).arrays(), CrankTable<double>(angles),
                             normal.columns(), {.instruction_set = set}),
              BatchStatus::done);
    for (const double scale : {0x1p-498, 0x1p+498}) {  // 1e-150 and 1e150
      auto scaled = designs;
      for (SampleDesign& one : scaled) {
        for (double& value : one.variables) value *= scale;
      }
      AllColumns<double> out(24 * 30);
      ASSERT_EQ(evaluate_batch(DesignArrays<double>(scaled).arrays(), CrankTable<double>(angles),
                               out.columns(), {.instruction_set = set}),
                BatchStatus::done);
      for (std::size_t column = 0; column < 7; ++column) {
        const double back = column == 6 ? scale : 1 / scale;
        for (double& value : out.motion[column]) value *= back;
      }
      EXPECT_TRUE(same_bits(out.values(), normal.values())) << name(set) << " " << scale;
    }
  }
}

TEST(BatchStatus, NamesWhatIsWrong) {
  const CrankTable<double> cranks(std::vector<double>{0, 1, 2});
  std::vector<double> x(3), y(3), short_y(2);
  FourBar linkage{{0, 0}, {3, 0}, 1, 3, 3, Assembly::open, {}};
  EXPECT_EQ(evaluate_batch(linkage, cranks, {.x = x, .y = y}), BatchStatus::no_coupler_point);
  EXPECT_EQ(evaluate_batch(linkage, cranks, {.transmission_sin = x, .transmission_cos = y}),
            BatchStatus::done);
  linkage.coupler_point = Vec2d{1, 1};
  EXPECT_EQ(evaluate_batch(linkage, cranks, FourBarColumns<double>{}), BatchStatus::nothing_wanted);
  EXPECT_EQ(evaluate_batch(linkage, cranks, {.x = x}), BatchStatus::sizes_differ);
  EXPECT_EQ(evaluate_batch(linkage, cranks, {.x = x, .y = short_y}), BatchStatus::sizes_differ);
  if (instruction_sets().back() != InstructionSet::avx512) {
    EXPECT_EQ(evaluate_batch(linkage, cranks, {.x = x, .y = y},
                             {.instruction_set = InstructionSet::avx512}),
              BatchStatus::missing_instruction_set);
  }
  const auto designs = sample_designs(4, 1);
  const DesignArrays<double> arrays(designs);
  FourBarArrays<double> unequal = arrays.arrays();
  unequal.rocker = unequal.rocker.first(3);
  std::vector<double> many(12);
  EXPECT_EQ(evaluate_batch(unequal, cranks, {.x = many, .y = many}), BatchStatus::sizes_differ);
  FourBarArrays<double> pointless = arrays.arrays();
  pointless.point_u = pointless.point_v = {};
  EXPECT_EQ(evaluate_batch(pointless, cranks, {.x = many, .y = many}),
            BatchStatus::no_coupler_point);
}

}  // namespace
}  // namespace cognate
