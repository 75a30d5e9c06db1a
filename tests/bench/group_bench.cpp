/// What a position of a link with three pins costs as a group, by Newton's method, beside the same
/// mechanism driven by another link, whose dyads have formulas; and what all its assemblies cost.
/// Ratios to the dyads, over random mechanisms, positions in no order.
#include <fmt/core.h>

#include <vector>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/three_pin_link.hpp"
#include "tests/bench/kernel/measure.hpp"
#include "tests/support/three_pin_links.hpp"

namespace cognate {
namespace {

using namespace test;

constexpr int kPositions = 64, kMechanisms = 16;

/// Drives all round a range in no order that could be learned by heart.
std::vector<double> drives(double from, double to) {
  std::vector<double> all;
  for (int i = 0; i < kPositions; ++i) {
    all.push_back(from + (to - from) * (0.5 + i * 39 % kPositions) / kPositions);
  }
  return all;
}

/// Both forms of one mechanism along the same motion's neighbourhood.
struct Both {
  FollowedMotion<2> group, dyads;
  std::vector<double> cranks, legs;
};

Both both(const Drawn& drawn) {
  const auto around = [](const Mechanism<double>& mechanism, double drive) {
    return FollowedMotion<2>(mechanism, follow(mechanism, drive - 0.3, drive + 0.3));
  };
  const double crank = drawn.angle(), leg = angle_of(drawn.pins[1] - drawn.pivots[0]);
  Both made{around(with_group(drawn), crank), around(with_dyads(drawn), leg), {}, {}};
  const auto range = [](const FollowedMotion<2>& motion, double drive) {
    const AssemblyRange& run = *motion.assembly_ranges().range_at(drive);
    return drives(run.from, run.to);
  };
  made.cranks = range(made.group, crank);
  made.legs = range(made.dyads, leg);
  return made;
}

ThreePinLink link_of(const Drawn& drawn) {
  const auto& [a, b, pins, pivots] = drawn;
  return {0,
          pins,
          {b, pivots[0], pivots[1]},
          {norm(pins[0] - b), norm(pins[1] - pivots[0]), norm(pins[2] - pivots[1])}};
}

void run() {
  Chance chance(1);
  std::vector<Both> mechanisms;
  std::vector<ThreePinLink> links;
  for (int i = 0; i < kMechanisms; ++i) {
    const Drawn drawn = chance.drawn();
    mechanisms.push_back(both(drawn));
    links.push_back(link_of(drawn));
  }
  double sum = 0;
  const auto moved = [&](FollowedMotion<2> Both::*motion, std::vector<double> Both::*places) {
    return [&sum, &mechanisms, motion, places] {
      for (Both& one : mechanisms) {
        for (const double drive : one.*places) {
          (one.*motion).move_to(drive);
          sum += (one.*motion).bodies().back().origin[2].x;
        }
      }
    };
  };
  constexpr double kAll = kPositions * kMechanisms;
  std::vector<bench::Case> cases{{"dyads, accelerations", kAll, moved(&Both::dyads, &Both::legs)},
                                 {"group, accelerations", kAll, moved(&Both::group, &Both::cranks)},
                                 {"all assemblies", kMechanisms, [&] {
                                    for (const ThreePinLink& link : links)
                                      sum += static_cast<double>(assemblies(link).size());
                                  }}};
  bench::measure(cases, 200);
  for (const bench::Case& one : cases) {
    fmt::print("{:22} {:8.1f} ns, {:5.1f} of the dyads\n", one.name, one.nanoseconds,
               one.nanoseconds / cases.front().nanoseconds);
  }
  fmt::print("(sum {:.3g})\n", sum);
}

}  // namespace
}  // namespace cognate

int main() {
  cognate::run();
}
