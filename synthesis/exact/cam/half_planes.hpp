/// @file The point nearest to another in an intersection of half planes.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/numbers/vec2.hpp"

namespace cognate::synthesis {

/// The points X with normal · X ≥ bound.
struct HalfPlane {
  Vec2d normal;
  double bound = 0;
};

struct NearestPoint {
  Vec2d at;
  double distance = 0;
  std::vector<std::size_t> binding;  ///< the half planes, none, one or two, that alone force it
};

/// The point of the intersection that is nearest to `centre`; nothing where two of the half planes
/// have no point in common. (Three may be in conflict with each other and no two of them: the
/// caller finds that the point given satisfies all or does not.)
///
/// The problem is of the type of linear programmes with combinatorial dimension two (Sharir & Welzl
/// 1992): its value is the greatest that any two of the half planes have alone, so that no test of
/// feasibility, which rounding could upset, decides anything.
std::optional<NearestPoint> nearest_point(const Vec2d& centre, std::span<const HalfPlane> planes);

}  // namespace cognate::synthesis
