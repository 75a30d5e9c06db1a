/// @file Solids of parts, and the module that shapes them.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/drawing/plan.hpp"

namespace cognate::app {

/// A closed curve of lines and arcs, or a circle, which has no corners. Where lines meet at less
/// than 20° they stand for a smooth curve through their corners.
struct SolidLoop {
  std::vector<PlanCorner> corners;
  Vec2d centre{};
  double radius = 0;
};

SolidLoop circle_loop(const Vec2d& centre, double radius);

/// What `loop` encloses, less what `hollow` within it does, from the height `low` to `high`. With a
/// twist, which no hollow goes with, the section turns by it evenly, counter-clockwise about the
/// origin, from `low` to `high`.
struct SolidPrism {
  SolidLoop loop;
  double low = 0, high = 0;
  std::optional<SolidLoop> hollow{};
  double twist = 0;
};

/// The material of prisms together less holes, in axes of its own, which stand in the assembly
/// turned by `direction` about their origin and then moved by `at`.
struct Solid {
  std::string name;
  std::vector<SolidPrism> material, holes;
  Vec2d at{};
  Vec2d direction{1, 0};
};

struct SolidAssembly {
  std::string title;
  double millimetres = 1;      ///< how long a length of 1 is
  double chord_tolerance = 0;  ///< of the facets, a length
  std::vector<Solid> solids;
};

enum class SolidFormat {
  step,  ///< ISO 10303-21, AP214: one product for each solid, in an assembly
  stl    ///< facets of each solid in a text of its own, lying on the plane z = 0
};

/// Both in millimetres.
struct ShapedSolids {
  std::vector<std::string> texts;  ///< one, but of STL one for each solid
  std::vector<double> volumes;     ///< of each solid, in cubes of the assembly's lengths
};

/// Shapes solids with OpenCASCADE, which the module beside the program brings. The error says that
/// there is no such module, or which solid cannot be shaped and why.
tl::expected<ShapedSolids, std::string> shape_solids(const SolidAssembly& assembly,
                                                     SolidFormat format);

/// What the module has under the name `cognate_shape_solids`.
using ShapeSolids = void(const SolidAssembly&, SolidFormat,
                         tl::expected<ShapedSolids, std::string>&);

}  // namespace cognate::app
