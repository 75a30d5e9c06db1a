/// @file Screws with their nuts and washers.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cognate::app {

/// A hexagon socket head cap screw (ISO 4762), a prevailing torque nut (ISO 7040) and plain washers
/// (ISO 7089), in millimetres.
struct Screw {
  std::string_view designation;  ///< "M5"
  double diameter = 0, pitch = 0;
  double hole = 0;  ///< of the washer, and of ISO 273, fine series
  double head_diameter = 0, head_height = 0;
  double nut_height = 0, nut_width = 0;  ///< across flats
  double washer_outside = 0, washer_thickness = 0;

  /// All lengths times `factor`.
  Screw scaled(double factor) const;
};

/// The screw of this designation; empty where the table has none.
std::optional<Screw> screw_called(std::string_view designation);

/// What is allowed as a designation, in words.
std::string screw_designations();

/// The least nominal length of ISO 4762 that is no less than `least`, both in the lengths of
/// `screw`; empty where none is made so long.
std::optional<double> screw_length(const Screw& screw, double least);

}  // namespace cognate::app
