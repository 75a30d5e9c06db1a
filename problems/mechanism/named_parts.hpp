/// @file The bodies and points of a mechanism by the names that users know them by.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/mechanism/mechanism.hpp"

namespace cognate::problems {

/// A body as users know it. `slider`: it slides on a guide, and a single pin determines its motion.
struct Body {
  std::string name;
  bool slider = false;
};

/// A point that users know by name, on every body that it is fixed on: a pin lies on two or more.
/// The bodies rise; the last is the farthest from the frame and the drive.
struct PointOnLink {
  std::string name;
  std::vector<Attached<double>> on;
};

/// What has been named so far, in the order of the bodies' numbers; body 0 is "frame".
struct NamedParts {
  std::vector<Body> bodies{{"frame", false}};
  std::vector<PointOnLink> points;
};

/// Where `point` lies in the axes of `body`; empty where it is not fixed on it.
std::optional<Vec2d> place_on(const PointOnLink& point, int body);

/// The number of a body on which both points are fixed, the frame last; empty where there is none.
std::optional<int> common_body(const PointOnLink& first, const PointOnLink& second);

}  // namespace cognate::problems
