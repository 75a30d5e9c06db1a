#include <fmt/core.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "app/documents/json_values.hpp"
#include "app/documents/result_json.hpp"
#include "app/drawing/gear_plan.hpp"
#include "app/export/dxf.hpp"
#include "app/export/export_solids.hpp"
#include "app/export/exported.hpp"
#include "app/export/gear_sheet.hpp"
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

/// Corners with the bulges of DXF.
ordered_json corners_json(const PlanOutline& outline) {
  ordered_json corners = ordered_json::array();
  for (const auto& [at, bulge] : outline.corners) corners.push_back({at.x, at.y, bulge});
  return corners;
}

/// The document `cognate-gears/1`.
std::string gears_document(const ResultGears& given, const GearSheet& sheet, double tolerance) {
  ordered_json document = {{"format", "cognate-gears/1"},
                           {"title", given.title},
                           {"gearing", given.gearing},
                           {"chord_tolerance", tolerance},
                           {"gears", ordered_json::array()}};
  if (given.length_unit) document["length_unit"] = to_string(*given.length_unit);
  if (sheet.kerf > 0) document["kerf"] = sheet.kerf;
  for (std::size_t i = 0; i < sheet.outlines.size(); ++i) {
    ordered_json entry = gear_entry(sheet.outlines[i]);
    if (const auto bore = bore_json(sheet.bores[i]); !bore.empty()) entry.update(bore);
    if (sheet.kerf > 0) entry["cut_outline"] = corners_json(sheet.plan.outlines[sheet.cuts[i]]);
    document["gears"].push_back(std::move(entry));
  }
  return write_json(document);
}

std::vector<ExportedFile> files_of(const ResultGears& given, const GearSheet& sheet,
                                   double tolerance, const ExportOptions& wanted,
                                   const std::string& stem) {
  switch (wanted.format) {
    case ExportFormat::dxf:
      return {{stem + ".dxf", dxf_text(sheet.plan, wanted.version)}};
    case ExportFormat::svg:
      return {{stem + ".svg", svg_text(sheet.plan)}};
    case ExportFormat::json:
      return {{stem + ".gears.json", gears_document(given, sheet, tolerance)}};
    default:
      break;
  }
  std::vector<ExportedFile> files;
  for (const auto& outline : sheet.outlines) {
    std::string name = stem;
    if (!outline.gear.name.empty()) name.append(".").append(outline.gear.name);
    files.push_back({name.append(".csv"), outline_csv(outline, length_word(given.length_unit))});
  }
  return files;
}

constexpr double kRingRim = 2;  // modules outside the roots

/// By which the teeth turn about the axis over `thickness`.
double twist_of(const GearPose& gear, double thickness) {
  return thickness * std::tan(gear.helix) / gear::reference_radius(gear.section);
}

/// Why so wide a gear is no solid: its faces would be screws of many turns.
std::optional<std::string> too_twisted(const GearPose& gear, double thickness) {
  const double twist = std::abs(twist_of(gear, thickness));
  if (twist <= kTurn) return std::nullopt;
  return fmt::format(
      "--thickness: over {:.6g} the helical teeth turn {:.3g} times about the axis; allowed is "
      "once, at most {:.6g}",
      thickness, twist / kTurn, thickness * kTurn / twist);
}

WheelSolid wheel_of(const GearOutline& drawn, const PlanOutline& outline, const WheelBore& bore,
                    double thickness) {
  const GearPose& gear = drawn.gear;
  const Vec2d centre = gear.rack ? Vec2d{} : gear.centre;
  SolidLoop loop{outline.corners};
  for (PlanCorner& corner : loop.corners) corner.at = corner.at - centre;
  WheelSolid wheel{.name = gear.name.empty() ? "gear" : gear.name,
                   .outline = loop,
                   .centre = centre,
                   .direction = {std::cos(gear.angle), std::sin(gear.angle)},
                   .bore = bore,
                   .twist = twist_of(gear, thickness)};
  if (gear.ring) {
    const double rim = kRingRim * gear.section.module;
    wheel.outline = circle_loop({}, gear::root_radius(*gear.ring) + rim);
    wheel.hollow = loop;
  }
  return wheel;
}

tl::expected<Exported, std::string> gear_solids(const ResultGears& given, const GearSheet& sheet,
                                                ExportOptions wanted, const std::string& stem,
                                                double tolerance) {
  if (!wanted.thickness) wanted.thickness = given.face_width;
  const double thickness = wanted.thickness.value_or(0);
  SolidAssembly assembly =
      empty_assembly(given.title.empty() ? stem : given.title, given.length_unit);
  assembly.chord_tolerance = tolerance;
  for (std::size_t i = 0; i < sheet.outlines.size(); ++i) {
    const GearOutline& drawn = sheet.outlines[i];
    if (auto why = too_twisted(drawn.gear, thickness)) return tl::unexpected(*std::move(why));
    auto solid = wheel_solid(
        wheel_of(drawn, sheet.plan.outlines[sheet.cuts[i]], sheet.bores[i], thickness), wanted);
    if (!solid) return tl::unexpected(solid.error());
    assembly.solids.push_back(*std::move(solid));
  }
  auto made = export_solids(assembly, wanted, stem);
  if (!made) return made;
  made->notes = given.notes;
  if (!given.length_unit) made->notes.emplace_back(kMillimetresAssumed);
  if (given.gears.back().ring) {
    made->notes.emplace_back("the rim of the ring is two modules thick");
  }
  return made;
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
        "{}: is for {}; of gears --design, --chord-tolerance, --dxf-version, --kerf, --bore, "
        "--keyway, --hub, --hub-length and --thickness are allowed",
        *option, of));
  }
  const auto tolerance = tolerance_of(given, wanted);
  if (!tolerance) return tl::unexpected(tolerance.error());
  const auto sheet = gear_sheet(given, wanted.kerf, wanted.wheel, *tolerance);
  if (!sheet) return tl::unexpected(sheet.error());
  if (declaration(wanted.format).is_solid()) {
    return gear_solids(given, *sheet, wanted, stem, *tolerance);
  }
  std::size_t points = 0;
  for (const auto& outline : sheet->outlines) points += outline.points.size();
  ordered_json quantities = {{"points", points}, {"chord_tolerance", *tolerance}};
  if (wanted.kerf > 0) quantities["kerf"] = wanted.kerf;
  return Exported{
      files_of(given, *sheet, *tolerance, wanted, stem), given.notes,
      fmt::format("{} points, nowhere farther than {:.3g} from the curve", points, *tolerance),
      std::move(quantities)};
}

}  // namespace cognate::app
