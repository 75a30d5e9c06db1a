#include "problems/path/curve/curve_branch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

/// Samples of a whole turn before steps are halved, how often they are, and of what share of the
/// curve's length no chord is to be longer.
constexpr int kSamples = 96, kHalvings = 3;
constexpr double kLongestChord = 1.0 / 64;
/// The longest step of a descent along the motion, and one so short that the next would be
/// rounding.
constexpr double kLongestStep = 0.1, kLastStep = 1e-7;
constexpr int kMostSteps = 60;

}  // namespace

CurveBranch::CurveBranch(const FourBar& linkage)
    : pivot_(linkage.pivot_a),
      coupler_point_(linkage.coupler_point.value_or(Vec2d{})),
      links_(lengths(linkage)),
      near_(links_, +1),
      far_(links_, -1),
      assembly_(sign(linkage.assembly)) {
  axes_ = (1 / links_.frame) * (linkage.pivot_d - linkage.pivot_a);
}

/// The half angle rounded once is exact enough here: places are found by it, residuals are not.
CurveBranch::Position CurveBranch::position(double crank_angle) const {
  const Vec2d half{std::cos(0.5 * crank_angle), std::sin(0.5 * crank_angle)};
  const double sine = 2 * half.x * half.y, xx = 2 * half.x * half.x, yy = 2 * half.y * half.y;
  if (yy <= xx) return {{1 - yy, sine}, near_.at(sine, yy, assembly_)};
  return {{xx - 1, sine}, far_.at(sine, xx, assembly_)};
}

std::optional<Vec2d> CurveBranch::point(double crank_angle) const {
  const auto [crank, links] = position(crank_angle);
  if (!(links.discriminant > 0)) return std::nullopt;
  return links_.crank * crank + links.coupler * coupler_point_;
}

double CurveBranch::distance(double crank_angle, const Vec2d& target) const {
  const auto at = point(crank_angle);
  return at ? norm(*at - target) : std::numeric_limits<double>::infinity();
}

/// With e₁, e₂, e₃ along crank, coupler and rocker the closure l₁e₁ + l₂e₂ = l₄ + l₃e₃, derived
/// once and twice, gives the rates of the coupler's and the rocker's angles.
CurveBranch::Jet CurveBranch::jet(const Travel& travel, double at) const {
  const auto [e1, links] = position(travel.angle(at));
  if (!(links.discriminant > 0)) return {};
  const Vec2d &e2 = links.coupler, &e3 = links.rocker;
  const double sine = cross(e2, e3);
  const double coupler_rate = links_.crank * cross(e3, e1) / (links_.coupler * sine);
  const double rocker_rate = links_.crank * cross(e2, e1) / (links_.rocker * sine);
  const double coupler_second =
      (links_.crank * dot(e1, e3) + links_.coupler * coupler_rate * coupler_rate * dot(e2, e3) -
       links_.rocker * rocker_rate * rocker_rate) /
      (links_.coupler * sine);
  const Vec2d swing = e2 * coupler_point_;
  const Vec2d first = links_.crank * perp(e1) + coupler_rate * perp(swing);
  const Vec2d second =
      -links_.crank * e1 + coupler_second * perp(swing) - coupler_rate * coupler_rate * swing;
  const double slope = travel.slope(at);
  return {links_.crank * e1 + swing, slope * first,
          (slope * slope) * second + travel.second(at) * first, true};
}

void CurveBranch::sample(const Travel& travel, double from, double to,
                         std::vector<CurveSample>& all, std::vector<CurveSample>& spare) const {
  const int steps = std::max(12, static_cast<int>(std::ceil(kSamples * (to - from) / kTurn)));
  all.clear();
  const auto add = [&](double at, std::vector<CurveSample>& list) {
    const auto there = point(travel.angle(at));
    if (there) list.push_back({at, *there});
  };
  for (int k = 0; k < steps; ++k) add(from + (to - from) * k / steps, all);
  add(to, all);
  for (int halving = 0; halving < kHalvings; ++halving) {
    double length = 0;
    for (std::size_t k = 0; k + 1 < all.size(); ++k) {
      length += std::sqrt(squared_norm(all[k + 1].point - all[k].point));
    }
    const double longest = kLongestChord * length;
    spare.clear();
    for (std::size_t k = 0; k < all.size(); ++k) {
      spare.push_back(all[k]);
      if (k + 1 == all.size()) break;
      if (squared_norm(all[k + 1].point - all[k].point) <= longest * longest) continue;
      add(all[k].at + 0.5 * (all[k + 1].at - all[k].at), spare);
    }
    if (spare.size() == all.size()) break;
    std::swap(all, spare);
  }
}

double CurveBranch::nearest(const Travel& travel, const Vec2d& target, double start, double from,
                            double to) const {
  double at = std::clamp(start, from, to);
  Jet here = jet(travel, at);
  if (!here.closes) return at;
  for (int k = 0; k < kMostSteps; ++k) {
    const Vec2d away = here.value - target;
    const double slope = dot(away, here.first), square = squared_norm(here.first);
    const double curvature = square + dot(away, here.second);
    // Where it bends the other way, or hardly, along the tangent of the curve.
    double step = -slope / (curvature > 1e-3 * square ? curvature : square);
    if (!std::isfinite(step)) return at;
    const bool last = std::abs(step) < kLastStep;
    step = std::clamp(step, -kLongestStep, kLongestStep);
    const double distance = squared_norm(away);
    for (;; step *= 0.25) {
      const double next = std::clamp(at + step, from, to);
      if (next == at) return at;
      const Jet there = jet(travel, next);
      if (there.closes && (last || squared_norm(there.value - target) < distance)) {
        at = next;
        here = there;
        break;
      }
      if (std::abs(step) < kLastStep) return at;
    }
    if (last) return at;
  }
  return at;
}

}  // namespace cognate::problems
