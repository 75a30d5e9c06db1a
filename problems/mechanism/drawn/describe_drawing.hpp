/// @file The dimensions of a mechanism that is drawn.
#pragma once

#include <optional>
#include <vector>

#include "problems/mechanism/drawn/drawing.hpp"
#include "problems/mechanism/drawn/groups.hpp"
#include "problems/mechanism/mechanism_description.hpp"

namespace cognate::problems::reading {

/// A drive and dyads with the lengths, directions and assemblies of the drawing, and the joints
/// and points of links that these do not have, in the axes of their links.
struct DescribedDrawing {
  ChainDescription chain;
  std::vector<PointDescription> points;
  double drive = 0;  ///< what the drive is at in the drawing: an angle, or a slider's displacement
};

/// `groups`: all dyads of the drawing. A driving link that has no pin beside that of the frame gets
/// a point called after it, "lever-end". Empty, with a fault, where two joints of a link coincide
/// or a dyad is drawn at a dead point, where both its assemblies meet.
std::optional<DescribedDrawing> describe(const Drawing& given, const DrawnGroups& groups,
                                         FaultList& faults);

}  // namespace cognate::problems::reading
