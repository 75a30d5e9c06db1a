/// Poses in order on one circuit, against angles and arcs found by walking round the turn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

#include "analysis/numbers/constants.hpp"
#include "problems/guidance/closure.hpp"
#include "problems/guidance/order.hpp"

namespace cognate::problems::guidance_order_test {
namespace {

using synthesis::DyadKind;
using synthesis::GuidingDyad;
using synthesis::Pose;

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

DyadPair random_pair(std::mt19937_64& random, DyadKind kind) {
  const auto point = [&] { return Vec2d{uniform(random, -1, 1), uniform(random, -1, 1)}; };
  const double direction = uniform(random, 0, kTurn);
  const Vec2d line{std::cos(direction), std::sin(direction)};
  return {{DyadKind::rr, point(), {}, point(), {1, 0}, uniform(random, 0.3, 1.5)},
          {kind, point(), {}, point(), line, uniform(random, 0.3, 2)}};
}

/// Whether a second dyad closes, by walking the body round the crank pin and watching the sign of
/// its condition.
bool closes(const DyadPair& pair, double crank_angle) {
  using Complex = std::complex<double>;
  const auto complex = [](const Vec2d& v) { return Complex(v.x, v.y); };
  const Complex pin = complex(pair.first.fixed) + pair.first.length * std::polar(1.0, crank_angle);
  const Complex along = complex(pair.second.direction);
  bool above = false, below = false;
  for (int k = 0; k < 720; ++k) {
    const Complex turn = std::polar(1.0, kTurn * k / 720);
    const Complex moving = pin + turn * complex(pair.second.in_body - pair.first.in_body);
    double condition = 0;
    if (pair.second.kind == DyadKind::rr) {
      condition = std::abs(moving - complex(pair.second.fixed)) - pair.second.length;
    } else if (pair.second.kind == DyadKind::pr) {
      condition = std::imag(std::conj(along) * (moving - complex(pair.second.fixed)));
    } else {
      condition = std::imag(std::conj(turn * along) * (complex(pair.second.fixed) - moving));
    }
    (condition > 0 ? above : below) = true;
  }
  return above && below;
}

TEST(ClosingArcs, HoldWhereTheSecondDyadCloses) {
  std::mt19937_64 random(21);
  int inside = 0, outside = 0, near_an_end = 0;
  for (int n = 0; n < 600; ++n) {
    const DyadKind kind = std::array{DyadKind::rr, DyadKind::pr, DyadKind::rp}.at(n % 3);
    const DyadPair pair = random_pair(random, kind);
    const auto arcs = closing_arcs(kind, pair.first, second_dyad(pair.second));
    for (int k = 0; k < 40; ++k) {
      const double angle = kTurn * (k + 0.37) / 40;
      bool is_in = false, is_near = false;
      for (const CrankRange& arc : arcs) {
        const double along = angle - arc.from - kTurn * std::floor((angle - arc.from) / kTurn);
        is_in = is_in || along <= arc.to - arc.from;
        const bool whole = arc.to - arc.from >= kTurn;
        is_near = is_near || (!whole && (std::abs(along - (arc.to - arc.from)) < 0.02 ||
                                         along < 0.02 || along > kTurn - 0.02));
      }
      const bool closed = closes(pair, angle);
      if (is_near) {  // where walking in half degrees does not decide
        ++near_an_end;
        continue;
      }
      // A turn of half a degree may step over a condition that is barely met.
      if (is_in && !closed) continue;
      EXPECT_EQ(is_in, closed) << n << " at " << angle;
      (is_in ? inside : outside) += 1;
    }
  }
  EXPECT_GT(inside, 8000);
  EXPECT_GT(outside, 2000);
  EXPECT_LT(near_an_end, 2000);
}

/// A linkage whose crank turns fully, or does not, with poses disturbed by noise.
struct Disturbed {
  MotionProblem problem;
  DyadPair pair;
  double planted = 0;  ///< sum of squares at the angles of the poses, in order
};

std::optional<Disturbed> disturbed(std::mt19937_64& random, double noise) {
  Disturbed made{{}, random_pair(random, DyadKind::rr), 0};
  made.problem.method = MotionMethod::least_squares;
  made.problem.dyads = {DyadKind::rr};
  const auto arcs = closing_arcs(DyadKind::rr, made.pair.first, second_dyad(made.pair.second));
  if (arcs.empty()) return std::nullopt;
  const CrankRange& arc = arcs.front();
  const double side = random() % 2 == 0 ? 1 : -1, span = arc.to - arc.from;
  std::normal_distribution<double> normal(0, noise);
  for (int j = 0; j < 12; ++j) {
    const double angle = arc.from + span * (0.05 + 0.9 * (j + uniform(random, 0, 1)) / 12);
    const Vec2d pin =
        made.pair.first.fixed + made.pair.first.length * Vec2d{std::cos(angle), std::sin(angle)};
    const auto condition =
        turn_condition(DyadKind::rr, second_dyad(made.pair.second), made.pair.first.in_body, pin);
    if (!(condition.discriminant() > 0)) return std::nullopt;
    const Vec2d turn = condition.turn(side);
    Pose pose{pin - turn * made.pair.first.in_body, std::atan2(turn.y, turn.x)};
    const double dx = normal(random), dy = normal(random), da = normal(random);
    pose = {pose.at + Vec2d{dx, dy}, pose.angle + da};
    made.planted += dx * dx + dy * dy + da * da;
    made.problem.poses.push_back(pose);
  }
  return made;
}

/// Whether the angles go round once at most in one sense.
bool go_round_once(const std::vector<double>& angles) {
  const auto way = [&](double sense) {
    double sum = 0;
    for (std::size_t j = 1; j < angles.size(); ++j) {
      const double step = sense * (angles[j] - angles[j - 1]);
      const double forward = step - kTurn * std::floor(step / kTurn);
      if (forward < kTurn - 1e-9) sum += forward;
    }
    return sum;
  };
  return std::min(way(1), way(-1)) <= kTurn + 1e-9;
}

TEST(MotionOrder, PutsNoisyPosesInOrderNearThePlantedMotion) {
  std::mt19937_64 random(31);
  int exchanged = 0, kept = 0, pooled = 0;
  for (int n = 0; n < 1000; ++n) {
    const auto made = disturbed(random, 0.05);
    if (!made) continue;
    OrderedMotion motion{form_of(made->problem, made->pair), {}};
    motion.x = MotionModel(made->problem, motion.form).variables_of(made->pair);
    const auto ordered = in_order(made->problem, motion);
    if (!ordered) {
      ++kept;
      continue;
    }
    ++exchanged;
    const MotionModel model(made->problem, ordered->form);
    std::vector<double> angles, residuals(static_cast<std::size_t>(model.residual_count()));
    const auto stations = model.station_angles(ordered->x);
    for (std::size_t j = 0; j < made->problem.poses.size(); ++j) {
      angles.push_back(stations.at(model.station_of(j)));
    }
    EXPECT_TRUE(go_round_once(angles)) << n;
    ASSERT_TRUE(model.residuals(ordered->x, residuals, {}, {})) << n;
    double sum = 0;
    for (const double r : residuals) sum += r * r;
    EXPECT_LT(sum, 4 * made->planted + 0.05) << n;  // the angles are not refined
    pooled += stations.size() < angles.size();
  }
  EXPECT_GT(exchanged, 100);
  EXPECT_GT(pooled, 100);
  EXPECT_GT(kept, 20);
}

}  // namespace
}  // namespace cognate::problems::guidance_order_test
