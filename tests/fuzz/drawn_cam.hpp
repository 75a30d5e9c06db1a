/// @file What must hold of every cam that is found for a problem or read from a result.
#pragma once

#include <algorithm>
#include <cmath>

#include "app/drawing/cam_drawing.hpp"
#include "problems/cam/result.hpp"

namespace cognate::problems {

/// Whether the lengths of a cam that was found are numbers.
inline bool is_sound(const CamProblem& problem, const CamDesign& design) {
  const auto& d = design.cam.system.follower.dimensions;
  return d.base_radius > 0 && design.motion.size() == problem.motion.size() &&
         std::isfinite(d.base_radius + d.offset + d.roller_radius + d.centre_distance + d.arm +
                       d.face_offset + design.cam.system.start + design.operation.preload);
}

/// Whether the profile of a cam can be drawn, of finite points throughout.
inline bool is_drawn(const CamProblem& problem, const CamDesign& design) {
  app::CamDrawingOptions options;
  options.chord_tolerance = 0.01 * design.cam.system.follower.dimensions.base_radius;
  const auto drawing = app::cam_drawing(problem, design, options);
  return drawing && std::ranges::all_of(drawing->curves, [](const app::CamOutline& curve) {
           return curve.points.size() >= 3 &&
                  std::ranges::all_of(curve.points, [](const cam::ProfilePoint& point) {
                    return std::isfinite(point.at.x + point.at.y + point.normal.x + point.normal.y);
                  });
         });
}

}  // namespace cognate::problems
