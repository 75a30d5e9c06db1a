/// @file The coupler points that move straight at a position of a linkage, by the local theory.
///
/// Contact of three points with the tangent has every point of the inflection circle (or line),
/// contact of four Ball's point alone, contact of five none, unless the position or a dimension is
/// chosen for it: `contact_search.hpp`.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "synthesis/exact/straight_line/coupler_position.hpp"

namespace cognate::synthesis {

/// How a point was found.
enum class StraightPointKind {
  coupler_line,     ///< where the inflection circle meets the line through B and C
  inflection_pole,  ///< the point of the inflection circle farthest from the pole
  ball,             ///< Ball's point
  five_point,       ///< where the loci of contact of three and of five points meet
  /// The point level with B of a line all of whose points have contact of four; where that is the
  /// slider's pin, the one as far from it as the longest link is long.
  inflection_line,
};

/// "coupler-line", "inflection-pole", "ball-point", "five-point-contact" or
/// "inflection-line".
std::string_view name(StraightPointKind kind);

/// A coupler point, and how closely its path touches its tangent.
struct StraightPoint {
  StraightPointKind kind = StraightPointKind::ball;
  Vec2d coupler_point;  ///< in the coupler's axes: origin B, the first from B to C
  Contact contact;
  /// 1/sine of the angle under which the two loci (or locus and line) meet whose intersection the
  /// point is, times its distance from B over the size where that is greater than 1: by this
  /// much relative errors of the dimensions come back in the point. Infinite where they touch.
  double condition = 1;
};

/// Why no point of the requested contact exists.
enum class NoStraightPoint {
  none,                ///< there is one
  not_closed,          ///< the linkage cannot be assembled at the position
  change_point,        ///< all links are in line: the motion there is undetermined
  parallel_motion,     ///< the coupler slides without angular acceleration, as in a parallelogram
  at_infinity,         ///< Ball's point is at infinity: parallel cranks, the coupler aslant
  at_pole,             ///< Ball's point falls on the pole, where nothing moves
  at_slider,           ///< the point is the slider's pin, which moves straight in any case
  too_few,             ///< there are points, of less contact than requested
  misses_coupler_line  ///< the inflection circle does not meet the coupler line (no fault)
};

/// What the theory says of a position.
struct StraightPoints {
  NoStraightPoint why = NoStraightPoint::none;
  std::optional<CircleOrLine> inflection;  ///< from B, in global directions; empty if undetermined
  std::vector<StraightPoint> points;       ///< of at least the requested contact
};

/// All points of the linkage at `crank_angle` (from the x axis) with contact of at least `contact`
/// points, 3 to 5. Of contact 3, which a whole circle has, those on the coupler line, the
/// inflection pole and Ball's point. The pin of a slider is none, nor are points farther off than
/// 1e6 sizes.
///
/// Of a slider-crank the slider's pin is on every locus, so that Ball's point is another one only
/// where the pin is the pole as well: in the limit positions, crank and coupler in line. With the
/// crank across the slide line the coupler does not turn and its pole is at infinity: the line
/// through the pin across the slide is then the inflection line, and all of it has contact of four
/// points (at a height h over the pin the path is y = h (1 − α² t⁴/8 + …), α the angular
/// acceleration), as has that of parallel cranks with the coupler across them.
StraightPoints straight_points(const CouplerLinkage& linkage, double crank_angle, int contact);
StraightPoints straight_points(const CouplerPosition& position, int contact);

}  // namespace cognate::synthesis
