/// Models of third order against the functions that they stand for, in 80 and 113 bits: what they
/// leave is never more than they say. The kernels' templates, for plain numbers.
#define COGNATE_ISA taylor_model_test

#include "synthesis/lanes/taylor_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "synthesis/lanes/coupler_models.hpp"
#include "synthesis/lanes/least_over_lanes.hpp"
#include "tests/support/planted_proofs.hpp"

namespace cognate::synthesis::taylor_model_test {
namespace {

using Long = long double;
using Place = std::array<double, kBoxSides>;

class Random {
 public:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(source_);
  }
  Place place() {
    Place t;
    for (double& x : t) x = uniform(0, 1) < 0.3 ? (uniform(0, 1) < 0.5 ? -1 : 1) : uniform(-1, 1);
    return t;
  }
  /// Of a constant near 1, the rest of it of some size.
  template <unsigned kSides>
  Model<kSides> model() {
    Model<kSides> a;
    const double size = std::pow(10.0, uniform(-4, -1.2));
    a.at[0] = uniform(0.5, 2);
    for (int i = 1; i < Model<kSides>::Of::kCount; ++i) a.at[i] = size * uniform(-1, 1);
    a.rest = uniform(0, 1) < 0.3 ? 0 : std::pow(10.0, uniform(-12, -2));
    a.measure();
    return a;
  }
  std::mt19937_64& source() { return source_; }

 private:
  std::mt19937_64 source_{1};
};

template <unsigned kSides>
Long value(const Model<kSides>& model, const Place& t) {
  Long sum = 0;
  for (int i = 0; i < Model<kSides>::Of::kCount; ++i) {
    Long term = model.at[i];
    for (int side = 0; side < kBoxSides; ++side) {
      for (int power = Model<kSides>::Of::kPowers[i] >> (2 * side) & 3; power > 0; --power) {
        term *= t[side];
      }
    }
    sum += term;
  }
  return sum;
}

template <unsigned kA, unsigned kB>
void check_operations(Random& random) {
  double closest = 0;
  for (int i = 0; i < 500; ++i) {
    const auto a = random.model<kA>();
    const auto b = random.model<kB>();
    const Place t = random.place();
    // Functions that the models hold.
    const Long f = value(a, t) + a.rest * Long(random.uniform(-1, 1));
    const Long g = value(b, t) + b.rest * Long(random.uniform(-1, 1));
    const auto holds = [&](const auto& model, Long exact) {
      const double off = double(std::abs(value(model, t) - exact));
      EXPECT_LE(off, model.rest) << i;
      closest = std::max(closest, off / model.rest);
    };
    Mask valid = true;
    holds(a * b, f * g);
    holds(plus(a, -0.7, b), f - Long(0.7) * g);
    holds(scaled(-1.3, a, 0.4), Long(0.4) - Long(1.3) * f);
    const auto inverse = reciprocal(a, valid);
    const auto square = square_root(a, valid);
    const auto log = logarithm(a, valid);
    if (!valid) continue;
    holds(inverse, 1 / f);
    holds(square, std::sqrt(f));
    holds(log, std::log(f) - std::log(Long(a.at[0])));
  }
  EXPECT_GT(closest, 0.1);  // remainders are not much too large
}

TEST(TaylorModel, HoldsTheResultsOfItsOperations) {
  Random random;
  check_operations<kFrameSide, kPhaseSide>(random);
  check_operations<kFrameSide | kFirstSide, kFrameSide | kPhaseSide>(random);
  check_operations<kFrameSide | kSecondSide | kPhaseSide, kFrameSide | kSecondSide>(random);
  check_operations<kAllSides, kAllSides>(random);
}

TEST(TaylorModel, HoldsCosines) {
  Random random;
  for (int i = 0; i < 2000; ++i) {
    const double middle = random.uniform(-4, 4), half = std::pow(10.0, random.uniform(-6, 0.5));
    const auto model = cosine_of_side<kPhaseSide>(std::cos(middle), std::sin(middle), half);
    const Place t = random.place();
    const Long exact = std::cos(Long(middle) + Long(half) * t[3]);
    EXPECT_LE(double(std::abs(value(model, t) - exact)), model.rest) << i;
  }
}

TEST(TaylorModel, IsNotValidWhereItReachesZero) {
  Random random;
  auto a = random.model<kFrameSide>();
  a.at[1] = a.at[0];
  a.measure();
  Mask valid = true;
  logarithm(a, valid);
  EXPECT_FALSE(valid);
}

HalfAngles half_angles(const Interval& side) {
  const double middle = 0.5 * side.middle();
  const double half = side.low == side.high ? 0 : side.radius();
  return {half, std::sin(middle), std::cos(middle), std::sin(0.5 * half), std::cos(0.5 * half)};
}

LanesBox lanes_box(const ProportionBox& box) {
  LanesBox lanes;
  lanes.k = box.side[0].middle();
  lanes.half_k = box.side[0].low == box.side[0].high ? 0 : box.side[0].radius();
  lanes.side = box.proportions == Proportions::frame_shortest ? -1 : 1;
  lanes.assembly = box.assembly;
  lanes.first = half_angles(box.side[1]);
  lanes.second = half_angles(box.side[2]);
  lanes.phase = half_angles(box.side[3]);
  return lanes;
}

struct TurnTally {
  int checked = 0, tight = 0, ranged = 0;
  double closest = 0;
};

/// The angles between the couplers of samples at a point of the box: exact less modelled.
void check_turns(const test::PlantedProof& planted, const ProportionBox& box, const Place& t,
                 TurnTally& tally) {
  test::BoxPoint at;
  for (int i = 0; i < kBoxSides; ++i) {
    const Interval& side = box.side[i];
    at[i] = std::clamp(side.middle() + t[i] * side.radius(), side.low, side.high);
  }
  const auto links = test::links_at(box, at);
  if (!links) return;
  Place exact_t{};
  for (int i = 0; i < kBoxSides; ++i) {
    const double half = box.side[i].radius();
    if (half > 1e-300) exact_t[i] = (at[i] - box.side[i].middle()) / half;
  }
  const CouplerModels models(lanes_box(box), std::cos(box.side[3].middle()));
  std::vector<test::Complex> off;
  std::vector<double> rest;
  for (const double angle : planted.path.crank_angles) {
    const CouplerTurn turn = models.at(std::sin(0.5 * angle), std::cos(0.5 * angle));
    if (!turn.counted) continue;
    const auto exact =
        test::directions_at(*links, box.assembly, test::Quad(angle) + test::Quad(at[3]));
    if (!exact) continue;
    const auto modelled =
        test::Complex(turn.x, turn.y) * std::polar(1.0, double(value(turn.turn, exact_t)));
    off.push_back(exact->coupler / modelled);
    rest.push_back(turn.turn.rest);
    tally.ranged += turn.doubt[0] + turn.doubt[1] + turn.doubt[2] + turn.doubt[3] > 0;
  }
  for (std::size_t j = 1; j < off.size(); ++j) {
    const double angle = std::abs(std::arg(off[j] / off[j - 1])), most = rest[j] + rest[j - 1];
    ASSERT_LE(angle, most + 1e-14);
    ++tally.checked;
    tally.tight += most < 1e-3;
    if (most > 1e-10) tally.closest = std::max(tally.closest, angle / most);
  }
}

TEST(CouplerModels, HoldTheAnglesBetweenTheSamples) {
  Random random;
  TurnTally tally;
  for (int i = 0; i < 600; ++i) {
    const auto planted = test::planted_proof(random.source());
    if (!planted) continue;
    for (int n = 0; n < 3; ++n) {
      const ProportionBox box =
          test::box_with(planted->at, planted->assembly, planted->proportions, random.source());
      check_turns(*planted, box, random.place(), tally);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(tally.checked, 8000);
  EXPECT_GT(tally.tight, tally.checked / 3);
  EXPECT_GT(tally.ranged, 100);
  EXPECT_GT(tally.closest, 0.2);
  EXPECT_LE(tally.closest, 1);
}

double value(const LanesQuadratic& q, const Place& t) {
  double sum = q.constant;
  for (int a = 0; a < 4; ++a) {
    sum += 2 * q.slope[a] * t[a];
    for (int b = 0; b < 4; ++b) sum += q.form(a, b) * t[a] * t[b];
  }
  return sum;
}

/// A quadratic whose form is far from singular where `convex`, else any.
LanesQuadratic random_quadratic(Random& random, bool convex) {
  LanesQuadratic q{};
  q.constant = random.uniform(-1, 1);
  for (int a = 0; a < 4; ++a) {
    q.slope[a] = random.uniform(-3, 3);
    for (int b = 0; b <= a; ++b) q.a[a][b] = random.uniform(-1, 1);
    if (convex) q.a[a][a] += 4;
  }
  return q;
}

TEST(LeastOverLanes, IsNoMoreThanAnyValue) {
  Random random;
  for (int i = 0; i < 3000; ++i) {
    const LanesQuadratic q = random_quadratic(random, i % 2 == 0);
    const double least = least_over_box(q, 1e9, 400).bound;
    for (int n = 0; n < 100; ++n) EXPECT_LE(least, value(q, random.place()) + 1e-12) << i;
  }
}

TEST(LeastOverLanes, IsTheLeastValueOfConvexForms) {
  Random random;
  for (int i = 0; i < 300; ++i) {
    const LanesQuadratic q = random_quadratic(random, true);
    Place t{};
    double value_there = value(q, t);
    for (double step = 0.5; step > 1e-12; step *= 0.7) {  // by trial, side for side
      for (int n = 0; n < 8; ++n) {
        for (double& x : t) {
          const double before = x;
          for (const double to : {before - step, before + step}) {
            const double kept = x;
            x = std::clamp(to, -1.0, 1.0);
            if (value(q, t) >= value_there) x = kept;
            value_there = std::min(value_there, value(q, t));
          }
        }
      }
    }
    EXPECT_NEAR(least_over_box(q, value_there - 1e-9, 400).bound, value_there, 2e-9) << i;
  }
}

}  // namespace
}  // namespace cognate::synthesis::taylor_model_test

#undef COGNATE_ISA
