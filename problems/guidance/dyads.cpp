#include "problems/guidance/dyads.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/guidance/dyad_choices.hpp"
#include "synthesis/fit/body_motion.hpp"
#include "synthesis/fit/circle.hpp"
#include "synthesis/fit/dyad_fit.hpp"

namespace cognate::problems {
namespace {

using synthesis::DyadKind;
using synthesis::GuidingDyad;
using synthesis::Pose;

/// Links whose pivots differ by less than this share of the motion's size are one.
constexpr double kSame = 1e-4;

std::size_t number(DyadRole role) {
  return role == DyadRole::first ? 0 : 1;
}

Vec2d confined(const Vec2d& p, const std::optional<Box>& box) {
  if (!box) return p;
  return {std::max(box->min.x, std::min(p.x, box->max.x)),
          std::max(box->min.y, std::min(p.y, box->max.y))};
}

/// The index-th point of the van der Corput sequence of a base.
double van_der_corput(int index, int base) {
  double value = 0, share = 1;
  for (; index > 0; index /= base) {
    share /= base;
    value += share * (index % base);
  }
  return value;
}

/// A point of the plane for a point of the unit square: half of them within `unit` of `centre`, one
/// in a hundred beyond ten units.
Vec2d spread(const Vec2d& centre, double unit, double u, double v) {
  const double radius = unit * std::sqrt(u / (1.001 - u));
  return centre + radius * Vec2d{std::cos(kTurn * v), std::sin(kTurn * v)};
}

/// The link of a moving pivot and the circle nearest to its places; a long one for a straight way.
GuidingDyad link_of_moving(std::span<const Pose> poses, const Vec2d& moving) {
  constexpr double kLong = 100;
  const auto places = synthesis::places_of(poses, moving);
  const auto circle = synthesis::algebraic_circle(places);
  if (circle) return synthesis::rr_dyad(poses, moving, circle->centre);
  const Vec2d chord = places.back() - places.front();
  const double length = norm(chord);
  const Vec2d across = length > 0 ? (1 / length) * perp(chord) : Vec2d{0, 1};
  return synthesis::rr_dyad(poses, moving, places.front() + kLong * across);
}

GuidingDyad link_of_fixed(std::span<const Pose> poses, const Vec2d& fixed) {
  const auto inverse = synthesis::inverse_motion(poses);
  return synthesis::rr_dyad(poses, link_of_moving(inverse, fixed).fixed, fixed);
}

bool is_like(const GuidingDyad& a, const GuidingDyad& b) {
  const double size = 1 + std::max(a.length, b.length);
  return norm(a.in_body - b.in_body) + norm(a.fixed - b.fixed) <= kSame * size;
}

}  // namespace

bool roles_are_alike(const MotionProblem& problem) {
  const Bounds& bounds = problem.bounds;
  const auto alike = [](const auto& a, const auto& b) { return !a && !b; };
  const bool same_lengths =
      alike(bounds.crank, bounds.rocker) ||
      (bounds.crank && bounds.rocker && bounds.crank->min == bounds.rocker->min &&
       bounds.crank->max == bounds.rocker->max);
  return problem.fixed_pivots.empty() && problem.moving_pivots.empty() && same_lengths &&
         !problem.crank && !problem.rocker && alike(bounds.pivot_a, bounds.pivot_d) &&
         alike(problem.moving_bounds[0], problem.moving_bounds[1]);
}

DyadCandidate conformed(const MotionProblem& problem, DyadRole role, const GuidingDyad& dyad) {
  const bool first = role == DyadRole::first;
  const auto& bounds = problem.bounds;
  const auto moving = given_pivot(problem, problem.moving_pivots, role);
  const auto fixed = given_pivot(problem, problem.fixed_pivots, role);
  const Vec2d in_body =
      moving ? *moving : confined(dyad.in_body, problem.moving_bounds[number(role)]);
  const Vec2d in_frame =
      fixed ? *fixed
            : confined(confined(dyad.fixed, first ? bounds.pivot_a : bounds.pivot_d),
                       problem.constraints.pivot_region);
  DyadCandidate candidate{synthesis::rr_dyad(problem.poses, in_body, in_frame), 0};
  const auto& length = first ? problem.crank : problem.rocker;
  candidate.dyad.length = length.value_or(candidate.dyad.length);
  candidate.misfit = synthesis::squared_misfit(candidate.dyad, problem.poses);
  return candidate;
}

std::vector<DyadCandidate> drawn_links(const MotionProblem& scaled, DyadRole role, int count,
                                       std::uint64_t seed) {
  std::span<const Pose> poses = scaled.poses;
  const auto rest = synthesis::resting_point(poses);
  const double travel = rest.travel > 0 ? rest.travel : 1;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const double shift_u = uniform(random), shift_v = uniform(random);
  const auto moving = given_pivot(scaled, scaled.moving_pivots, role);
  const auto fixed = given_pivot(scaled, scaled.fixed_pivots, role);
  std::vector<DyadCandidate> drawn;
  for (int k = 0; k < count; ++k) {
    const double u = std::fmod(van_der_corput(k, 2) + shift_u, 1.0);
    const double v = std::fmod(van_der_corput(k, 3) + shift_v, 1.0);
    const bool by_rest = k % 2 == 0;  // else about the body's origin, whose way is one unit
    GuidingDyad dyad;
    if (moving) {
      dyad = k == 0 ? link_of_moving(poses, *moving)
                    : synthesis::rr_dyad(poses, *moving, spread(rest.mean, travel, u, v));
    } else if (fixed && k == 0) {
      dyad = link_of_fixed(poses, *fixed);
    } else {
      const Vec2d centre = by_rest ? rest.in_body : Vec2d{};
      dyad = link_of_moving(poses, confined(spread(centre, by_rest ? travel : 1, u, v),
                                            scaled.moving_bounds[number(role)]));
    }
    drawn.push_back(conformed(scaled, role, dyad));
  }
  std::erase_if(drawn, [](const DyadCandidate& link) { return !std::isfinite(link.misfit); });
  return drawn;
}

std::vector<DyadCandidate> nearest_links(const MotionProblem& scaled, DyadRole role,
                                         const std::vector<DyadCandidate>& starts,
                                         const Deadline& deadline) {
  const bool is_free = !given_pivot(scaled, scaled.moving_pivots, role) &&
                       !given_pivot(scaled, scaled.fixed_pivots, role) &&
                       !(role == DyadRole::first ? scaled.crank : scaled.rocker);
  std::vector<DyadCandidate> found;
  for (const DyadCandidate& start : starts) {
    if (deadline.reached()) break;
    auto dyad = std::optional(start.dyad);
    if (is_free) {
      dyad = synthesis::nearest_link(start.dyad, scaled.poses,
                                     {.tolerance = 1e-8, .max_iterations = 40});
    }
    if (dyad) found.push_back(conformed(scaled, role, *dyad));
  }
  std::ranges::stable_sort(found, {}, &DyadCandidate::misfit);
  std::vector<DyadCandidate> distinct;
  for (const DyadCandidate& link : found) {
    const bool known = std::ranges::any_of(
        distinct, [&](const DyadCandidate& other) { return is_like(other.dyad, link.dyad); });
    if (!known) distinct.push_back(link);
  }
  return distinct;
}

std::vector<DyadCandidate> nearest_slides(const MotionProblem& scaled) {
  constexpr int kDirections = 4;
  std::vector<GuidingDyad> slides;
  std::span<const Pose> poses = scaled.poses;
  constexpr DyadRole kSecond = DyadRole::second;
  const bool sliders =
      allows(scaled, DyadKind::pr) && !given_pivot(scaled, scaled.fixed_pivots, kSecond);
  const bool blocks =
      allows(scaled, DyadKind::rp) && !given_pivot(scaled, scaled.moving_pivots, kSecond);
  if (scaled.rocker) return {};
  if (sliders) slides.push_back(synthesis::nearest_slider(poses));
  if (blocks) slides.push_back(synthesis::nearest_block(poses));
  for (int k = 0; k < kDirections; ++k) {
    const double angle = kPi * k / kDirections;
    const Vec2d direction = unit_vector(angle);
    if (sliders) slides.push_back(synthesis::slider_along(poses, direction));
    if (blocks) slides.push_back(synthesis::block_along(poses, direction));
  }
  std::vector<DyadCandidate> candidates;
  for (const GuidingDyad& dyad : slides) {
    const double misfit = synthesis::squared_misfit(dyad, poses);
    if (std::isfinite(misfit)) candidates.push_back({dyad, misfit});
  }
  std::ranges::stable_sort(candidates, {}, &DyadCandidate::misfit);
  return candidates;
}

}  // namespace cognate::problems
