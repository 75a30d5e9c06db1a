#include <algorithm>
#include <random>

#include "tests/stress/ranges/chain_curve.hpp"
#include "tests/stress/ranges/range_judge.hpp"
#include "tests/stress/ranges/range_stress.hpp"

namespace cognate::stress {
namespace {

/// Degrees, or parts of a length.
constexpr double kTolerance = 1e-5;

SixBar random_chain(std::mt19937_64& random) {
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution(a, b)(random);
  };
  const auto side = [&] { return random() % 2 == 0 ? 1 : -1; };
  SixBar c;
  c.crank = between(0.3, 1.5), c.coupler = between(0.5, 3), c.rocker = between(0.5, 3);
  c.d = {between(0.5, 3), between(-1, 1)};
  c.p = {between(-1, 2), between(-1, 1)};
  c.e = {between(-2, 4), between(-3, 3)};
  c.first = between(1, 4);
  c.slides = random() % 2 == 0;
  c.second = c.slides ? between(-180, 180) : between(1, 4);
  c.side = side(), c.dyad_side = side();
  c.start = random() % 2 == 0 ? 0 : between(-200, 200);
  c.end = c.start + (random() % 4 == 0 ? -1 : 1) * (random() % 3 == 0 ? between(30, 340) : 360);
  return c;
}

}  // namespace

RangeTally check_chains(std::uint64_t seed, int count) {
  RangeTally tally;
  std::mt19937_64 random(seed);
  while (tally.mechanisms < count) {
    const SixBar chain = random_chain(random);
    const auto truth = truth_of(chain);
    if (!truth) continue;
    ++tally.mechanisms;
    RangeJudge judge(file_of(chain), tally);
    if (!judge.is_read()) continue;
    const std::string what = chain.slides ? "stroke" : "swing_deg";
    const bool is_full = !chain.slides && truth->stroke > 360 - 1e-6;
    tally.turn += is_full;
    tally.come_round += !is_full && !chain.slides && truth->circuit == 360;
    tally.several_ranges += !truth->dead_points.empty();
    judge.number("output_" + what, is_full ? std::nullopt : std::optional(truth->stroke),
                 kTolerance);
    judge.number("circuit_" + what, is_full ? std::nullopt : truth->circuit, kTolerance);
    if (!truth->dead_points.empty()) {  // other ranges may hold the extremes
      judge.number_within("transmission_angle_deg.min", truth->least_transmission, kTolerance, -1);
      judge.number_within("transmission_angle_deg.max", truth->greatest_transmission, kTolerance,
                          1);
    } else {
      judge.number("transmission_angle_deg.min", truth->least_transmission, kTolerance);
      judge.number("transmission_angle_deg.max", truth->greatest_transmission, kTolerance);
    }
    judge.has_landmarks("dead point", truth->dead_points, 1e-6);
  }
  return tally;
}

}  // namespace cognate::stress
