/// @file A group of more than two links as its dimensions describe it, from where it is drawn.
#pragma once

#include <vector>

#include "analysis/mechanism/attached.hpp"
#include "problems/mechanism/drawn/drawing.hpp"
#include "problems/mechanism/drawn/groups.hpp"
#include "problems/mechanism/mechanism_description.hpp"

namespace cognate::problems::reading {

/// Coordinates this much smaller than a drawing are 0 but for rounding.
inline constexpr double kDrawnRounding = 1e-15;

/// The greatest |x| + |y| of the joints.
double size_of(const Drawing& drawing);

/// The links that have been described, and of these the axes where they are drawn.
struct DescribedLinks {
  std::vector<Placement> axes;       ///< one for each link of the drawing
  std::vector<std::size_t> numbers;  ///< of the links described

  /// A place of the drawing in the axes of `link`, 0 where it is but for rounding.
  Vec2d in_axes(std::size_t link, const Vec2d& place, double size) const;
};

/// A group, and the joints of the drawing that are its own.
struct DescribedGroup {
  GroupDescription group;
  std::vector<std::size_t> joints;
};

/// `group` with the drive at `drive`, its links added to `links`. Their axes have the origin at the
/// first pin and the first axis towards the second, or along a slide.
DescribedGroup describe_group(const Drawing& drawing, const DrawnGroup& group, double drive,
                              DescribedLinks& links);

/// Whether the links of a group that was described last could move with the drive at rest.
bool could_move_alone(const Drawing& drawing, const GroupDescription& group,
                      const DescribedLinks& links);

}  // namespace cognate::problems::reading
