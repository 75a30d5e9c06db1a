/// @file The one position in which a linkage is drawn.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "analysis/mechanism/followed_motion.hpp"
#include "app/export/result_linkage.hpp"

namespace cognate::app {

struct ShownPosition {
  double drive = 0;  ///< radians, or a length for a driving slider
  double value = 0;  ///< the same as people write it: degrees or a length
};

/// A position of the drive, and `motion` moved there: `wanted` (degrees, or a length), else the
/// first of the stations, else the first row of the drive at which the linkage can be assembled.
/// The error says why there is none and what is allowed.
tl::expected<ShownPosition, std::string> shown_position(const ResultLinkage& linkage,
                                                        std::optional<double> wanted,
                                                        FollowedMotion<0>& motion);

}  // namespace cognate::app
