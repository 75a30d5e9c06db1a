/// @file How far the double-slider mechanisms travel and how well they transmit, from their
/// dimensions alone.
///
/// Crank and link angles count counter-clockwise from the mechanism's `direction`, displacements
/// along it, from the foot of the perpendicular from the pivot (or from the centre). β or γ is the
/// angle of `slot` or `second_line`. Dimensions are finite, lengths positive, and the slot or the
/// second line is not parallel to the first; results do not depend on the unit of length.
#pragma once

#include <array>
#include <optional>

#include "analysis/linkage/double_slider.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/numbers/circle.hpp"

namespace cognate {

// ---- Scotch yoke: s = (l₁ sin(β − θ) + e cos β)/sin β. The crank always turns, advance and return
// take equal times, and nothing is ever at a dead point of the crank.

/// The displacement of the yoke.
double displacement(const ScotchYoke& mechanism, double crank_angle);

/// Where the yoke turns back, the crank standing across the slot; first the least displacement,
/// then the greatest. Angles in [−π, π].
std::array<SliderPosition, 2> limits(const ScotchYoke& mechanism);

/// 2 l₁/|sin β|: of the yoke on the frame, and equally of the block in the slot.
double stroke(const ScotchYoke& mechanism);

/// The angle in [0, π/2) between the block's force, across the slot, and the yoke's motion: |π/2 −
/// β|, the same everywhere; zero for a slot across the slide.
double pressure_angle(const ScotchYoke& mechanism);

// ---- Tangent generator: s = e/tan θ.

/// Where the lever meets the slide line, its ends not included: (0, π) for an offset to the left,
/// (−π, 0) to the right.
CrankRange crank_range(const TangentGenerator& mechanism);

/// The displacement of the slider; empty outside the range.
std::optional<double> displacement(const TangentGenerator& mechanism, double crank_angle);

/// The lever angle at which the slider stands at `displacement`.
double crank_angle(const TangentGenerator& mechanism, double displacement);

/// How far the slider travels while the lever turns over `range`; empty where that is not inside
/// the range of the mechanism.
std::optional<double> travel(const TangentGenerator& mechanism, const CrankRange& range);

/// The angle in [0, π/2) between the lever's force on the block, across the slot, and the slider's
/// motion: the lean of the lever from the perpendicular. Empty outside the range.
std::optional<double> pressure_angle(const TangentGenerator& mechanism, double crank_angle);

/// The greatest over `range`: at one of its ends.
std::optional<double> greatest_pressure_angle(const TangentGenerator& mechanism,
                                              const CrankRange& range);

// ---- Elliptic trammel: with link angle θ the first pin stands at −l sin(γ − θ)/sin γ on its
// line, the second at l sin θ/sin γ on the other. The link turns fully.

/// Displacements of the two pins from the centre, each along its line.
std::array<double, 2> displacements(const EllipticTrammel& mechanism, double link_angle);

/// 2 l/|sin γ|: the stroke of either pin.
double stroke(const EllipticTrammel& mechanism);

/// Link angles in [−π, π] at which pin `pin` (0 or 1) is at its least and at its greatest
/// displacement: the link stands across the line of the other pin. A dead point where that pin
/// drives.
std::array<SliderPosition, 2> limits(const EllipticTrammel& mechanism, int pin);

/// The angle in [0, π/2] between the link and the line of pin `pin` when the other pin drives.
double pressure_angle(const EllipticTrammel& mechanism, int pin, double link_angle);

/// An ellipse about the centre: half axes, major ≥ minor ≥ 0, and the unit vector of the major in
/// global axes (of any direction where they are equal).
struct Ellipse {
  Vec2d centre;
  double major = 0;
  double minor = 0;
  Vec2d direction{1, 0};
};

/// The path of the point `at` of the link (origin at the first pin, first axis towards the second):
/// a + b of two vectors that turn with θ and with −θ, |b| = l/(2 |sin γ|).
Ellipse path(const EllipticTrammel& mechanism, const Vec2d& at);

/// The centrodes: a circle of radius l/(2 |sin γ|) fixed to the link rolls inside one of twice that
/// radius about the centre (Cardan's circles). `moving_centre` is in the link's axes.
struct CardanCircles {
  double fixed_radius = 0;
  double moving_radius = 0;
  Vec2d moving_centre{};
};
CardanCircles cardan_circles(const EllipticTrammel& mechanism);

// ---- Oldham coupling: both shafts turn at one speed, for any distance d between them.

/// The distance d of the shafts.
double eccentricity(const OldhamCoupling& mechanism);

/// 2 d/|sin β|: the stroke of either tongue in its slot, once back and forth in each turn; the
/// greatest sliding speed is the shafts' speed times half of it.
double stroke(const OldhamCoupling& mechanism);

/// The circle through both pivots round which the disc's centre runs twice in each turn of the
/// shafts.
Circle disc_path(const OldhamCoupling& mechanism);

/// The angle in (0, π/2] between the tongues, which is that of transmission everywhere.
double transmission_angle(const OldhamCoupling& mechanism);

}  // namespace cognate
