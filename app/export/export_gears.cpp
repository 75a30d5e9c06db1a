#include <fmt/core.h>

#include "app/export/dxf.hpp"
#include "app/export/exported.hpp"
#include "app/export/gear_plan.hpp"
#include "app/export/svg.hpp"

namespace cognate::app {
namespace {

std::vector<ExportedFile> files_of(const ResultGears& given, const GearDrawing& drawing,
                                   const ExportOptions& wanted, const std::string& stem) {
  switch (wanted.format) {
    case ExportFormat::dxf:
      return {{stem + ".dxf", dxf_text(gear_plan(drawing), wanted.version)}};
    case ExportFormat::svg:
      return {{stem + ".svg", svg_text(gear_plan(drawing))}};
    case ExportFormat::json:
      return {{stem + ".gears.json", gears_document(given, drawing)}};
    default:
      break;
  }
  std::vector<ExportedFile> files;
  for (const auto& drawn : drawing.gears) {
    std::string name = stem;
    if (!drawn.gear.name.empty()) name.append(".").append(drawn.gear.name);
    files.push_back({name.append(".csv"), csv_text(drawn)});
  }
  return files;
}

}  // namespace

tl::expected<Exported, std::string> export_gears(const ResultGears& given,
                                                 const ExportOptions& wanted,
                                                 const std::string& stem) {
  if (wanted.format == ExportFormat::dot) {
    return tl::unexpected(
        std::string("--format: dot is for linkages; of gears dxf, svg, csv or json is allowed"));
  }
  for (const auto& [option, of] :
       {std::pair(&wanted.of_linkages, "linkages"), std::pair(&wanted.of_cams, "cams")}) {
    if (option->empty()) continue;
    return tl::unexpected(fmt::format(
        "{}: is for {}; of gears --design, --chord-tolerance and --dxf-version are allowed",
        *option, of));
  }
  const auto drawing = gear_drawing(given, wanted.order.chord_tolerance);
  if (!drawing) return tl::unexpected(drawing.error());
  std::size_t points = 0;
  for (const auto& drawn : drawing->gears) points += drawn.points.size();
  return Exported{files_of(given, *drawing, wanted, stem),
                  given.notes,
                  fmt::format("{} points, nowhere farther than {:.3g} from the curve", points,
                              drawing->chord_tolerance),
                  {{"points", points}, {"chord_tolerance", drawing->chord_tolerance}}};
}

}  // namespace cognate::app
