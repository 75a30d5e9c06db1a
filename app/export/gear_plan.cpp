#include "app/export/gear_plan.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/documents/json_values.hpp"
#include "app/documents/result_json.hpp"
#include "problems/basics/degrees.hpp"

namespace cognate::app {
namespace {

using gear::OutlinePart;
using nlohmann::ordered_json;

constexpr double kDefaultGearTolerance = 1e-3;  // of the module
constexpr double kLeastGearTolerance = 1e-5, kGreatestTolerance = 0.1;
constexpr double kCentreMark = 0.1;  // half a line of it, of the root radius

const char* name_of(OutlinePart part) {
  switch (part) {
    case OutlinePart::root:
      return "root";
    case OutlinePart::fillet:
      return "fillet";
    case OutlinePart::involute:
      return "involute";
    case OutlinePart::tip:
      return "tip";
  }
  return "";
}

bool is_arc(OutlinePart part) {
  return part == OutlinePart::root || part == OutlinePart::tip;
}

DrawnGear drawn(const PlacedGear& gear, double tolerance) {
  DrawnGear made{gear, gear::gear_outline(gear.section, tolerance)};
  const Vec2d turn{std::cos(gear.angle), std::sin(gear.angle)};
  for (auto& point : made.points) point.at = gear.centre + turn * point.at;
  return made;
}

/// The angle at the gear's centre from `from` to `to`, less than half a turn.
double angle_between(const Vec2d& centre, const Vec2d& from, const Vec2d& to) {
  const Vec2d a = from - centre, b = to - centre;
  return std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

/// Chords of one arc of the root or tip circle become one arc.
PlanOutline outline_of(const DrawnGear& drawn) {
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

void add_gear(const DrawnGear& drawn, Plan& plan) {
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

tl::expected<GearDrawing, std::string> gear_drawing(const ResultGears& given,
                                                    std::optional<double> chord_tolerance) {
  const double module = given.gears.front().section.module;
  const double tolerance = chord_tolerance.value_or(kDefaultGearTolerance * module);
  if (!(tolerance >= kLeastGearTolerance * module && tolerance <= kGreatestTolerance * module)) {
    return tl::unexpected(
        fmt::format("--chord-tolerance: {} is not possible for a module of {:.6g}; allowed is a "
                    "length from {:.3g} to {:.6g}",
                    tolerance, module, kLeastGearTolerance * module, kGreatestTolerance * module));
  }
  GearDrawing drawing{given.title, tolerance, {}};
  for (const auto& gear : given.gears) drawing.gears.push_back(drawn(gear, tolerance));
  return drawing;
}

Plan gear_plan(const GearDrawing& drawing) {
  Plan plan{.title = drawing.title.empty() ? "Gears" : drawing.title,
            .layers = {{"OUTLINE", PlanColour::foreground},
                       {"BASE_CIRCLE", PlanColour::grey, true},
                       {"PITCH_CIRCLE", PlanColour::accent, true},
                       {"TIP_CIRCLE", PlanColour::grey, true},
                       {"ROOT_CIRCLE", PlanColour::grey, true},
                       {"CENTRE", PlanColour::red}}};
  for (const auto& drawn : drawing.gears) add_gear(drawn, plan);
  fit_to_shapes(plan);
  return plan;
}

std::string csv_text(const DrawnGear& gear) {
  std::string text = "x,y,radius,part\r\n";
  for (const auto& [at, part] : gear.points) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{}\r\n", at.x, at.y,
                   norm(at - gear.gear.centre), name_of(part));
  }
  return text;
}

std::string gears_document(const ResultGears& given, const GearDrawing& drawing) {
  ordered_json document = {{"format", "cognate-gears/1"},
                           {"title", given.title},
                           {"gearing", given.gearing},
                           {"chord_tolerance", drawing.chord_tolerance},
                           {"gears", ordered_json::array()}};
  for (const auto& [gear, points] : drawing.gears) {
    ordered_json outline = ordered_json::array();
    for (const auto& [at, part] : points) outline.push_back({at.x, at.y, name_of(part)});
    ordered_json entry = ordered_json::object();
    if (!gear.name.empty()) entry["name"] = gear.name;
    entry.update({{"teeth", static_cast<int>(gear.section.teeth)},
                  {"transverse_module", gear.section.module},
                  {"base_radius", gear::base_radius(gear.section)},
                  {"pitch_radius", gear.pitch_radius},
                  {"form_radius", gear::form_radius(gear.section)},
                  {"tip_radius", gear::tip_radius(gear.section)},
                  {"root_radius", gear::root_radius(gear.section)},
                  {"centre", {gear.centre.x, gear.centre.y}},
                  {"turned_deg", problems::degrees(gear.angle)},
                  {"outline", outline}});
    document["gears"].push_back(entry);
  }
  return write_json(document);
}

}  // namespace cognate::app
