/// The involute function and its inverse against 113 bits.
#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdlib>

#include "analysis/gear/involute.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear_involute_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

/// tan α − α by a convergent of Lambert's fraction that is right to 1e-28 up to π/2 and beyond.
class QuadInvolute {
 public:
  QuadInvolute() {
    Polynomial above = {Quad(0)}, below = {Quad(1)}, above_before = {Quad(1)},
               below_before = {Quad(0)};
    for (int k = 1; k <= 2 * kTerms; k += 2) {
      const bool first = k == 1;
      const Polynomial next_above = combined(k, above, first, above_before);
      const Polynomial next_below = combined(k, below, first, below_before);
      above_before = std::exchange(above, next_above);
      below_before = std::exchange(below, next_below);
    }
    below_ = below;
    above.resize(below.size());
    for (std::size_t i = 1; i < below.size(); ++i) above_.push_back(above[i] - below[i]);
  }

  Quad operator()(const Quad& angle) const {
    const Quad t = angle * angle;
    return angle * t * at(above_, t) / at(below_, t);
  }

 private:
  static constexpr int kTerms = 18;
  using Polynomial = std::vector<Quad>;

  /// k·current − t·before, or + before at the first step.
  static Polynomial combined(int k, const Polynomial& current, bool first,
                             const Polynomial& before) {
    Polynomial sum(std::max(current.size(), before.size() + 1));
    for (std::size_t i = 0; i < current.size(); ++i) sum[i] += k * current[i];
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (first) sum[i] += before[i];
      if (!first) sum[i + 1] -= before[i];
    }
    while (sum.back() == 0) sum.pop_back();
    return sum;
  }

  static Quad at(const Polynomial& polynomial, const Quad& t) {
    Quad sum = 0;
    for (std::size_t i = polynomial.size(); i-- > 0;) sum = sum * t + polynomial[i];
    return sum;
  }

  Polynomial above_, below_;
};

const QuadInvolute& quad_involute() {
  static const QuadInvolute involute;
  return involute;
}

double ulp(double value) {
  return std::nextafter(std::abs(value), kInfinity) - std::abs(value);
}

constexpr int kMillion = 1000000;

/// A million where COGNATE_TEST_SEEDS is set.
int arguments() {
  return std::getenv("COGNATE_TEST_SEEDS") != nullptr ? kMillion : 50000;
}

/// The distance of `angle` from the exact angle with this involute.
Quad angle_error(double angle, double value) {
  if (value < 1e5) {
    const Quad involute = quad_involute()(angle);
    const Quad tangent = involute + angle;
    return (involute - value) / (tangent * tangent);
  }
  // β = π/2 − α, cot β = value + α: so large that β is 1/cot β less a third of its cube.
  const Quad& right = boost::math::constants::half_pi<Quad>();
  const Quad cotangent = value + right - 1 / (value + right);
  const Quad beta = 1 / cotangent - 1 / (3 * cotangent * cotangent * cotangent);
  return angle - (right - beta);
}

TEST(GearInvolute, TheReferenceHasItsDigits) {
  for (const double angle : {0.01, 0.3, 1.0, 1.5, 1.57}) {
    const Quad exact = tan(Quad(angle)) - Quad(angle);
    EXPECT_LT(static_cast<double>(abs(quad_involute()(angle) / exact - 1)), 1e-26) << angle;
  }
}

TEST(GearInvolute, IsRightToAFewUnitsInTheLastPlace) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  double worst = 0;
  double worst_for_condition = 0;
  for (int i = 0; i < arguments(); ++i) {
    const double s = share(random);
    const double angle = i % 3 == 0   ? 1.5707963 * s
                         : i % 3 == 1 ? std::pow(10, -100 * s)
                                      : kRightAngle - std::pow(10, -15 * s);
    const Quad exact = quad_involute()(angle);
    const double error =
        static_cast<double>(abs(gear::involute(angle) - exact)) / ulp(static_cast<double>(exact));
    const double tangent = static_cast<double>(exact) + angle;
    const double condition = angle * tangent * tangent / static_cast<double>(exact);
    worst = std::max(worst, error);
    worst_for_condition = std::max(worst_for_condition, error / (1 + condition));
    ASSERT_LT(error, 5) << angle;
    ASSERT_EQ(gear::involute(-angle), -gear::involute(angle));
  }
  EXPECT_LT(worst_for_condition, 1);
  RecordProperty("worst_ulp", std::to_string(worst));
  RecordProperty("worst_ulp_for_condition", std::to_string(worst_for_condition));
}

TEST(GearInvolute, InverseIsRightToTwoUnitsInTheLastPlace) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> share(0, 1);
  double worst = 0;
  for (int i = 0; i < kMillion; ++i) {
    const double s = share(random);
    const double value = i % 4 == 0   ? 3 * s
                         : i % 4 == 1 ? std::pow(10, -307 * s)
                         : i % 4 == 2 ? std::pow(10, 308 * s)
                                      : std::pow(10, -4 + 6 * s);
    const double angle = gear::involute_angle(value);
    const double error = static_cast<double>(abs(angle_error(angle, value))) / ulp(angle);
    worst = std::max(worst, error);
    ASSERT_LT(error, 2) << value;
    ASSERT_EQ(gear::involute_angle(-value), -angle);
  }
  RecordProperty("worst_ulp", std::to_string(worst));
}

// Of degrees the conversion to radians must not cost digits towards 90°, where inv grows without
// bound.
TEST(GearInvolute, OfDegreesIsRightToTheLastDigits) {
  const Quad radian = boost::math::constants::pi<Quad>() / 180;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < arguments(); ++i) {
    const double s = share(random);
    const double degrees = i % 3 == 0   ? 89.99 * s
                           : i % 3 == 1 ? std::pow(10, -80 * s)
                                        : 90 - std::pow(10, -12 * s);
    // Near 90° by the cotangent of the complement, which Quad has exactly.
    const Quad complement = (90 - Quad(degrees)) * radian;
    const Quad exact = degrees > 45 ? Quad(1 / tan(complement) - Quad(degrees) * radian)
                                    : quad_involute()(Quad(degrees) * radian);
    const Quad error = abs(gear::involute_of_degrees(degrees) / exact - 1);
    ASSERT_LT(static_cast<double>(error), 1.2e-15) << degrees;
    ASSERT_EQ(gear::involute_of_degrees(-degrees), -gear::involute_of_degrees(degrees));
    const double back = gear::involute_angle_in_degrees(gear::involute_of_degrees(degrees));
    ASSERT_NEAR(back, degrees, 1e-15 * degrees) << degrees;
  }
}

TEST(GearInvolute, EndsOfTheRange) {
  EXPECT_EQ(gear::involute(0), 0);
  EXPECT_EQ(gear::involute_angle(0), 0);
  EXPECT_TRUE(std::signbit(gear::involute_angle(-0.0)));
  EXPECT_DOUBLE_EQ(gear::involute_angle(1e-300), std::cbrt(3.0) * 1e-100);
  // The least number that there is: 2^-1074, whose cube root is 2^-358.
  EXPECT_DOUBLE_EQ(gear::involute_angle(0x1p-1074), std::cbrt(3.0) * 0x1p-358);
  EXPECT_EQ(gear::involute_angle(1e300), kRightAngle);
  EXPECT_EQ(gear::involute_angle(-kInfinity), -kRightAngle);
  EXPECT_TRUE(std::isnan(gear::involute_angle(std::nan(""))));
  EXPECT_TRUE(std::isnan(gear::involute(std::nan(""))));
}

TEST(GearInvolute, InverseRises) {
  double before = 0;
  for (double value = 1e-12; value < 1e6; value *= 1.0007) {
    const double angle = gear::involute_angle(value);
    ASSERT_GT(angle, before) << value;
    before = angle;
  }
}

}  // namespace
}  // namespace cognate::gear_involute_test
