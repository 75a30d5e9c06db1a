/// @file A design in motion, as the report page draws it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

#include "problems/linkage/result.hpp"
#include "synthesis/exact/motion/pose.hpp"

namespace cognate::app {

/// How finely the designs of a page are sampled, so that many of them do not make it large.
struct Fineness {
  int linkage = 0;    ///< positions of a four-bar
  int mechanism = 0;  ///< positions of any other mechanism
};
Fineness fineness(std::size_t designs);

/// Of a four-bar `motion` (`full_turn`, `crank_deg`, `rocker_deg`; `crank_deg` is null where it is
/// 0 to 360 in equal steps). Of another mechanism `drive` and `mechanism` (see mechanism_json.hpp),
/// or null for both where it cannot be assembled, and `stations`, the drive's coordinates at the
/// targets in what the page shows it in.
nlohmann::ordered_json motion_of(const problems::Design& design, const Fineness& fineness);

/// `reached`: where the point called `traced` stands at the targets; null where the mechanism
/// cannot be assembled, or has no such point.
nlohmann::ordered_json reached_points(const problems::Design& design,
                                      std::string_view traced = "P");

/// For targets that are poses: `reached`, where the body's origin is taken, and `guided`: `body`
/// (its number), `axes` ([x, y, deg] of the target's axes in those of the body), `outline` (its
/// corners in its own axes) and `reached`, its places [x, y, deg], null where the mechanism cannot
/// be assembled. `origin`: the name of the body's origin where the body that carries it is guided;
/// empty where that is told from the poses.
nlohmann::ordered_json reached_poses(const problems::Design& design,
                                     std::span<const synthesis::Pose> targets,
                                     std::string_view origin = {});

}  // namespace cognate::app
