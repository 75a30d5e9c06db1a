/// @file What the report page of a cam shows beside the result document, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "problems/cam/result.hpp"

namespace cognate::app {

/// The follower, the limits, and of each design the curves of the cam in its own axes, the motion
/// and what follows from it at places round the turn, strokes, segments, metrics, constraints and
/// proof. All is of a cam that turns counter-clockwise; the page mirrors one that turns the other
/// way. Angles are in degrees, derivatives by the cam angle in radians. Numbers that are only drawn
/// have seven digits; a radius of curvature far beyond the cam's own size is null. However many
/// segments and designs there are, the data stay below about a megabyte.
nlohmann::ordered_json cam_report_data(const problems::CamProblem& problem,
                                       const problems::CamResult& result);

}  // namespace cognate::app
