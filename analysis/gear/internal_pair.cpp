#include "analysis/gear/internal_pair.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/gear/involute.hpp"
#include "analysis/gear/line_of_action.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear {
namespace {

double difference_of_base_radii(const SpurGear& pinion, const RingGear& ring) {
  return base_radius(ring.twin) - base_radius(pinion);
}

/// inv α′ of the pair without backlash.
double involute_without_backlash(const SpurGear& pinion, const RingGear& ring) {
  const double alpha = pinion.rack.pressure_angle;
  const double shifts = ring.twin.profile_shift - pinion.profile_shift;
  return involute(alpha) + 2 * shifts * std::tan(alpha) / (ring.twin.teeth - pinion.teeth);
}

double tangent_of(double radius, double base) {
  return std::sqrt((radius - base) * (radius + base));
}

/// The zero of a falling function between `from` and `to`, to the last bit.
template <class Function>
double falling_zero(const Function& function, double from, double to) {
  for (double middle = 0.5 * (from + to); from < middle && middle < to;
       middle = 0.5 * (from + to)) {
    (function(middle) > 0 ? from : to) = middle;
  }
  return to;
}

/// What the pair's formulas share.
struct InternalLine {
  double angle = 0;   ///< α′
  double offset = 0;  ///< T₂T₁ = a′ sin α′
  double pitch_point = 0, base_pitch = 0;
  double ring_tip = 0, pinion_tip = 0;    ///< where tips end the path
  double pinion_form = 0, ring_form = 0;  ///< where form circles would
};

InternalLine line_of(const InternalPair& pair) {
  InternalLine line;
  const double base = base_radius(pair.pinion), ring_base = base_radius(pair.ring.twin);
  line.angle = std::acos((ring_base - base) / pair.centre_distance);
  line.offset = pair.centre_distance * std::sin(line.angle);
  line.pitch_point = base * std::tan(line.angle);
  line.base_pitch = kTurn * base / pair.pinion.teeth;
  line.ring_tip = tangent_of(tip_radius(pair.ring), ring_base) - line.offset;
  line.pinion_tip = tangent_of(flank_end_radius(pair.pinion), base);
  line.pinion_form = form_tangent(pair.pinion);
  line.ring_form = tangent_of(form_radius(pair.ring), ring_base) - line.offset;
  return line;
}

/// From where the pinion's tip circle crosses the ring's: the angle at which flanks that have
/// touched are apart there, times the pinion's teeth.
double room_of_tips(const InternalPair& pair, double working_angle) {
  const double tip = flank_end_radius(pair.pinion), ring_tip = tip_radius(pair.ring);
  const double a = pair.centre_distance;
  const double pinion_cosine = (ring_tip * ring_tip - tip * tip - a * a) / (2 * a * tip);
  const double ring_cosine = (ring_tip * ring_tip - tip * tip + a * a) / (2 * a * ring_tip);
  if (!(std::abs(pinion_cosine) < 1)) return kInfinity;
  const double own = involute(pressure_angle(pair.pinion, tip)) + std::acos(pinion_cosine);
  const double other = involute(pressure_angle(pair.ring.twin, ring_tip)) + std::acos(ring_cosine);
  return pair.pinion.teeth * own - pair.ring.twin.teeth * other +
         (pair.ring.twin.teeth - pair.pinion.teeth) * involute(working_angle);
}

/// The same for the pinion that stands still beside its place on the line of centres, over all
/// places on the way.
double room_when_assembled(const InternalPair& pair, double working_angle) {
  const double tip = pressure_angle(pair.pinion, flank_end_radius(pair.pinion));
  const double ring_tip = pressure_angle(pair.ring.twin, tip_radius(pair.ring));
  const double ratio = pair.ring.twin.teeth / pair.pinion.teeth;
  const double share = std::cos(tip) / std::cos(ring_tip);
  const double sine = (1 - share * share) / (1 - 1 / (ratio * ratio));
  const double ring_sine = (1 / (share * share) - 1) / (ratio * ratio - 1);
  if (!(sine >= 0 && sine <= 1 && ring_sine <= 1)) return kInfinity;
  const double own = std::asin(std::sqrt(sine)) + involute(tip) - involute(working_angle);
  const double other =
      std::asin(std::sqrt(ring_sine)) + involute(ring_tip) - involute(working_angle);
  return pair.pinion.teeth * own - pair.ring.twin.teeth * other;
}

/// 0 of what is rounding.
double passing(double length, double module) {
  return length > 1e-9 * module ? length : 0;
}

GearInMesh pinion_in_mesh(const InternalPair& pair, const InternalLine& line, double start,
                          double end) {
  const double ratio = pair.ring.twin.teeth / pair.pinion.teeth;
  const double base = base_radius(pair.pinion);
  GearInMesh own;
  own.working_radius = pair.centre_distance / (ratio - 1);
  own.contact_start = std::hypot(base, start);
  own.contact_end = std::hypot(base, end);
  own.interference = passing(line.pinion_form - line.ring_tip, pair.pinion.module);
  if (is_undercut(pair.pinion)) own.interference = passing(-line.ring_tip, pair.pinion.module);
  own.tip_clearance = root_radius(pair.ring) - pair.centre_distance - flank_end_radius(pair.pinion);
  own.sliding_start = specific_sliding(start, (start + line.offset) / ratio, pair.pinion.module);
  own.sliding_end = specific_sliding(end, (end + line.offset) / ratio, pair.pinion.module);
  return own;
}

GearInMesh ring_in_mesh(const InternalPair& pair, const InternalLine& line, double start,
                        double end) {
  const double ratio = pair.ring.twin.teeth / pair.pinion.teeth;
  const double base = base_radius(pair.ring.twin);
  GearInMesh own;
  own.working_radius = pair.centre_distance * ratio / (ratio - 1);
  own.contact_start = std::hypot(base, end + line.offset);
  own.contact_end = std::hypot(base, start + line.offset);
  own.interference = passing(line.pinion_tip - line.ring_form, pair.pinion.module);
  own.tip_clearance = tip_radius(pair.ring) - pair.centre_distance - root_radius(pair.pinion);
  own.sliding_start = 1 - ratio * end / (end + line.offset);
  own.sliding_end = 1 - ratio * start / (start + line.offset);
  return own;
}

/// Zero where it is so to rounding.
double backlash_of(const InternalPair& pair, double working_angle) {
  const double angle = involute_without_backlash(pair.pinion, pair.ring) - involute(working_angle);
  return std::abs(angle) <= 4e-15 ? 0 : 2 * pair.centre_distance * angle;
}

}  // namespace

double internal_centre_distance(const SpurGear& pinion, const RingGear& ring, double backlash) {
  const double base = difference_of_base_radii(pinion, ring);
  const double inv = involute_without_backlash(pinion, ring);
  if (!(base > 0) || !(inv > 0)) return NAN;
  const double greatest = involute_angle(inv);
  if (backlash == 0) return base / std::cos(greatest);
  // (inv − inv α′)/cos α′ is greatest where tan α′ = inv − inv α′.
  const double crest = falling_zero(
      [&](double angle) { return inv - involute(angle) - std::tan(angle); }, 0, greatest);
  const auto more = [&](double angle) {
    return 2 * base * (inv - involute(angle)) / std::cos(angle) - backlash;
  };
  if (!(more(crest) >= 0)) return NAN;
  return base / std::cos(falling_zero(more, crest, greatest));
}

InternalGeometry geometry(const InternalPair& pair) {
  const InternalLine line = line_of(pair);
  const double start = std::max(line.ring_tip, line.pinion_form);
  const double end = std::max(start, std::min(line.pinion_tip, line.ring_form));
  const double ratio = pair.ring.twin.teeth / pair.pinion.teeth;
  InternalGeometry all;
  all.path_start = start;
  all.path_end = end;
  PairGeometry& mesh = all.mesh;
  mesh.working_pressure_angle = line.angle;
  mesh.path_length = end - start;
  mesh.contact_ratio = mesh.path_length / line.base_pitch;
  mesh.approach = line.pitch_point - start;
  mesh.recess = end - line.pitch_point;
  mesh.backlash = backlash_of(pair, line.angle);
  mesh.normal_backlash = mesh.backlash * std::cos(line.angle);
  mesh.gears = {pinion_in_mesh(pair, line, start, end), ring_in_mesh(pair, line, start, end)};
  mesh.greatest_sliding_speed = std::max(std::abs(mesh.approach), std::abs(mesh.recess)) *
                                (1 - 1 / ratio) / mesh.gears[0].working_radius;
  all.tip_room = room_of_tips(pair, line.angle);
  all.radial_room = room_when_assembled(pair, line.angle);
  return all;
}

double ring_angle(const InternalPair& pair) {
  const double angle = line_of(pair).angle;
  // The leading flank of the pinion's tooth at the y axis leaves its base circle at `own` ahead of
  // it, and touches α′ + own beyond T₁; there the ring's flank has unwound as much and T₂T₁ more.
  const double own = base_half_angle(pair.pinion);
  const double way = base_radius(pair.pinion) * (own + angle);
  const double ring_way = way + line_of(pair).offset;
  const double space = ring_way / base_radius(pair.ring.twin) - angle -
                       base_half_angle(pair.ring.twin);  // its middle, counter-clockwise
  return space + kPi / pair.ring.twin.teeth;
}

}  // namespace cognate::gear
