/// @file A mechanism in motion, as the report page draws it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "problems/evaluation/problem.hpp"
#include "problems/linkage/drive_span.hpp"

namespace cognate::app {

/// 180/π, or 1 where the drive is a slider: from the drive's coordinate to what is shown of it.
double drive_unit(const problems::NamedMechanism& mechanism);

/// The motion of `mechanism` over `span` of its drive in about `samples` positions: `drive` (their
/// coordinates, in degrees or length), `bodies` (for each `x`, `y`, `deg` at each sample, a single
/// number where it never changes, null where the body cannot be placed; and its shape in its own
/// axes), `pins` and `points` (with their places on bodies).
nlohmann::ordered_json mechanism_motion_json(const problems::NamedMechanism& mechanism,
                                             const problems::DriveSpan& span, int samples);

/// The same over the sweep of an analysis. Few enough samples are taken of a mechanism of many
/// bodies to keep the page small.
nlohmann::ordered_json mechanism_json(const problems::AnalysisProblem& problem);

/// The drive as a page moves it: `name`, `kind` ("angle" or "slider"), `from`, `to`, `round`.
nlohmann::ordered_json drive_json(const problems::NamedMechanism& mechanism,
                                  const problems::DriveSpan& span);

}  // namespace cognate::app
