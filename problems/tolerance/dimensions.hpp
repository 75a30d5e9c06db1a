/// @file The dimensions of a mechanism that can be off, by the keys under which files give them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/tolerance/affine_mechanism.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {

/// A dimension and how a mechanism's description changes with it.
struct MechanismDimension {
  std::string name;   ///< "crank"; of a place "coupler_point.u", "pivot_a.x"
  std::string group;  ///< what `[tolerance]` calls it: "crank", "coupler_point", "pivots"
  double nominal = 0;
  std::function<void(NamedMechanism& mechanism, double change)> add;
  bool is_length = false;  ///< of a link: positive, unlike offsets and coordinates
};

/// Of a mechanism that its dimensions tell: those of its keys, "frame" for the distance of two
/// given pivots; of a chain the crank's length, each body's (under the body's name; of an RPR the
/// bar's offset) and the slides' offsets. Then the points of bodies, under their names, and the
/// coordinates of fixed pivots. Angles of guides and slots count as exact.
std::vector<MechanismDimension> dimensions(const NamedMechanism& mechanism);

/// The groups of these, each once: what `[tolerance]` may name.
std::vector<std::string> dimension_groups(const NamedMechanism& mechanism);

/// A dimension with its tolerance.
struct TolerancedDimension {
  std::string name;
  double nominal = 0;
  Deviation deviation;
  bool is_length = false;  ///< positive, unlike offsets and coordinates

  double middle() const { return (deviation.plus - deviation.minus) / 2; }  ///< from the nominal
  double half_width() const { return (deviation.plus + deviation.minus) / 2; }
};

/// The deviation that `value` gives the dimension `name` of this nominal value; or that its
/// standard has none. Of a place on an axis, nominally 0, a grade has none either: no deviation.
tl::expected<Deviation, std::string> deviation_of(const std::string& name, double nominal,
                                                  const ToleranceValue& value,
                                                  std::optional<LengthUnit> unit);

/// Why no figures exist where a length may be none; empty for any other dimension.
std::optional<std::string> nothing_left(const TolerancedDimension& dimension);

/// What may be off, and the mechanism as a function of it. Points are those of the mechanism.
struct TolerancedMechanism {
  std::vector<TolerancedDimension> dimensions;  ///< whose tolerance is not 0
  AffineMechanism mechanism;                    ///< over the changes of these, in their order
};

/// A tolerance that cannot be: of a length that the table of a standard does not reach, or of which
/// nothing is left; or of a dimension by which the mechanism's description does not tell it.
struct ImpossibleTolerance {
  std::string group;  ///< of the dimension, as `[tolerance]` calls it; empty where it is no one's
  std::string reason;
};

/// The dimensions of `mechanism` with the tolerances that the file gives; or why there is none.
/// Where pivots have a tolerance of their own, "frame" follows from them and has none unless it is
/// named. Grades count without a unit as in mm.
tl::expected<TolerancedMechanism, ImpossibleTolerance> toleranced(const NamedMechanism& mechanism,
                                                                  const Tolerances& tolerances,
                                                                  std::optional<LengthUnit> unit);

}  // namespace cognate::problems
