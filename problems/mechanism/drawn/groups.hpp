/// @file The Assur groups of a mechanism that is given by its joints alone.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "problems/mechanism/drawn/drawing.hpp"

namespace cognate::problems::reading {

/// Two links that an inner joint joins. An outer joint holds each to links that move before them.
struct DrawnDyad {
  std::size_t first = 0, second = 0;                         ///< links
  std::size_t first_outer = 0, inner = 0, second_outer = 0;  ///< joints
};

/// Four links or more that are determined together and not in pairs: a group of class III or
/// higher.
struct DrawnGroup {
  std::vector<std::size_t> links;
};

/// The groups in the order in which they close on the frame, the drive and one another, and the
/// links that are left: none where the mechanism is a drive and groups. Which groups there are does
/// not depend on the order in which they are found (the decomposition into Assur groups by a drive
/// is unique; Assur 1914), which is that of the joints.
struct DrawnGroups {
  std::vector<std::variant<DrawnDyad, DrawnGroup>> groups;
  std::vector<std::size_t> left;
};

/// The link that both outer joints of a dyad are on, so that it cannot move there; empty where they
/// are on two.
std::optional<std::size_t> shared_link(const Drawing& drawing, const DrawnDyad& dyad);

/// Those of a drawing in which `driven` is the link that drives.
DrawnGroups groups_of(const Drawing& drawing, std::size_t driven);

/// Grübler's count of a plane linkage, 3(n − 1) − 2j, where a pin of m links counts as m − 1.
struct DrawnMobility {
  std::size_t links = 0;
  std::size_t joints = 0;

  int value() const { return 3 * (static_cast<int>(links) - 1) - 2 * static_cast<int>(joints); }
};
DrawnMobility mobility_of(const Drawing& drawing);

}  // namespace cognate::problems::reading
