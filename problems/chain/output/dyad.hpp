/// @file The last dyad of a chain, whose output is an angle or the displacement of a slider, by a
/// circle: its joint F keeps its distance from the point E that carries it, so that E moves along a
/// circle about F in the plane in which F stands still.
#pragma once

#include <limits>
#include <optional>
#include <span>

#include "problems/chain/output/space.hpp"
#include "problems/chain/starts/draw.hpp"

namespace cognate::problems {

/// A circle near points.
struct CircleNear {
  Vec2d centre;
  double radius = 0;
  double deviation = std::numeric_limits<double>::infinity();  ///< greatest distance from it
};

/// The circle nearest to `points` by linear least squares (Kåsa 1976, "A circle fitting procedure
/// and its error analysis"); of infinite deviation where they are in line.
CircleNear circle_near(std::span<const Vec2d> points);

/// Whether the output turns about a pivot G of the frame and its dyad E-F-G is the last line of the
/// chain, right after G, with free dimensions, so that a circle gives them.
bool ends_in_free_dyad(const OutputSpace& space);

/// The same of a slider on its guide: the last two lines, whose pin stands still in the plane that
/// moves with the slider.
bool ends_in_free_slider(const OutputSpace& space);

/// The direction of its guide, where that is given.
std::optional<double> guide_direction(const OutputSpace& space);

/// Whether all that is known of the chain before the guide is that its crank turns about the
/// origin: it may be turned and enlarged.
bool has_free_carrier(const OutputSpace& space);

/// The chain up to E, of such a space.
class OutputCarrier {
 public:
  OutputCarrier(const OutputSpace& of, const Range& transmission);
  OutputCarrier(const OutputCarrier&) = delete;
  OutputCarrier& operator=(const OutputCarrier&) = delete;

  const ChainSpace& space() const { return space_; }

 private:
  Topology topology_;
  ChainSpace space_;
};

/// The whole chain: `carrier` with the pivot G and the joint F in the centre of the circle, on its
/// side where E is at `point`. Empty where the file wants the other assembly.
std::optional<synthesis::ChainDesign> hung(const OutputSpace& space,
                                           const synthesis::ChainDesign& carrier,
                                           const Vec2d& pivot, const CircleNear& circle,
                                           const Vec2d& point);

/// The whole chain with a slider on a guide in the direction `guide`: its pin is in the centre of
/// the circle where the carrying point is at `point`.
std::optional<synthesis::ChainDesign> with_slider(const OutputSpace& space,
                                                  const synthesis::ChainDesign& carrier,
                                                  const Vec2d& guide, const CircleNear& circle,
                                                  const Vec2d& point);

}  // namespace cognate::problems
