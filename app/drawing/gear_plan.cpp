#include "app/drawing/gear_plan.hpp"

#include <cmath>

namespace cognate::app {
namespace {

using gear::OutlinePart;

constexpr double kCentreMark = 0.1;  // half a line of it, of the root radius

bool is_arc(OutlinePart part) {
  return part == OutlinePart::root || part == OutlinePart::tip;
}

/// The angle at the gear's centre from `from` to `to`, less than half a turn.
double angle_between(const Vec2d& centre, const Vec2d& from, const Vec2d& to) {
  const Vec2d a = from - centre, b = to - centre;
  return std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

/// Chords of one arc of the root or tip circle become one arc.
PlanOutline outline_of(const GearOutline& drawn) {
  PlanOutline outline{"OUTLINE", {}, true};
  const auto& points = drawn.points;
  const auto part_after = [&](std::size_t i) { return points[(i + 1) % points.size()].part; };
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (part_after(i) != points[i].part || !is_arc(points[i].part)) corners.push_back(i);
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t i = corners[k], next = corners[(k + 1) % corners.size()];
    const double angle =
        is_arc(part_after(i)) ? angle_between(drawn.gear.centre, points[i].at, points[next].at) : 0;
    outline.corners.push_back({points[i].at, std::tan(angle / 4)});
  }
  return outline;
}

void add_gear(const GearOutline& drawn, Plan& plan) {
  const auto& [name, section, centre, angle, pitch] = drawn.gear;
  plan.outlines.push_back(outline_of(drawn));
  plan.circles.push_back({"BASE_CIRCLE", centre, gear::base_radius(section)});
  plan.circles.push_back({"PITCH_CIRCLE", centre, pitch});
  plan.circles.push_back({"TIP_CIRCLE", centre, gear::tip_radius(section)});
  plan.circles.push_back({"ROOT_CIRCLE", centre, gear::root_radius(section)});
  const double arm = kCentreMark * gear::root_radius(section);
  for (const Vec2d& along : {Vec2d{arm, 0}, Vec2d{0, arm}}) {
    plan.outlines.push_back(plan_line("CENTRE", centre - along, centre + along));
  }
}

}  // namespace

GearOutline gear_outline(const GearPose& gear, double chord_tolerance) {
  GearOutline outline{gear, gear::gear_outline(gear.section, chord_tolerance)};
  const Vec2d turn{std::cos(gear.angle), std::sin(gear.angle)};
  for (auto& point : outline.points) point.at = gear.centre + turn * point.at;
  return outline;
}

Plan gear_plan(const std::vector<GearOutline>& gears, const std::string& title) {
  Plan plan{.title = title.empty() ? "Gears" : title,
            .layers = {{"OUTLINE", PlanColour::foreground},
                       {"BASE_CIRCLE", PlanColour::grey, true},
                       {"PITCH_CIRCLE", PlanColour::accent, true},
                       {"TIP_CIRCLE", PlanColour::grey, true},
                       {"ROOT_CIRCLE", PlanColour::grey, true},
                       {"CENTRE", PlanColour::red}}};
  for (const auto& outline : gears) add_gear(outline, plan);
  fit_to_shapes(plan);
  return plan;
}

}  // namespace cognate::app
