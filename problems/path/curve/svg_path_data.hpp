/// @file SVG path data, the `d` of a path: https://www.w3.org/TR/SVG11/paths.html.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/numbers/vec2.hpp"

namespace cognate::problems::reading {

/// A piece of a path. Of a cubic Bézier curve `a` and `b` are the control points; of an arc
/// p(t) = centre + a cos(start + t·sweep) + b sin(start + t·sweep). Quadratic curves are cubic
/// ones.
struct PathSegment {
  enum class Kind { line, cubic, arc };
  Kind kind = Kind::line;
  Vec2d from, to;
  Vec2d a, b, centre;
  double start = 0, sweep = 0;

  /// The point at t in [0, 1].
  Vec2d at(double t) const;
};

/// What is drawn from one move to the next.
struct Subpath {
  Vec2d start;
  std::vector<PathSegment> segments;
  bool closed = false;  ///< by the command Z
};

/// What is wrong at byte `offset`, and what is allowed.
struct PathDataFault {
  std::size_t offset = 0;
  std::string message;
};

/// The subpaths of `text`, moves without anything drawn left out; y points down. Numbers are at
/// most 1e100, segments at most 20 000.
tl::expected<std::vector<Subpath>, PathDataFault> parse_path_data(std::string_view text);

}  // namespace cognate::problems::reading
