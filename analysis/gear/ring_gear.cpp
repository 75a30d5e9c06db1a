#include "analysis/gear/ring_gear.hpp"

#include <cmath>

#include "analysis/gear/chords.hpp"
#include "analysis/gear/involute.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate::gear {
namespace {

SpurGear tool_of(const RingGear& ring) {
  SpurGear tool{.teeth = ring.cutter_teeth, .module = ring.twin.module, .rack = ring.twin.rack};
  tool.rack.addendum += tool.rack.clearance;
  return tool;
}

/// The way from the base circle's tangent point to `radius`.
double tangent_to(double radius, double base) {
  return std::sqrt((radius - base) * (radius + base));
}

Vec2d beside_y_axis(double radius, double angle) {
  return {-radius * std::sin(angle), radius * std::cos(angle)};
}

/// The tool's corner in the ring while it cuts: φ is its angle from the line of centres, 0 where it
/// is deepest.
struct CornerPath {
  Cutting cutting;
  double ratio = 0;  ///< z₀/z

  double radius(double phi) const {
    const double sine = std::sin(0.5 * phi);
    const double deepest = cutting.centre_distance + cutting.tip_radius;
    return std::sqrt(deepest * deepest -
                     4 * cutting.centre_distance * cutting.tip_radius * sine * sine);
  }
  /// From the middle of the space.
  double angle(double phi) const {
    return std::atan2(cutting.tip_radius * std::sin(phi),
                      cutting.centre_distance + cutting.tip_radius * std::cos(phi)) +
           (cutting.tip_half_angle - phi) * ratio;
  }
  double phi_at(double radius) const {
    const double deepest = cutting.centre_distance + cutting.tip_radius;
    return 2 * std::asin(std::sqrt((deepest - radius) * (deepest + radius) /
                                   (4 * cutting.centre_distance * cutting.tip_radius)));
  }
};

}  // namespace

double tip_radius(const RingGear& ring) {
  const SpurGear& twin = ring.twin;
  return (0.5 * twin.teeth - twin.rack.addendum + twin.profile_shift + twin.tip_reduction) *
         twin.module;
}

Cutting cutting_of(const RingGear& ring) {
  const SpurGear& twin = ring.twin;
  const SpurGear tool = tool_of(ring);
  const double alpha = twin.rack.pressure_angle, more = twin.teeth - tool.teeth;
  const double inv = involute(alpha) + 2 * twin.profile_shift * std::tan(alpha) / more;
  if (!(more > 0) || !(inv > 0)) return {NAN, NAN, NAN, NAN};
  Cutting cutting;
  cutting.pressure_angle = involute_angle(inv);
  cutting.centre_distance =
      (base_radius(twin) - base_radius(tool)) / std::cos(cutting.pressure_angle);
  cutting.tip_radius = tip_radius(tool);
  cutting.tip_half_angle = 0.5 * tooth_thickness(tool, cutting.tip_radius) / cutting.tip_radius;
  return cutting;
}

double root_radius(const RingGear& ring) {
  const Cutting cutting = cutting_of(ring);
  return cutting.centre_distance + cutting.tip_radius;
}

double form_radius(const RingGear& ring) {
  const Cutting cutting = cutting_of(ring);
  const double to_tip = tangent_to(cutting.tip_radius, base_radius(tool_of(ring)));
  return std::hypot(base_radius(ring.twin),
                    cutting.centre_distance * std::sin(cutting.pressure_angle) + to_tip);
}

double tooth_thickness(const RingGear& ring, double radius) {
  return kTurn * radius / ring.twin.teeth - tooth_thickness(ring.twin, radius);
}

RingFault ring_fault(const RingGear& ring) {
  const Cutting cutting = cutting_of(ring);
  if (!(cutting.centre_distance > 0)) return RingFault::no_cutting;
  if (!(cutting.tip_half_angle > 0)) return RingFault::pointed_tool;
  const double tip = tip_radius(ring);
  if (!(tip >= base_radius(ring.twin))) return RingFault::inside_base;
  if (!(form_radius(ring) > tip)) return RingFault::no_flank;
  return tooth_thickness(ring, tip) > 0 ? RingFault::none : RingFault::pointed;
}

std::vector<OutlinePoint> ring_half(const RingGear& ring, double tolerance) {
  if (!(tolerance > 0) || ring_fault(ring) != RingFault::none) return {};
  const Cutting cutting = cutting_of(ring);
  const CornerPath corner{cutting, ring.cutter_teeth / ring.twin.teeth};
  const double half_pitch = kPi / ring.twin.teeth, base = base_radius(ring.twin);
  const double root = root_radius(ring), form = form_radius(ring), tip = tip_radius(ring);
  const auto fillet = [&](double phi) {
    return beside_y_axis(corner.radius(phi), half_pitch - corner.angle(phi));
  };
  const auto flank = [&](double tangent) {
    const double radius = std::hypot(base, tangent);
    return beside_y_axis(radius, 0.5 * tooth_thickness(ring, radius) / radius);
  };
  const auto arc = [](double radius) {
    return [radius](double angle) { return beside_y_axis(radius, angle); };
  };
  const double at_root = half_pitch - corner.angle(0);
  const double at_tip = 0.5 * tooth_thickness(ring, tip) / tip;
  std::vector<OutlinePoint> points{{beside_y_axis(root, half_pitch), OutlinePart::root}};
  append_curve(points, OutlinePart::root, arc(root), half_pitch, at_root, tolerance);
  append_curve(points, OutlinePart::fillet, fillet, 0, corner.phi_at(form), tolerance);
  append_curve(points, OutlinePart::involute, flank, tangent_to(form, base), tangent_to(tip, base),
               tolerance);
  append_curve(points, OutlinePart::tip, arc(tip), at_tip, 0, tolerance);
  points.back().at.x = 0;
  return points;
}

std::vector<OutlinePoint> ring_outline(const RingGear& ring, double tolerance) {
  return whole_outline(ring_half(ring, tolerance), ring.twin.teeth);
}

}  // namespace cognate::gear
