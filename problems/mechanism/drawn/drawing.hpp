/// @file A mechanism as it is drawn: its joints, where they stand in one position, and the links
/// that they join.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/numbers/vec2.hpp"
#include "problems/toml/fault_list.hpp"

namespace cognate::problems::reading {

/// A joint of the links `of`, numbers in `Drawing::links`: a pin of two or more; a point of one,
/// about which nothing turns; or, with a direction, a slide of two.
struct DrawnJoint {
  std::string name;
  std::vector<std::size_t> of;
  Vec2d at{};                      ///< of a pin or a point; of a slide it says nothing
  std::optional<Vec2d> direction;  ///< a unit vector
  Where where;                     ///< in the file
};

/// Joints in the order of the file. Link 0 is the frame, `driven` the one that drives; it has one
/// joint with the frame.
struct Drawing {
  std::vector<std::string> links{"frame"};
  std::vector<DrawnJoint> joints;
  std::size_t driven = 0;
};

/// Whether the joint is one of `link`.
bool joins(const DrawnJoint& joint, std::size_t link);

/// The places in `joints` of those of `link`, in their order.
std::vector<std::size_t> joints_of(const Drawing& drawing, std::size_t link);

/// "\"B\" and \"C\"".
std::string joint_names(const Drawing& drawing, const std::vector<std::size_t>& joints);

}  // namespace cognate::problems::reading
