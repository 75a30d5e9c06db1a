#include "analysis/gear/spur_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/gear/fillet.hpp"
#include "analysis/gear/involute.hpp"
#include "analysis/gear/line_of_action.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate::gear {
namespace {

/// The corner of a tip seen from the gear whose space it passes. ψ is its angle from the line of
/// centres, to the side to which it moves; β that about the other centre.
struct TipPath {
  double centre_distance = 0;
  double tip_radius = 0;
  double ratio = 0;       ///< by how much the gear turns when the tip does by 1
  double at_contact = 0;  ///< ψ where it touches the involute
  double gear_angle = 0;  ///< of the gear then: of its tooth's middle, to the same side

  /// The angle at the gear's centre from its tooth's middle to the tip at ψ.
  double from_tooth(double psi) const {
    const double sine = std::sin(0.5 * psi);
    const double beta = std::atan2(tip_radius * std::sin(psi),
                                   centre_distance - tip_radius + 2 * tip_radius * sine * sine);
    return beta - gear_angle - ratio * (psi - at_contact);
  }

  /// |ψ| where the tip is at `radius` from the gear's centre, by half of it so that large gears
  /// lose no digits; not a number if it never is.
  double psi_at(double radius) const {
    const double nearest = centre_distance - tip_radius;
    return 2 * std::asin(std::sqrt((radius - nearest) * (radius + nearest) /
                                   (4 * centre_distance * tip_radius)));
  }
};

TipPath tip_path(const SpurPair& pair, const LineOfAction& line, std::size_t own) {
  const SpurGear& gear = pair.gears[own];
  const SpurGear& other = pair.gears[1 - own];
  const double tip = flank_end_radius(other);
  const double contact = own == 0 ? line.wheel_tip : line.length - line.pinion_tip;
  return {pair.centre_distance, tip, other.teeth / gear.teeth,
          line.pressure_angle - pressure_angle(other, tip),
          contact / base_radius(gear) - base_half_angle(gear) - line.pressure_angle};
}

/// How far the corner of the other gear's tip stays from the fillet of gear `own` (0 or 1) on that
/// flank which touches, as an arc around the centre of `own`: least over the fillet. Negative: the
/// tip digs into the fillet. Infinite where it reaches none of it.
double tip_room(const SpurPair& pair, const LineOfAction& line, int own) {
  constexpr int kSteps = 24;  // crowded towards the form circle, where room is least
  const SpurGear& gear = pair.gears[static_cast<std::size_t>(own)];
  const TipPath path = tip_path(pair, line, static_cast<std::size_t>(own));
  const Fillet fillet = fillet_of(gear);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i * i) / (kSteps * kSteps);
    const double theta = fillet.end + (kRightAngle - fillet.end) * share;
    const double radius = gear.module * fillet.radius(theta);
    const double psi = path.psi_at(radius);
    if (std::isnan(psi)) break;  // the tip does not come as deep
    const double flank = kPi / gear.teeth - fillet.angle(theta);
    const double nearer = std::min(path.from_tooth(psi), path.from_tooth(-psi));
    least = std::min(least, radius * (nearer - flank));
  }
  return least;
}

using Gears = std::array<SpurGear, 2>;

double sum_of_teeth(const Gears& gears) {
  return gears[0].teeth + gears[1].teeth;
}

/// By how much the two teeth together are thinner at the reference circles, in modules.
double sum_of_coarsening(const Gears& gears) {
  return (gears[0].coarsening + gears[1].coarsening) / gears[0].module;
}

/// inv α′ of the pair without backlash.
double involute_without_backlash(const Gears& gears) {
  const double angle = gears[0].rack.pressure_angle;
  const double shifts = gears[0].profile_shift + gears[1].profile_shift;
  return involute(angle) +
         (2 * shifts * std::tan(angle) - sum_of_coarsening(gears)) / sum_of_teeth(gears);
}

/// Zero where it is so to rounding: no overlap is reported for a pair without backlash.
double backlash(const SpurPair& pair, double working_angle) {
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  const double angle = involute(working_angle) - involute_without_backlash(pair.gears);
  return std::abs(angle) <= kRounding ? 0 : 2 * pair.centre_distance * angle;
}

/// 0 of what is rounding: of gears so large that they are nearly racks lengths are no better known.
double if_any(double interference, const SpurPair& pair) {
  constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
  const double slack = 1e-9 * pair.gears[0].module + kRounding * pair.centre_distance;
  return interference > slack ? interference : 0;
}

/// By how much the tip of the other gear reaches beyond what the rack has left of gear `own`. Below
/// the form circle of a gear without undercut there is more than the involute; the involute that
/// undercut has taken away is not in its way. `reached` and `form`: places from the gear's base
/// tangent.
double interference_on_line(const SpurPair& pair, int own, double reached, double form) {
  const SpurGear& gear = pair.gears[own == 0 ? 0 : 1];
  const SpurGear& other = pair.gears[own == 0 ? 1 : 0];
  const double into_root = root_radius(gear) + flank_end_radius(other) - pair.centre_distance;
  const double past_form = is_undercut(gear) ? 0 : form - reached;
  return if_any(std::max(into_root, past_form), pair);
}

/// What the line of action says of a gear, with places on it seen from the gear's own end.
GearInMesh gear_in_mesh(const SpurPair& pair, const LineOfAction& line, int index) {
  const bool is_pinion = index == 0;
  const SpurGear& own = pair.gears[is_pinion ? 0 : 1];
  const SpurGear& other = pair.gears[is_pinion ? 1 : 0];
  const auto place = [&](double pinions, double wheels) {
    return is_pinion ? pinions : line.length - wheels;
  };
  const double reached = place(line.wheel_tip, line.pinion_tip);
  const double start = place(line.start, line.end);
  const double end = place(line.end, line.start);
  const double base = base_radius(own);
  GearInMesh gear;
  gear.working_radius = pair.centre_distance * (own.teeth / (own.teeth + other.teeth));
  gear.interference =
      interference_on_line(pair, index, reached, place(line.pinion_form, line.wheel_form));
  gear.contact_start = std::hypot(base, start);
  gear.contact_end = std::hypot(base, end);
  gear.tip_clearance = pair.centre_distance - flank_end_radius(own) - root_radius(other);
  const auto sliding = [&](double at) {
    return specific_sliding(at, (line.length - at) * own.teeth / other.teeth, own.module);
  };
  gear.sliding_start = sliding(start);
  gear.sliding_end = sliding(end);
  return gear;
}

}  // namespace

double sum_of_base_radii(const Gears& gears) {
  return base_radius(gears[0]) + base_radius(gears[1]);
}

double working_pressure_angle(const SpurPair& pair) {
  const double base = sum_of_base_radii(pair.gears);
  const double a = pair.centre_distance;
  return std::atan2(std::sqrt((a - base) * (a + base)), base);
}

double centre_distance_with_backlash(const Gears& gears, double backlash) {
  // 2 r_b (inv α′ − inv α₀) = j cos α′, where α₀ is that without backlash: from the right of the
  // zero Newton's steps stay there, since the difference of the sides is convex.
  constexpr int kSteps = 40;
  const double base = sum_of_base_radii(gears);
  const double without = involute_without_backlash(gears);
  const double play = 0.5 * backlash / base;
  if (!(without + play >= 0 && play >= 0)) return std::numeric_limits<double>::quiet_NaN();
  double angle = involute_angle(without + play);
  for (int step = 0; play > 0 && step < kSteps; ++step) {
    const double tangent = std::tan(angle);
    const double miss = involute(angle) - without - play * std::cos(angle);
    const double next = angle - miss / (tangent * tangent + play * std::sin(angle));
    if (!(next < angle)) break;
    angle = next;
  }
  return base / std::cos(angle);
}

double centre_distance_without_backlash(const Gears& gears) {
  return centre_distance_with_backlash(gears, 0);
}

double profile_shift_sum(const Gears& gears, double centre_distance, double backlash) {
  const double angle = gears[0].rack.pressure_angle;
  const double working = working_pressure_angle({gears, centre_distance});
  const double difference = involute(working) - involute(angle) - 0.5 * backlash / centre_distance;
  return (difference * sum_of_teeth(gears) + sum_of_coarsening(gears)) / (2 * std::tan(angle));
}

void add_fillet_interference(const SpurPair& pair, PairGeometry& geometry) {
  const LineOfAction line = line_of_action(pair);
  for (std::size_t i = 0; i < 2; ++i) {
    double& most = geometry.gears[i].interference;
    most = std::max(most, if_any(-tip_room(pair, line, static_cast<int>(i)), pair));
  }
}

PairGeometry geometry(const SpurPair& pair) {
  PairGeometry result = geometry_of_line(pair);
  add_fillet_interference(pair, result);
  return result;
}

PairGeometry geometry_of_line(const SpurPair& pair) {
  const LineOfAction line = line_of_action(pair);
  PairGeometry result;
  result.working_pressure_angle = line.pressure_angle;
  result.path_length = line.end - line.start;
  result.contact_ratio = result.path_length / line.base_pitch;
  result.approach = line.pitch_point - line.start;
  result.recess = line.end - line.pitch_point;
  result.backlash = backlash(pair, line.pressure_angle);
  result.normal_backlash = result.backlash * std::cos(line.pressure_angle);
  result.gears = {gear_in_mesh(pair, line, 0), gear_in_mesh(pair, line, 1)};
  result.greatest_sliding_speed =
      std::max(std::abs(result.approach), std::abs(result.recess)) *
      (1 / result.gears[0].working_radius + 1 / result.gears[1].working_radius);
  return result;
}

double balanced_shift(const SpurPair& pair, double least, double greatest) {
  const double sum = pair.gears[0].profile_shift + pair.gears[1].profile_shift;
  const double ratio = pair.gears[0].teeth / pair.gears[1].teeth;
  // That of the pinion's foot less that of the wheel's, times what makes a polynomial of it.
  const auto difference = [&](double shift) {
    SpurPair shifted = pair;
    shifted.gears[0].profile_shift = shift;
    shifted.gears[1].profile_shift = sum - shift;
    const LineOfAction line = line_of_action(shifted);
    const double foot = line.wheel_tip;
    const double head = line.pinion_tip;
    return ratio * ratio * (line.length - foot) * (line.length - head) - foot * head;
  };
  const double at_least = difference(least);
  const double at_greatest = difference(greatest);
  if (!(at_least > 0)) return least;
  if (!(at_greatest < 0)) return greatest;
  return better_end(difference, bracket_zero(difference, least, at_least, greatest, at_greatest));
}

}  // namespace cognate::gear
