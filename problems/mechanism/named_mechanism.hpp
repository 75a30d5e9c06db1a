/// @file A mechanism with the names that users know its parts by.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/mechanism.hpp"
#include "problems/basics/names.hpp"
#include "problems/mechanism/mechanism_description.hpp"

namespace cognate::problems {

/// A point that users know by name: a joint, a pivot, or a point of a link.
struct NamedPoint {
  std::string name;
  Attached<double> at;
};

struct NamedMechanism {
  Mechanism<double> mechanism;
  std::vector<std::string> bodies;  ///< one for each body: "frame", "crank", "coupler", "C"…
  std::vector<NamedPoint> points;   ///< pivots, pins and points of links
  int output = 0;                   ///< the body whose motion is the mechanism's output
  MechanismDescription description = ChainDescription{};
  std::vector<PointDescription> extra_points;  ///< `[[point]]`, also among `points`

  MechanismType type() const { return static_cast<MechanismType>(description.index()); }
  /// Its dimensions where it is a four-bar; null where it is not.
  const FourBar* four_bar() const { return std::get_if<FourBar>(&description); }
};

/// The mechanism of `description`, any but a chain, named by `mechanism_types.hpp`.
NamedMechanism named(const MechanismDescription& description);

/// Adds a point of the body called `body`, at `at` in that body's axes, under `name`.
void add_point(NamedMechanism& mechanism, const std::string& name, const std::string& body,
               const Vec2d& at);

template <>
std::span<const Named<MechanismType>> names<MechanismType>();
template <>
std::span<const Named<DyadType>> names<DyadType>();

}  // namespace cognate::problems
