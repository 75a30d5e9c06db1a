/// The kernel's closure keeps the bounds that tests/stress states, on fixed configurations.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/stress/accuracy.hpp"
#include "tests/stress/closure_families.hpp"

namespace cognate::stress {

static std::ostream& operator<<(std::ostream& out, const Family& family) {
  return out << family.name;
}

namespace {

constexpr int kSamples = 600;  // for each family

Accuracy measure(const Family& family, Answer (*form)(const Configuration&)) {
  std::mt19937_64 random(7);
  Accuracy accuracy;
  const int each = kSamples / static_cast<int>(family.distances.size());
  for (const double distance : family.distances) {
    for (int i = 0; i < each; ++i) {
      const Configuration at = family.draw(distance, random);
      accuracy.include(at, exact_closure(at), form(at));
    }
  }
  return accuracy;
}

/// One test for each family.
class ClosureAccuracy : public ::testing::TestWithParam<Family> {};

TEST_P(ClosureAccuracy, KeepsItsBounds) {
  const Accuracy kernel_here = measure(GetParam(), kernel);
  EXPECT_GT(kernel_here.closed, kSamples / 4);
  EXPECT_LE(kernel_here.well_conditioned, 10);
  EXPECT_LE(kernel_here.per_condition, 2);
  EXPECT_LE(kernel_here.wrong_flag_distance, 1);
}

INSTANTIATE_TEST_SUITE_P(Families, ClosureAccuracy, ::testing::ValuesIn(closure_families()));

TEST(ClosureAccuracy, CommonFormsLoseHalfTheirDigitsAtChangePoints) {
  int tested = 0;
  for (const Family& family : closure_families()) {
    if (family.name != "change point") continue;
    ++tested;
    EXPECT_LE(measure(family, kernel).error, 10);
    for (const auto& form : {law_of_cosines, half_angle_tangents, raw_discriminant, sorted_sides}) {
      EXPECT_GT(measure(family, form).error, 1e6);
    }
  }
  EXPECT_GE(tested, 1);
}

TEST(ExactClosure, ClosesItsLoopTo113BitsAndMore) {
  int tested = 0;
  for (const Family& family : closure_families()) {
    std::mt19937_64 random(8);
    for (const double distance : family.distances) {
      const Configuration at = family.draw(distance, random);
      const ExactClosure exact = exact_closure(at);
      if (!exact.closes) continue;
      ++tested;
      const Exact tolerance = ldexp(Exact(1), -113);
      EXPECT_LT(abs(squared_norm(exact.coupler) - 1), tolerance) << family.name;
      EXPECT_LT(abs(squared_norm(exact.rocker) - 1), tolerance) << family.name;
    }
  }
  EXPECT_GE(tested, 240);
}

/// `at` with the input number `index` changed by the part `step`.
Configuration changed(Configuration at, int index, double step) {
  double* const inputs[] = {&at.links.crank,     &at.links.coupler,  &at.links.rocker,
                            &at.links.frame,     &at.half_crank.x,   &at.half_crank.y,
                            &at.coupler_point.x, &at.coupler_point.y};
  *inputs[index] *= 1 + step;
  return at;
}

TEST(ExactClosure, ConditionIsTheSumOfFiniteDifferences) {
  std::mt19937_64 random(9);
  const Family family = closure_families()[1];
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const Configuration at = family.draw(1, random);
    const ExactClosure exact = exact_closure(at);
    if (!exact.closes || exact.coupler_condition > 100) continue;
    ++checked;
    double coupler = 0, rocker = 0, point = 0;
    for (int k = 0; k < 8; ++k) {
      constexpr double kStep = 0x1p-30;
      const ExactClosure more = exact_closure(changed(at, k, kStep));
      const ExactClosure less = exact_closure(changed(at, k, -kStep));
      const auto slope = [](const Vec2<Exact>& a, const Vec2<Exact>& b) {
        return double(sqrt(squared_norm(a - b))) / (2 * kStep);
      };
      coupler += slope(more.coupler, less.coupler);
      rocker += slope(more.rocker, less.rocker);
      point += slope(more.point, less.point) / exact.size;
    }
    EXPECT_NEAR(exact.coupler_condition / coupler, 1, 1e-6);
    EXPECT_NEAR(exact.rocker_condition / rocker, 1, 1e-6);
    EXPECT_NEAR(exact.point_condition / point, 1, 1e-6);
  }
  EXPECT_GT(checked, 50);
}

}  // namespace
}  // namespace cognate::stress
