#include <fmt/core.h>

#include "app/export/cam_plan.hpp"
#include "app/export/curve_table.hpp"
#include "app/export/exported.hpp"
#include "app/export/svg.hpp"

namespace cognate::app {
namespace {

std::string named_after_curve(std::string name, ExportedCurve curve) {
  if (curve == ExportedCurve::pitch) name += ".pitch";
  if (curve == ExportedCurve::cutter) name += ".cutter";
  return name;
}

std::vector<ExportedFile> files_of(const CamDrawing& drawing, const std::string& title,
                                   const ExportOptions& wanted, const std::string& stem) {
  if (wanted.format == ExportFormat::dxf) {
    return {{stem + ".dxf", dxf_text(cam_plan(drawing, title), wanted.version)}};
  }
  if (wanted.format == ExportFormat::svg) {
    return {{stem + ".svg", svg_text(cam_plan(drawing, title))}};
  }
  std::vector<ExportedFile> files;
  for (const auto& curve : drawing.curves) {
    files.push_back(
        {stem + (curve.name.empty() ? "" : "." + curve.name) + ".csv", csv_text(curve)});
  }
  return files;
}

std::size_t point_count(const CamDrawing& drawing) {
  std::size_t count = 0;
  for (const auto& curve : drawing.curves) count += curve.points.size();
  return count;
}

}  // namespace

tl::expected<Exported, std::string> export_cam(const ResultCam& given, const ExportOptions& wanted,
                                               const std::string& stem) {
  if (wanted.format == ExportFormat::json || wanted.format == ExportFormat::dot) {
    return tl::unexpected(
        std::string("--format: json and dot are for linkages; of a cam dxf, svg or csv is "
                    "allowed"));
  }
  if (!wanted.of_linkages.empty()) {
    return tl::unexpected(wanted.of_linkages +
                          ": is for linkages; of a cam --curve and --cutter-radius are allowed");
  }
  const auto drawing = cam_drawing(given.problem, given.design, wanted.order);
  if (!drawing) return tl::unexpected(drawing.error());
  const std::size_t points = point_count(*drawing);
  return Exported{
      files_of(*drawing, given.problem.title, wanted, named_after_curve(stem, wanted.order.kind)),
      drawing->notes,
      fmt::format("{} points, nowhere farther than {:.3g} from the curve", points,
                  drawing->chord_tolerance),
      {{"points", points}, {"chord_tolerance", drawing->chord_tolerance}}};
}

}  // namespace cognate::app
