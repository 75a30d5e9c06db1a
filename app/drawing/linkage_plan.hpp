/// @file A linkage drawn in one position, with the paths of its points.
#pragma once

#include <span>

#include "analysis/mechanism/motion_state.hpp"
#include "app/drawing/link_shapes.hpp"
#include "app/drawing/linkage_paths.hpp"
#include "app/drawing/plan.hpp"

namespace cognate::app {

/// The drawing of `linkage` with its links where `bodies` places them: LINKS (a line or a polygon
/// for each, and the blocks of sliders; of links in layers LINKS_1 and so on), GUIDES, FRAME (a
/// triangle under every fixed pivot), JOINTS (a circle at every turning joint), POINTS (one at
/// every other named point), PATHS, TARGET (a circle at each point of the target) and LABELS
/// (names).
Plan linkage_plan(const LinkageScene& linkage, const LinkShapes& shown,
                  std::span<const BodyMotion<double, 0>> bodies,
                  const std::vector<PointPath>& paths);

}  // namespace cognate::app
