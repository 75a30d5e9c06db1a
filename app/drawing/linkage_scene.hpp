/// @file A linkage that is to be drawn.
#pragma once

#include <optional>
#include <vector>

#include "problems/evaluation/problem.hpp"

namespace cognate::app {

/// A linkage, the part of its drive in which it is shown, and what it was made for.
struct LinkageScene {
  problems::AnalysisProblem problem;  ///< its outputs are the positions alone
  bool round = false;                 ///< whether the drive ends where it starts
  bool beyond = false;                ///< whether the drive goes a hair beyond what is assembled
  std::vector<double> stations;       ///< drive coordinates at the targets, where it has any
  std::vector<Vec2d> targets;         ///< points that it was to reach; of poses their origins
  std::optional<problems::LayerSizes> layers{};  ///< sizes of parts that the file gives
};

/// Whether a displacement drives the linkage rather than an angle.
inline bool is_driven_by_slider(const LinkageScene& scene) {
  return driven_by_length(scene.problem.mechanism.mechanism.drive);
}

}  // namespace cognate::app
