// Motion laws against their formulas in 113 bits, against what handbooks print, and against
// quadrature of their acceleration.
#include "analysis/cam/motion_law.hpp"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "analysis/cam/universal_law.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::cam::motion_law_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using MotionSample = std::array<Quad, 4>;  ///< displacement, velocity, acceleration, jerk
using Law = std::function<MotionSample(const Quad&)>;

const Quad kPi = acos(Quad(-1));
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

template <class T>
std::array<T, 4> as_array(const FollowerMotion<T>& motion) {
  return {motion.displacement, motion.velocity, motion.acceleration, motion.jerk};
}

/// The pieces' motion at the angle `angle`, of the later piece at a border.
template <class T>
std::array<T, 4> motion_of(const std::vector<MotionPiece<T>>& pieces, const T& angle) {
  std::size_t i = pieces.size() - 1;
  while (i > 0 && angle < pieces[i].begin) --i;
  return as_array(motion_at(pieces[i], T((angle - pieces[i].begin) / pieces[i].span)));
}

std::vector<MotionPiece<double>> pieces_of(const MotionSegment& segment, double begin = 0,
                                           double start = 0) {
  std::vector<MotionPiece<double>> pieces;
  EXPECT_TRUE(append_pieces(segment, begin, start, 0, pieces));
  return pieces;
}

MotionSample constant_acceleration(const Quad& u) {
  if (u < Quad(0.5)) return {2 * u * u, 4 * u, 4, 0};
  return {1 - 2 * (1 - u) * (1 - u), 4 * (1 - u), -4, 0};
}

MotionSample harmonic(const Quad& u) {
  const Quad s = sin(kPi * u), c = cos(kPi * u);
  return {(1 - c) / 2, kRightAngle * s, kPi * kRightAngle * c, -kPi * kPi * kRightAngle * s};
}

MotionSample cycloidal(const Quad& u) {
  const Quad w = kTurn, s = sin(w * u), c = cos(w * u);
  return {u - s / w, 1 - c, w * s, w * w * c};
}

MotionSample polynomial_345(const Quad& u) {
  const Quad v = 1 - u;
  return {u * u * u * (10 - 15 * u + 6 * u * u), 30 * u * u * v * v, 60 * u * v * (1 - 2 * u),
          60 * (1 - 6 * u + 6 * u * u)};
}

MotionSample polynomial_4567(const Quad& u) {
  const Quad v = 1 - u;
  return {pow(u, 4) * (35 - 84 * u + 70 * u * u - 20 * u * u * u), 140 * pow(u * v, 3),
          420 * pow(u * v, 2) * (1 - 2 * u), 840 * u * v * (1 - 5 * u + 5 * u * u)};
}

MotionSample double_harmonic(const Quad& u) {
  const Quad s = sin(kPi * u), c = cos(kPi * u), s2 = sin(kTurn * u), c2 = cos(kTurn * u);
  return {(1 - c) / 2 - (1 - c2) / 8, kRightAngle * s - kPi / 4 * s2, kPi * kRightAngle * (c - c2),
          kPi * kPi * kRightAngle * (2 * s2 - s)};
}

/// Norton, Cam Design and Manufacturing Handbook, the modified sine's displacement as printed.
MotionSample modified_sine(const Quad& u) {
  const Quad k = 1 / (4 + kPi);
  const bool is_fast = u < Quad(0.125) || u > Quad(0.875);
  const Quad w = is_fast ? Quad(4 * kPi) : Quad(4 * kPi / 3),
             phase = is_fast ? Quad(0) : Quad(kPi / 3), size = is_fast ? k / 4 : 9 * k / 4;
  const Quad level = u < Quad(0.125) ? Quad(0) : u > Quad(0.875) ? Quad(4 * k) : Quad(2 * k);
  const Quad s = sin(w * u + phase), c = cos(w * u + phase);
  return {level + kPi * k * u - size * s, kPi * k - size * w * c, size * w * w * s,
          size * w * w * w * c};
}

/// Universal laws by quadrature: of the acceleration's course nothing but its definition.
class ByQuadrature {
 public:
  explicit ByQuadrature(const UniversalShape<Quad>& shape)
      : shape_(shape),
        borders_{0, shape.sine / 2, (shape.sine + shape.constant) / 2,
                 (shape.sine + shape.constant + shape.cosine) / 2} {
    size_ = 1 / (2 * moment(Quad(0.5)));
  }
  MotionSample operator()(const Quad& u) const {
    if (u > Quad(0.5)) {
      const MotionSample first = (*this)(1 - u);
      return {1 - first[0], first[1], -first[2], first[3]};
    }
    const auto [acceleration, jerk] = shape_and_slope(u);
    const Quad velocity = over_parts(u, [&](const Quad& at) { return shape_and_slope(at).first; });
    return {size_ * moment(u), size_ * velocity, size_ * acceleration, size_ * jerk};
  }

 private:
  std::pair<Quad, Quad> shape_and_slope(const Quad& u) const {
    if (u < borders_[1]) {
      const Quad w = kPi / shape_.sine;
      return {sin(w * u), w * cos(w * u)};
    }
    if (u < borders_[2]) return {1, 0};
    if (u >= borders_[3]) return {0, 0};
    const Quad w = kPi / shape_.cosine;
    return {cos(w * (u - borders_[2])), -w * sin(w * (u - borders_[2]))};
  }
  template <class F>
  Quad over_parts(const Quad& end, F&& f) const {
    Quad sum = 0;
    for (std::size_t i = 0; i + 1 < borders_.size() && borders_[i] < end; ++i) {
      const Quad to = std::min(borders_[i + 1], end);
      if (to > borders_[i]) {
        sum += boost::math::quadrature::gauss<Quad, 30>::integrate(f, borders_[i], to);
      }
    }
    return sum;
  }
  Quad moment(const Quad& end) const {
    return over_parts(end, [&](const Quad& at) { return (end - at) * shape_and_slope(at).first; });
  }

  UniversalShape<Quad> shape_;
  std::array<Quad, 4> borders_;
  Quad size_ = 1;
};

/// Every derivative of `segment` within a few ulp of its greatest value of rise · law(u).
void expect_accurate(const MotionSegment& segment, const Law& law, int places) {
  constexpr double kBegin = 0.75, kStart = 1.25;
  const auto pieces = pieces_of(segment, kBegin, kStart);
  std::array<double, 5> peak{}, error{};
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  for (int place = 0; place < places; ++place) {
    const double angle = kBegin + segment.over * share(random);
    const MotionSample exact = law((Quad(angle) - kBegin) / segment.over);
    const auto motion = motion_of(pieces, angle);
    Quad unit = segment.rise;
    for (std::size_t order = 0; order < 4; ++order) {
      const Quad wanted = unit * exact[order] + (order == 0 ? kStart : 0.0);
      peak[order] = std::max(peak[order], std::abs(static_cast<double>(wanted)));
      error[order] = std::max(error[order], std::abs(static_cast<double>(motion[order] - wanted)));
      unit /= segment.over;
    }
  }
  for (std::size_t order = 0; order < 4; ++order) {
    // Of the angle's own rounding as well, which the next derivative makes an error of this one.
    EXPECT_LE(error[order], kEpsilon * (12 * peak[order] + 2 * peak[order + 1]))
        << "derivative " << order;
  }
}

MotionSegment segment_of(MotionLaw law, double over = 1.5, double rise = 2.75) {
  MotionSegment segment;
  segment.law = law;
  segment.over = over;
  segment.rise = rise;
  return segment;
}

struct NamedLaw {
  MotionLaw law;
  Law formula;
};

std::vector<NamedLaw> named_laws() {
  return {{MotionLaw::constant_velocity,
           [](const Quad& u) {
             return MotionSample{u, 1, 0, 0};
           }},
          {MotionLaw::constant_acceleration, constant_acceleration},
          {MotionLaw::harmonic, harmonic},
          {MotionLaw::cycloidal, cycloidal},
          {MotionLaw::polynomial_345, polynomial_345},
          {MotionLaw::polynomial_4567, polynomial_4567},
          {MotionLaw::modified_sine, modified_sine},
          {MotionLaw::double_harmonic, double_harmonic}};
}

TEST(MotionLaw, DerivativesHoldAgainstTheirFormulasIn113Bits) {
  for (const auto& [law, formula] : named_laws()) {
    SCOPED_TRACE(static_cast<int>(law));
    expect_accurate(segment_of(law), formula, 1000);
    expect_accurate(segment_of(law, 0.3, 1e-3), formula, 200);
  }
}

TEST(MotionLaw, UniversalLawsHoldAgainstQuadratureOfTheirAcceleration) {
  const Quad eighth(0.125);
  expect_accurate(segment_of(MotionLaw::modified_trapezoid),
                  ByQuadrature({2 * eighth, 4 * eighth, 2 * eighth}), 200);
  expect_accurate(segment_of(MotionLaw::modified_constant_velocity),
                  ByQuadrature({eighth, 0, 3 * eighth}), 200);
  std::mt19937_64 random(2);
  std::uniform_int_distribution<int> sixteenths(0, 5);
  for (int trial = 0; trial < 12; ++trial) {
    const UniversalShape<double> shape{sixteenths(random) / 16.0, sixteenths(random) / 16.0,
                                       (1 + sixteenths(random)) / 16.0};
    MotionSegment segment = segment_of(MotionLaw::universal);
    segment.shape = shape;
    expect_accurate(segment, ByQuadrature({shape.sine, shape.constant, shape.cosine}), 40);
  }
}

TEST(MotionLaw, ReturnsFallByTheSameFormulas) {
  for (const auto& [law, formula] : named_laws()) {
    SCOPED_TRACE(static_cast<int>(law));
    const bool is_mirrored = law == MotionLaw::double_harmonic;
    const Law fall = [&, f = formula](const Quad& u) {
      if (!is_mirrored) return f(u);
      const MotionSample back = f(1 - u);
      return MotionSample{1 - back[0], back[1], -back[2], back[3]};
    };
    expect_accurate(segment_of(law, 1.5, -2.75), fall, 200);
  }
}

TEST(MotionLaw, InWideTypesLawsAreAsWide) {
  const UniversalShape<Quad> shape{Quad(1) / 5, Quad(1) / 7, Quad(1) / 3};
  std::vector<MotionPiece<Quad>> pieces;
  append_universal(shape, Quad(0), Quad(1), Quad(0), Quad(1), 0, pieces);
  ASSERT_EQ(pieces.size(), 7U);
  const ByQuadrature law(shape);
  for (int i = 1; i < 50; ++i) {
    const Quad u = Quad(i) / 50;
    const auto motion = motion_of(pieces, u);
    const MotionSample exact = law(u);
    for (std::size_t order = 0; order < 4; ++order) {
      EXPECT_LT(static_cast<double>(abs(motion[order] - exact[order])), 1e-30) << i << ' ' << order;
    }
  }
}

TEST(MotionLaw, EndsAreExact) {
  int tested = 0;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> length(-50, 50), angle(0.1, 3);
  for (int trial = 0; trial < 500; ++trial) {
    const double begin = angle(random), start = length(random);
    for (int law = 1; law <= static_cast<int>(MotionLaw::double_harmonic); ++law) {
      SCOPED_TRACE(law);
      const auto segment = segment_of(static_cast<MotionLaw>(law), angle(random), length(random));
      const auto pieces = pieces_of(segment, begin, start);
      const auto first = motion_at(pieces.front(), 0.0), last = motion_at(pieces.back(), 1.0);
      EXPECT_EQ(first.displacement, start);
      EXPECT_EQ(last.displacement, start + segment.rise);
      if (segment.law == MotionLaw::constant_velocity) continue;
      ++tested;
      EXPECT_EQ(first.velocity, 0);
      EXPECT_EQ(last.velocity, 0);
    }
  }
  EXPECT_GE(tested, 4000);
}

/// `value` with as many decimals as `printed` has.
std::string like(const std::string& printed, double value) {
  const auto point = printed.find('.');
  const int decimals =
      point == std::string::npos ? 0 : static_cast<int>(printed.size() - point - 1);
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.*f", decimals, value);
  return digits.data();
}

TEST(MotionLaw, PeakFactorsAreThoseOfHandbooks) {
  int tested = 0;
  const std::vector<std::pair<MotionLaw, std::array<std::string, 3>>> all{
      {MotionLaw::dwell, {"0", "0", "0"}},
      {MotionLaw::constant_velocity, {"1", "0", "0"}},  // infinite at its ends alone
      {MotionLaw::constant_acceleration, {"2", "4", "inf"}},
      {MotionLaw::harmonic, {"1.5708", "4.9348", "15.503"}},
      {MotionLaw::cycloidal, {"2", "6.2832", "39.478"}},
      {MotionLaw::polynomial_345, {"1.875", "5.7735", "60"}},
      {MotionLaw::polynomial_4567, {"2.1875", "7.5132", "52.5"}},
      {MotionLaw::modified_sine, {"1.7596", "5.5280", "69.47"}},
      {MotionLaw::modified_trapezoid, {"2", "4.8881", "61.43"}},
      {MotionLaw::modified_constant_velocity, {"1.28", "8.01", "201.4"}},
      {MotionLaw::double_harmonic, {"2.04", "9.87", "42.4"}}};
  for (const auto& [law, printed] : all) {
    SCOPED_TRACE(static_cast<int>(law));
    for (const double rise : {2.5, -2.5}) {
      const PeakFactors found = peak_factors(segment_of(law, 0.7, rise));
      EXPECT_EQ(like(printed[0], found.velocity), printed[0]);
      EXPECT_EQ(like(printed[1], found.acceleration), printed[1]);
      EXPECT_EQ(like(printed[2], found.jerk), printed[2]);
    }
    if (law == MotionLaw::constant_velocity) continue;
    ++tested;
    const auto handbook = handbook_factors(law);
    ASSERT_TRUE(handbook);
    EXPECT_EQ(handbook->velocity, std::stod(printed[0]));
    EXPECT_EQ(handbook->acceleration, std::stod(printed[1]));
    EXPECT_EQ(handbook->jerk, std::stod(printed[2]));
  }
  EXPECT_TRUE(std::isinf(handbook_factors(MotionLaw::constant_velocity)->acceleration));
  EXPECT_FALSE(handbook_factors(MotionLaw::spline));
  EXPECT_GE(tested, 10);
}

/// In closed form, to rounding.
TEST(MotionLaw, PeakFactorsAreExact) {
  const double pi = std::acos(-1.0);
  const auto factors = [](MotionLaw law) { return peak_factors(segment_of(law, 0.7, 2.5)); };
  EXPECT_NEAR(factors(MotionLaw::polynomial_345).acceleration, 10 / std::sqrt(3.0), 1e-13);
  EXPECT_NEAR(factors(MotionLaw::polynomial_4567).acceleration, 84 * std::sqrt(5.0) / 25, 1e-13);
  EXPECT_NEAR(factors(MotionLaw::cycloidal).jerk, 4 * pi * pi, 1e-12);
  EXPECT_NEAR(factors(MotionLaw::modified_sine).velocity, 4 * pi / (4 + pi), 1e-14);
  EXPECT_NEAR(factors(MotionLaw::modified_sine).acceleration, 4 * pi * pi / (4 + pi), 1e-13);
  EXPECT_NEAR(factors(MotionLaw::modified_trapezoid).acceleration, 8 * pi / (2 + pi), 1e-13);
  EXPECT_NEAR(factors(MotionLaw::double_harmonic).velocity, 3 * std::sqrt(3.0) * pi / 8, 1e-14);
  const double c = (1 + std::sqrt(129.0)) / -16 + 0.125;  // where 8c² − c − 4 = 0
  EXPECT_NEAR(factors(MotionLaw::double_harmonic).jerk,
              std::pow(pi, 3) / 2 * std::sqrt(1 - c * c) * (1 - 4 * c), 1e-12);
}

TEST(MotionLaw, TheUniversalFamilyHoldsTheNamedLaws) {
  const std::vector<std::pair<MotionLaw, UniversalShape<double>>> same{
      {MotionLaw::constant_velocity, {0, 0, 0}},
      {MotionLaw::constant_acceleration, {0, 1, 0}},
      {MotionLaw::harmonic, {0, 0, 1}},
      {MotionLaw::cycloidal, {0.5, 0, 0.5}},
      {MotionLaw::modified_sine, {0.25, 0, 0.75}}};
  for (const auto& [law, shape] : same) {
    SCOPED_TRACE(static_cast<int>(law));
    MotionSegment universal = segment_of(MotionLaw::universal);
    universal.shape = shape;
    const auto pieces = pieces_of(universal), named = pieces_of(segment_of(law));
    for (int i = 0; i < 200; ++i) {
      const double angle = 1.5 * (i + 0.3) / 200;
      const auto motion = motion_of(pieces, angle), wanted = motion_of(named, angle);
      for (std::size_t order = 0; order < 4; ++order) {
        EXPECT_NEAR(motion[order], wanted[order], 2e-13) << i << ' ' << order;
      }
    }
  }
}

TEST(MotionLaw, SharesOutOfRangeAreRefused) {
  std::vector<MotionPiece<double>> pieces;
  MotionSegment segment = segment_of(MotionLaw::universal);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& shape : std::vector<UniversalShape<double>>{
           {-0.1, 0.5, 0.5}, {0.4, 0.4, 0.3}, {nan, 0, 0}, {0, 0, 1.1}}) {
    segment.shape = shape;
    EXPECT_FALSE(append_pieces(segment, 0, 0, 0, pieces));
  }
  EXPECT_TRUE(pieces.empty());
  segment.shape = {0.1, 0.2, 0.7};  // 1 but for rounding: no piece at constant velocity
  EXPECT_TRUE(append_pieces(segment, 0, 0, 0, pieces));
  EXPECT_EQ(pieces.size(), 6U);
}

/// Derivatives by the three shares, the span and the rise, of the motion at a fixed cam angle,
/// against differences in 113 bits; at a share of 0 the one-sided ones.
TEST(MotionLaw, JetsCarryTheDerivativesByShapeSpanAndRise) {
  using Jet = ceres::Jet<double, 5>;
  const auto displacement = [](const std::array<Quad, 5>& p, const Quad& angle) {
    std::vector<MotionPiece<Quad>> pieces;
    append_universal<Quad>({p[0], p[1], p[2]}, Quad(0), p[3], Quad(0), p[4], 0, pieces);
    return motion_of(pieces, angle);
  };
  for (const auto& values : std::vector<std::array<double, 5>>{
           {0.2, 0.3, 0.4, 1.5, 2.5}, {0.25, 0, 0.5, 0.7, -3}, {0, 0.25, 0.5, 1, 1}}) {
    std::array<Jet, 5> jets;
    std::array<Quad, 5> base;
    for (int i = 0; i < 5; ++i) {
      const auto k = static_cast<std::size_t>(i);
      jets[k] = Jet(values[k], i);
      base[k] = values[k];
    }
    std::vector<MotionPiece<Jet>> pieces;
    append_universal<Jet>({jets[0], jets[1], jets[2]}, Jet(0), jets[3], Jet(0), jets[4], 0, pieces);
    for (int place = 0; place < 40; ++place) {
      const double angle = values[3] * (place + 0.37) / 40;
      const auto motion = motion_of(pieces, Jet(angle));
      const auto here = displacement(base, angle);
      for (std::size_t k = 0; k < 5; ++k) {
        auto moved = base;
        moved[k] += Quad(1e-14);
        const auto there = displacement(moved, angle);
        for (std::size_t order = 0; order < 4; ++order) {
          const auto difference = static_cast<double>((there[order] - here[order]) / Quad(1e-14));
          EXPECT_NEAR(motion[order].v[static_cast<int>(k)], difference,
                      1e-10 * (1 + std::abs(difference)))
              << place << ' ' << k << ' ' << order;
        }
      }
    }
  }
}

TEST(MotionLaw, WholeQuarterTurnsAreExact) {
  for (int quarter = -16; quarter <= 16; ++quarter) {
    const auto [sine, cosine] = sine_cosine_of_half_turns(0.5 * quarter);
    const std::array<double, 4> sines{0, 1, 0, -1};
    EXPECT_EQ(sine, sines[static_cast<std::size_t>(quarter & 3)]);
    EXPECT_EQ(cosine, sines[static_cast<std::size_t>((quarter + 1) & 3)]);
  }
  EXPECT_LT(static_cast<double>(abs(pi_of<Quad>() - kPi)), 1e-33);
  EXPECT_EQ(pi_of<double>(), std::acos(-1.0));
}

}  // namespace
}  // namespace cognate::cam::motion_law_test
