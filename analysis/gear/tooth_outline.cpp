#include "analysis/gear/tooth_outline.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/gear/chords.hpp"
#include "analysis/gear/fillet.hpp"
#include "analysis/gear/involute.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::gear {
namespace {

/// The point at `radius`, `angle` counter-clockwise of the y axis.
Vec2d polar(double radius, double angle) {
  return {-radius * std::sin(angle), radius * std::cos(angle)};
}

/// The corner of the rack's tip, relative to the middle of its tooth on the pitch line, from the
/// straight flank at the right of the tooth (θ = α) to the tip line (π/2).
Vec2d corner_point(const Fillet& fillet, double depth_of_pitch_line, double theta) {
  return {fillet.centre.x + fillet.corner_radius * std::cos(theta),
          fillet.centre.y - depth_of_pitch_line - fillet.corner_radius * std::sin(theta)};
}

/// The right half of a tooth of the rack in modules, from the tip's middle up.
std::vector<Vec2d> rack_tooth_half(const SpurGear& gear, double tolerance) {
  const Fillet fillet = fillet_of(gear);
  const double slope = std::tan(gear.rack.pressure_angle);
  const auto corner = [&](double theta) { return corner_point(fillet, gear.profile_shift, theta); };
  std::vector<OutlinePoint> points;
  if (fillet.centre.x > 0) points.push_back({corner(kRightAngle), OutlinePart::root});
  append_curve(points, OutlinePart::fillet, corner, kRightAngle, gear.rack.pressure_angle,
               tolerance);
  const double half_width = kPi / 4 + 0.5 * gear.coarsening / gear.module;
  const double height =
      std::min(gear.rack.addendum + gear.rack.clearance, (kRightAngle - half_width) / slope);
  std::vector<Vec2d> half;
  for (const OutlinePoint& point : points) half.push_back(point.at);
  half.push_back({half_width + height * slope, height});
  return half;
}

}  // namespace

std::vector<OutlinePoint> tooth_half(const SpurGear& gear, double tolerance) {
  if (!(tolerance > 0) || tooth_fault(gear) != ToothFault::none) return {};
  const Fillet fillet = fillet_of(gear);
  const double half_pitch = kPi / gear.teeth;
  const double root = root_radius(gear);
  const double base = base_radius(gear);
  const double tip = flank_end_radius(gear);
  const double base_angle = base_half_angle(gear);
  const auto arc_of = [](double radius) {
    return [radius](double angle) { return polar(radius, angle); };
  };
  const auto fillet_point = [&](double theta) {
    return polar(gear.module * fillet.radius(theta), half_pitch - fillet.angle(theta));
  };
  // By the tangent of the pressure angle, which is the angle by which the involute has unwound.
  const auto involute_point = [&](double tangent) {
    return polar(base * std::hypot(1.0, tangent), base_angle - tangent + std::atan(tangent));
  };
  const double root_angle = half_pitch - fillet.angle(kRightAngle);
  const double foot_tangent = form_tangent(gear) / base;
  const double tip_tangent = std::tan(pressure_angle(gear, tip));
  const double tip_angle = base_angle - tip_tangent + std::atan(tip_tangent);

  std::vector<OutlinePoint> points{{polar(root, half_pitch), OutlinePart::root}};
  if (root_angle < half_pitch) {
    append_curve(points, OutlinePart::root, arc_of(root), half_pitch, root_angle, tolerance);
  }
  append_curve(points, OutlinePart::fillet, fillet_point, kRightAngle, fillet.end, tolerance);
  append_curve(points, OutlinePart::involute, involute_point, foot_tangent, tip_tangent, tolerance);
  if (tip < pointed_radius(gear)) {
    append_curve(points, OutlinePart::tip, arc_of(tip), tip_angle, 0, tolerance);
  }
  points.back().at.x = 0;
  return points;
}

std::vector<OutlinePoint> gear_outline(const SpurGear& gear, double tolerance) {
  return whole_outline(tooth_half(gear, tolerance), gear.teeth);
}

std::vector<OutlinePoint> whole_outline(const std::vector<OutlinePoint>& half, double whole_teeth) {
  std::vector<OutlinePoint> tooth;
  for (const OutlinePoint& point : half) tooth.push_back({-conj(point.at), point.part});
  // Down again at the left; the root's middle there begins the next tooth.
  for (std::size_t i = half.size(); i-- > 2;) tooth.push_back({half[i - 1].at, half[i].part});
  std::vector<OutlinePoint> outline;
  const int teeth = half.empty() ? 0 : static_cast<int>(std::lround(whole_teeth));
  outline.reserve(tooth.size() * static_cast<std::size_t>(teeth));
  for (int k = 0; k < teeth; ++k) {
    const double angle = kTurn * k / teeth;
    const Vec2d turn = unit_vector(angle);
    for (const OutlinePoint& point : tooth) outline.push_back({turn * point.at, point.part});
  }
  return outline;
}

std::vector<Vec2d> rack_outline(const SpurGear& gear, double angle, int teeth, double tolerance) {
  const std::vector<Vec2d> half = rack_tooth_half(gear, tolerance / gear.module);
  const double pitch = kPi;
  const double pitch_line = 0.5 * gear.teeth + gear.profile_shift;
  std::vector<Vec2d> outline;
  for (int k = -teeth; k < teeth; ++k) {
    const double middle = (k + 0.5) * pitch - 0.5 * gear.teeth * angle;
    const auto place = [&](double x, double y) {
      outline.push_back(gear.module * Vec2d{middle + x, pitch_line + y});
    };
    for (std::size_t i = half.size(); i-- > 0;) place(-half[i].x, half[i].y);
    for (const Vec2d& point : half) place(point.x, point.y);
  }
  return outline;
}

}  // namespace cognate::gear
