#include "analysis/linkage/cognates.hpp"

#include <cmath>
#include <limits>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/angle.hpp"

namespace cognate {
namespace {

/// Whether a ratio is lost in the rounding of the coupler point, so that it has no direction.
bool vanishes(const Vec2d& ratio) {
  return norm(ratio) <= 16 * std::numeric_limits<double>::epsilon();
}

/// (P − B)/(C − B).
Vec2d coupler_ratio(const FourBar& linkage) {
  return (1 / linkage.coupler) * *linkage.coupler_point;
}

Vec2d third_pivot(const FourBar& linkage) {
  return linkage.pivot_a + coupler_ratio(linkage) * (linkage.pivot_d - linkage.pivot_a);
}

Assembly assembly_of(double signed_area) {
  return signed_area > 0 ? Assembly::open : Assembly::crossed;
}

}  // namespace

std::optional<FourBar> timed_cognate(const FourBar& linkage) {
  if (!linkage.coupler_point) return std::nullopt;
  const Vec2d z = coupler_ratio(linkage);
  const Vec2d rest{(linkage.coupler - linkage.coupler_point->x) / linkage.coupler, -z.y};
  if (vanishes(rest)) return std::nullopt;
  const double size = norm(rest);
  FourBar cognate = linkage;
  cognate.pivot_a = third_pivot(linkage);
  cognate.crank = size * linkage.crank;
  cognate.coupler = size * linkage.rocker;
  cognate.rocker = size * linkage.coupler;
  cognate.assembly = assembly_of(-sign(linkage.assembly));
  // P − B' = z (C − D) and C' − B' = −(1 − z)(C − D).
  cognate.coupler_point = (-linkage.rocker / size) * (z * conj(rest));
  return cognate;
}

std::optional<CognateAt> coupler_cognate(const FourBar& linkage, double crank_angle) {
  if (!linkage.coupler_point || vanishes(coupler_ratio(linkage))) return std::nullopt;
  const auto pose = Motion(linkage).at(crank_angle);
  if (!pose) return std::nullopt;
  const Vec2d z = coupler_ratio(linkage);
  const double size = norm(z);
  FourBar cognate = linkage;
  cognate.pivot_d = third_pivot(linkage);
  cognate.crank = size * linkage.coupler;
  cognate.coupler = size * linkage.crank;
  cognate.rocker = size * linkage.rocker;
  cognate.assembly = assembly_of(cross(pose->b - linkage.pivot_a, pose->c - linkage.pivot_d));
  // P − B' = B − A and C' − B' = z (B − A).
  cognate.coupler_point = (linkage.crank / size) * conj(z);
  return CognateAt{cognate, angle_of(z * (pose->c - pose->b))};
}

std::optional<CognateAt> from_other_end(const FourBar& linkage, double crank_angle) {
  const auto pose = Motion(linkage).at(crank_angle);
  if (!pose) return std::nullopt;
  FourBar other = linkage;
  other.pivot_a = linkage.pivot_d;
  other.pivot_d = linkage.pivot_a;
  other.crank = linkage.rocker;
  other.rocker = linkage.crank;
  other.assembly = assembly_of(cross(linkage.pivot_a - pose->c, pose->b - pose->c));
  if (const auto& point = linkage.coupler_point) {
    other.coupler_point = Vec2d{linkage.coupler - point->x, -point->y};
  }
  return CognateAt{other, pose->rocker_angle};
}

}  // namespace cognate
