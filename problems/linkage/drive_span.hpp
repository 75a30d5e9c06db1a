/// @file The part of its drive in which a finished design is drawn and its links are layered.
#pragma once

#include <optional>
#include <span>

#include "analysis/mechanism/mechanism.hpp"

namespace cognate::problems {

/// A range of the drive coordinate: radians, or a length for a driving slider.
struct DriveSpan {
  double from = 0;
  double to = 0;
  bool round = false;  ///< whether its end is its start again
};

/// The range in which `mechanism` can be assembled and that holds most of `stations` (drive
/// coordinates, in any turn): of a crank or floating link the first one where none does, and a
/// hair beyond the dead points at its ends; of a driving slider with some of the way beyond its
/// outermost stations. Empty where the mechanism
/// cannot be assembled, and for a driving slider without two stations.
std::optional<DriveSpan> drive_span(const Mechanism<double>& mechanism,
                                    std::span<const double> stations);

}  // namespace cognate::problems
