/// @file The one position in which a linkage is drawn.
#pragma once

#include <optional>

#include "analysis/mechanism/followed_motion.hpp"
#include "app/drawing/linkage_scene.hpp"

namespace cognate::app {

/// `drive` (radians, or a length for a driving slider) as people write it: degrees or a length.
double shown_drive(const LinkageScene& linkage, double drive);

/// The drive coordinate at which `linkage` is drawn, and `motion` moved there: `wanted` (degrees,
/// or a length), else the first of the stations, else the first row of the drive at which the
/// linkage can be assembled. Empty where it cannot be assembled there.
std::optional<double> drive_position(const LinkageScene& linkage, std::optional<double> wanted,
                                     FollowedMotion<0>& motion);

}  // namespace cognate::app
