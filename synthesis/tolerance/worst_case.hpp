/// @file The exact worst case of a mechanism over the box of its tolerances.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/tolerance/affine_mechanism.hpp"
#include "analysis/tolerance/response.hpp"
#include "synthesis/bounds/interval.hpp"

namespace cognate::synthesis {

/// Between which deviations from its nominal value a response lies over the box.
struct WorstCase {
  double low = 0, high = 0;  ///< sound bounds, equal to values reached but for the gap
  bool complete = true;      ///< the gap was reached; else the bounds may be wide
  std::size_t boxes = 0;     ///< of the branch and bound
};

/// Of a scalar response at a station, over the changes of dimensions in `box`. Empty where the
/// mechanism reaches a dead point, or cannot be assembled, somewhere in the box.
std::optional<WorstCase> worst_case(const AffineMechanism& mechanism, const Response& response,
                                    const Station& station, std::span<const Interval> box);

/// The greatest distance of a point from `target` over the box, as `high`; `low` is 0.
std::optional<WorstCase> worst_distance(const AffineMechanism& mechanism, const Response& point,
                                        const Station& station, const Vec2d& target,
                                        std::span<const Interval> box);

/// The derivatives of a response by all dimensions over the box, enclosed; empty as above.
std::optional<std::vector<Vec2<Interval>>> enclosed_rates(const AffineMechanism& mechanism,
                                                          const Response& response,
                                                          const Station& station,
                                                          std::span<const Interval> box);

/// The greatest length of Σ tᵢ vᵢ with |tᵢ| ≤ 1: the farthest corner of a zonotope. `vectors` are
/// reordered.
double farthest_corner(std::vector<Vec2d> vectors);
/// That corner.
Vec2d farthest_corner_place(std::vector<Vec2d> vectors);

}  // namespace cognate::synthesis
