#include <fmt/core.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "app/documents/json_values.hpp"
#include "app/documents/result_json.hpp"
#include "app/drawing/gear_plan.hpp"
#include "app/export/dxf.hpp"
#include "app/export/exported.hpp"
#include "app/export/svg.hpp"
#include "problems/basics/degrees.hpp"

namespace cognate::app {
namespace {

using gear::OutlinePart;
using nlohmann::ordered_json;

// Of the module.
constexpr double kDefaultGearTolerance = 1e-3, kLeastGearTolerance = 1e-5,
                 kGreatestGearTolerance = 0.1;

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

/// The tolerance asked for, or what is wrong with it.
tl::expected<double, std::string> tolerance_of(const ResultGears& given,
                                               const ExportOptions& wanted) {
  const double module = given.gears.front().section.module;
  const double tolerance = wanted.chord_tolerance.value_or(kDefaultGearTolerance * module);
  const double least = kLeastGearTolerance * module, greatest = kGreatestGearTolerance * module;
  if (least <= tolerance && tolerance <= greatest) return tolerance;
  return tl::unexpected(
      fmt::format("--chord-tolerance: {} is not possible for a module of {:.6g}; allowed is a "
                  "length from {:.3g} to {:.6g}",
                  tolerance, module, least, greatest));
}

/// Rows of x, y, radius about the gear's own centre, of a rack the height above its reference line,
/// and the part that the chord to the point stands for: root, fillet, involute, tip.
std::string outline_csv(const GearOutline& outline, std::string_view length) {
  const std::string unit = length.empty() ? "" : "_" + std::string(length);
  const auto& rack = outline.gear.rack;
  std::string text = fmt::format("x{0},y{0},{1}{0},part\r\n", unit, rack ? "height" : "radius");
  for (const auto& [at, part] : outline.points) {
    const double third = rack ? at.y - rack->distance : norm(at - outline.gear.centre);
    fmt::format_to(std::back_inserter(text), "{},{},{},{}\r\n", at.x, at.y, third, name_of(part));
  }
  return text;
}

ordered_json outline_json(const GearOutline& drawn) {
  ordered_json outline = ordered_json::array();
  for (const auto& [at, part] : drawn.points) outline.push_back({at.x, at.y, name_of(part)});
  return outline;
}

/// A rack's lines and its outline.
ordered_json rack_entry(const GearOutline& drawn) {
  const GearPose& gear = drawn.gear;
  return {{"name", gear.name},
          {"module", gear.section.module},
          {"reference_line_y", gear.rack->distance},
          {"pitch_line_y", gear.pitch_radius},
          {"outline", outline_json(drawn)}};
}

/// A gear's circles, its place and its outline.
ordered_json gear_entry(const GearOutline& drawn) {
  if (drawn.gear.rack) return rack_entry(drawn);
  const GearPose& gear = drawn.gear;
  const auto& ring = gear.ring;
  ordered_json entry = ordered_json::object();
  if (!gear.name.empty()) entry["name"] = gear.name;
  entry.update({{"teeth", static_cast<int>(gear.section.teeth)},
                {"transverse_module", gear.section.module},
                {"base_radius", gear::base_radius(gear.section)},
                {"pitch_radius", gear.pitch_radius},
                {"form_radius", ring ? gear::form_radius(*ring) : gear::form_radius(gear.section)},
                {"tip_radius", ring ? gear::tip_radius(*ring) : gear::tip_radius(gear.section)},
                {"root_radius", ring ? gear::root_radius(*ring) : gear::root_radius(gear.section)},
                {"centre", {gear.centre.x, gear.centre.y}},
                {"turned_deg", problems::degrees(gear.angle)},
                {"outline", outline_json(drawn)}});
  return entry;
}

/// The document `cognate-gears/1`.
std::string gears_document(const ResultGears& given, const std::vector<GearOutline>& outlines,
                           double tolerance) {
  ordered_json document = {{"format", "cognate-gears/1"},
                           {"title", given.title},
                           {"gearing", given.gearing},
                           {"chord_tolerance", tolerance},
                           {"gears", ordered_json::array()}};
  if (given.length_unit) document["length_unit"] = to_string(*given.length_unit);
  for (const auto& outline : outlines) document["gears"].push_back(gear_entry(outline));
  return write_json(document);
}

Plan plan_of(const ResultGears& given, const std::vector<GearOutline>& outlines) {
  Plan plan = gear_plan(outlines, given.title);
  plan.length_unit = given.length_unit;
  return plan;
}

std::vector<ExportedFile> files_of(const ResultGears& given,
                                   const std::vector<GearOutline>& outlines, double tolerance,
                                   const ExportOptions& wanted, const std::string& stem) {
  switch (wanted.format) {
    case ExportFormat::dxf:
      return {{stem + ".dxf", dxf_text(plan_of(given, outlines), wanted.version)}};
    case ExportFormat::svg:
      return {{stem + ".svg", svg_text(plan_of(given, outlines))}};
    case ExportFormat::json:
      return {{stem + ".gears.json", gears_document(given, outlines, tolerance)}};
    default:
      break;
  }
  std::vector<ExportedFile> files;
  for (const auto& outline : outlines) {
    std::string name = stem;
    if (!outline.gear.name.empty()) name.append(".").append(outline.gear.name);
    files.push_back({name.append(".csv"), outline_csv(outline, length_word(given.length_unit))});
  }
  return files;
}

}  // namespace

tl::expected<Exported, std::string> export_gears(const ResultGears& given,
                                                 const ExportOptions& wanted,
                                                 const std::string& stem) {
  if (!declaration(wanted.format).of_gears) {
    return tl::unexpected(refused_format(&FormatDeclaration::of_gears, "gears"));
  }
  for (const auto& [option, of] :
       {std::pair(&wanted.of_linkages, "linkages"), std::pair(&wanted.of_cams, "cams")}) {
    if (option->empty()) continue;
    return tl::unexpected(fmt::format(
        "{}: is for {}; of gears --design, --chord-tolerance and --dxf-version are allowed",
        *option, of));
  }
  const auto tolerance = tolerance_of(given, wanted);
  if (!tolerance) return tl::unexpected(tolerance.error());
  std::vector<GearOutline> outlines;
  std::size_t points = 0;
  for (const auto& gear : given.gears) {
    outlines.push_back(gear_outline(gear, *tolerance));
    points += outlines.back().points.size();
  }
  return Exported{
      files_of(given, outlines, *tolerance, wanted, stem),
      given.notes,
      fmt::format("{} points, nowhere farther than {:.3g} from the curve", points, *tolerance),
      {{"points", points}, {"chord_tolerance", *tolerance}}};
}

}  // namespace cognate::app
