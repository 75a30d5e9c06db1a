#include "synthesis/exact/cam/smallest_cam.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "synthesis/exact/cam/half_planes.hpp"

namespace cognate::synthesis {
namespace {

using cam::FollowerMotion;
using cam::MotionPart;

/// One side of one limit: across ≤ tan[α] along for `sign` +1, −across ≤ tan[α] along for −1.
struct LimitSide {
  PressureLimit limit;
  MotionPart stretch;
  double sign;
  double tangent;
};

std::vector<LimitSide> sides_of(const PressureLimits& limits) {
  std::vector<LimitSide> sides;
  const auto add = [&](PressureLimit limit, MotionPart stretch, const std::optional<double>& most,
                       std::initializer_list<double> signs) {
    if (!most) return;
    for (const double sign : signs) sides.push_back({limit, stretch, sign, std::tan(*most)});
  };
  add(PressureLimit::whole, MotionPart::whole, limits.whole, {1, -1});
  add(PressureLimit::rise, MotionPart::rises, limits.rise, {1, -1});
  add(PressureLimit::fall, MotionPart::falls, limits.fall, {1, -1});
  add(PressureLimit::rise_working, MotionPart::rises, limits.rise_working, {1});
  add(PressureLimit::fall_working, MotionPart::falls, limits.fall_working, {-1});
  return sides;
}

HalfPlane translating_plane(const LimitSide& side, const FollowerMotion<double>& m) {
  return {{side.sign, side.tangent}, side.sign * m.velocity - side.tangent * m.displacement};
}

HalfPlane oscillating_plane(const LimitSide& side, const FollowerMotion<double>& m, double sigma,
                            double arm) {
  const double c = std::cos(m.displacement), s = std::sin(m.displacement);
  const double k = side.sign * sigma;
  return {{side.tangent * s + k * c, side.tangent * c - k * s},
          side.sign * arm * (m.velocity + sigma)};
}

/// Half planes that were found to bind, and where they come from; the first ones, of other limits,
/// come from nowhere.
struct Exchange {
  std::vector<HalfPlane> planes;
  std::vector<std::optional<BindingLimit>> origins;

  void add(const HalfPlane& plane, std::optional<BindingLimit> origin = {}) {
    planes.push_back(plane);
    origins.push_back(origin);
  }
  /// Whether `plane` is among them: then only rounding can break it, or a limit equal to another.
  bool has(const HalfPlane& plane) const {
    return std::ranges::any_of(planes, [&](const HalfPlane& known) {
      return known.normal == plane.normal && known.bound == plane.bound;
    });
  }
};

struct Found {
  Vec2d at;
  double distance = 0;
  std::vector<BindingLimit> binding;
  int rounds = 0;
  bool other_binds = false;  ///< a half plane of no position
};

/// The point nearest to `centre` that keeps every limit at every position. `plane_of(side, motion)`
/// is the half plane of one side of a limit.
template <class PlaneOf>
std::optional<Found> exchange(const cam::MotionProgramme& programme,
                              const std::vector<LimitSide>& sides, const Vec2d& centre,
                              Exchange working, PlaneOf plane_of) {
  constexpr int kMostRounds = 100;
  constexpr double kRounding = 4e-16, kStalled = 1e-13;
  double last = -1;
  for (int round = 1; round <= kMostRounds; ++round) {
    const auto nearest = nearest_point(centre, working.planes);
    if (!nearest || !std::isfinite(nearest->distance)) return std::nullopt;
    const double size = nearest->distance + norm(centre);
    double worst = 0;
    bool added = false;
    for (const LimitSide& side : sides) {
      const auto missing = [&](const FollowerMotion<double>& m) {
        const HalfPlane plane = plane_of(side, m);
        return (plane.bound - dot(plane.normal, nearest->at)) / norm(plane.normal);
      };
      const auto extremes = turn_extremes(programme, side.stretch, missing);
      if (!extremes || !(extremes->greatest.value > kRounding * size)) continue;
      worst = std::max(worst, extremes->greatest.value);
      const auto& place = extremes->greatest.place;
      const HalfPlane plane = plane_of(side, motion_at(programme, place));
      if (working.has(plane)) continue;
      working.add(plane, BindingLimit{place.angle, side.limit});
      added = true;
    }
    // What is still missing may be rounding of places that are known already.
    const bool rounding = worst <= kStalled * size;
    const bool stalled = rounding && nearest->distance - last <= kRounding * size;
    last = nearest->distance;
    if (added && !stalled) continue;
    if (!rounding) return std::nullopt;
    Found found{nearest->at, nearest->distance, {}, round};
    for (const std::size_t i : nearest->binding) {
      if (working.origins[i]) {
        found.binding.push_back(*working.origins[i]);
      } else {
        found.other_binds = true;
      }
    }
    return found;
  }
  return std::nullopt;
}

}  // namespace

std::optional<SmallestCam> smallest_translating(const cam::MotionProgramme& programme,
                                                const PressureLimits& limits, double offset_least,
                                                double offset_greatest) {
  const auto sides = sides_of(limits);
  Exchange working;
  working.add({{0, 1}, 0});
  if (std::isfinite(offset_least)) working.add({{1, 0}, offset_least});
  if (std::isfinite(offset_greatest)) working.add({{-1, 0}, -offset_greatest});
  const auto found = exchange(programme, sides, {0, 0}, working,
                              [](const LimitSide& side, const FollowerMotion<double>& m) {
                                return translating_plane(side, m);
                              });
  if (!found) return std::nullopt;
  SmallestCam smallest;
  smallest.dimensions.offset = found->at.x;
  smallest.dimensions.base_radius = found->distance;
  smallest.binding = found->binding;
  smallest.bound_binds = found->other_binds;
  smallest.rounds = found->rounds;
  return smallest;
}

std::optional<SmallestCam> smallest_oscillating(const cam::MotionProgramme& programme,
                                                const PressureLimits& limits, cam::ArmSide side,
                                                double arm) {
  const double sigma = sign_of(side);
  Exchange working;
  for (const double swing : {programme.lowest(), programme.highest()}) {
    working.add({{std::sin(swing), std::cos(swing)}, 0});  // the arm stays on its own side
  }
  const auto found = exchange(programme, sides_of(limits), {arm, 0}, working,
                              [&](const LimitSide& limit, const FollowerMotion<double>& m) {
                                return oscillating_plane(limit, m, sigma, arm);
                              });
  if (!found) return std::nullopt;
  SmallestCam smallest;
  smallest.dimensions.arm = arm;
  smallest.dimensions.centre_distance = norm(found->at);
  smallest.dimensions.base_radius = found->distance;
  smallest.binding = found->binding;
  smallest.bound_binds = found->other_binds;
  smallest.rounds = found->rounds;
  return smallest;
}

}  // namespace cognate::synthesis
