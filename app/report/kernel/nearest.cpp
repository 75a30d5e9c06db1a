#include "app/report/kernel/nearest.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"

namespace cognate::page {
namespace {

constexpr int kGoldenSteps = 50;  // from a quarter turn to 1e-10

}  // namespace

double miss(const Motion& motion, const Target& target, double crank) {
  const auto pose = motion.at(crank);
  if (!pose || !pose->coupler_point) return kInfinity;
  const double place = squared_norm(*pose->coupler_point - target.at);
  if (target.weight == 0) return place;
  const Vec2d along = pose->c - pose->b;
  const double turn = std::remainder(std::atan2(along.y, along.x) - target.angle, kTurn);
  return place + target.weight * target.weight * turn * turn;
}

double nearest_from(const Motion& motion, const Target& target, double start) {
  constexpr double kFirstStep = 1e-4, kGrowth = 2, kMost = kRightAngle;
  const auto f = [&](double crank) { return miss(motion, target, crank); };
  const double here = f(start);
  if (!std::isfinite(here)) return start;
  const double sense = f(start + kFirstStep) < f(start - kFirstStep) ? 1 : -1;
  double behind = start - sense * kFirstStep, at = start, value = here;
  for (double step = kFirstStep; step < kMost; step *= kGrowth) {
    const double next = at + sense * step;
    const double beyond = f(next);
    if (!(beyond < value)) {
      const double found =
          golden_section(f, std::min(behind, next), std::max(behind, next), kGoldenSteps).middle();
      return f(found) <= here ? found : start;
    }
    behind = at;
    at = next;
    value = beyond;
  }
  return at;
}

std::optional<double> nearest(const FourBar& linkage, const Motion& motion, const Target& target) {
  constexpr int kPlaces = 360;
  constexpr double kHair = 1e-9;  // within a range, at whose ends rounding decides what closes
  const double frame = frame_angle(linkage);
  double best = 0, value = kInfinity;
  for (const CrankRange& range : crank_ranges(lengths(linkage))) {
    const double half = 0.5 * (range.to - range.from) - kHair;
    for (int i = 0; i <= kPlaces; ++i) {
      // Closer together at the ends, where the linkage moves as the square root of the crank.
      const double share = std::cos(kPi * i / kPlaces);
      const double crank = frame + 0.5 * (range.from + range.to) - half * share;
      const double here = miss(motion, target, crank);
      if (here < value) {
        best = crank;
        value = here;
      }
    }
  }
  if (!std::isfinite(value)) return std::nullopt;
  return nearest_from(motion, target, best);
}

}  // namespace cognate::page
