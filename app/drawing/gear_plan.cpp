#include "app/drawing/gear_plan.hpp"

#include <algorithm>
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
    const bool bends = is_arc(points[i].part) && !drawn.gear.rack;
    if (part_after(i) != points[i].part || !bends) corners.push_back(i);
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t i = corners[k], next = corners[(k + 1) % corners.size()];
    const bool bends = is_arc(part_after(i)) && !drawn.gear.rack;
    const double angle =
        bends ? angle_between(drawn.gear.centre, points[i].at, points[next].at) : 0;
    outline.corners.push_back({points[i].at, std::tan(angle / 4)});
  }
  return outline;
}

/// Half as long as the teeth of a rack that are drawn.
double rack_reach(const GearPose& gear) {
  return 0.5 * kRackTeeth * kPi * gear.section.module;
}

/// The teeth from left to right, then the body's far edge.
std::vector<gear::OutlinePoint> rack_outline(const GearPose& gear) {
  constexpr OutlinePart kParts[] = {OutlinePart::root, OutlinePart::root,     OutlinePart::involute,
                                    OutlinePart::tip,  OutlinePart::involute, OutlinePart::root};
  constexpr double kBody = 2;  // in modules, above the roots
  const auto tooth = gear::rack_tooth(*gear.rack);
  const double module = gear.section.module, pitch = kPi * module;
  const Vec2d foot{gear.offset, gear.rack->distance};
  std::vector<gear::OutlinePoint> points;
  for (int k = 0; k < kRackTeeth; ++k) {
    const Vec2d middle = foot + Vec2d{(k - 0.5 * (kRackTeeth - 1)) * pitch, 0};
    for (std::size_t i = k == 0 ? 0 : 1; i < tooth.size(); ++i) {
      points.push_back({middle + tooth[i], kParts[i]});
    }
  }
  const double edge = foot.y + tooth.front().y + kBody * module;
  points.push_back({{points.back().at.x, edge}, OutlinePart::root});
  points.push_back({{points.front().at.x, edge}, OutlinePart::root});
  return points;
}

void add_rack(const GearOutline& drawn, Plan& plan) {
  const double reach = rack_reach(drawn.gear), height = gear::reference_radius(drawn.gear.section);
  const Vec2d foot{drawn.gear.offset, height};
  plan.outlines.push_back(outline_of(drawn));
  plan.outlines.push_back(
      plan_line("PITCH_CIRCLE", foot - Vec2d{reach, 0}, foot + Vec2d{reach, 0}));
}

void add_gear(const GearOutline& drawn, Plan& plan) {
  if (drawn.gear.rack) return add_rack(drawn, plan);
  const GearPose& own = drawn.gear;
  const gear::SpurGear& section = own.section;
  const Vec2d centre = own.centre;
  const double tip = own.ring ? gear::tip_radius(*own.ring) : gear::tip_radius(section);
  const double root = own.ring ? gear::root_radius(*own.ring) : gear::root_radius(section);
  plan.outlines.push_back(outline_of(drawn));
  plan.circles.push_back({"BASE_CIRCLE", centre, gear::base_radius(section)});
  plan.circles.push_back({"PITCH_CIRCLE", centre, own.pitch_radius});
  plan.circles.push_back({"TIP_CIRCLE", centre, tip});
  plan.circles.push_back({"ROOT_CIRCLE", centre, root});
  const double arm = kCentreMark * std::min(tip, root);
  for (const Vec2d& along : {Vec2d{arm, 0}, Vec2d{0, arm}}) {
    plan.outlines.push_back(plan_line("CENTRE", centre - along, centre + along));
  }
}

}  // namespace

GearOutline gear_outline(const GearPose& gear, double chord_tolerance) {
  if (gear.rack) return {gear, rack_outline(gear)};
  GearOutline outline{gear, gear.ring ? gear::ring_outline(*gear.ring, chord_tolerance)
                                      : gear::gear_outline(gear.section, chord_tolerance)};
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
