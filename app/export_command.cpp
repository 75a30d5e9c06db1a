#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "app/commands.hpp"
#include "app/export/curve_table.hpp"
#include "app/export/dxf.hpp"
#include "app/export/result_cam.hpp"
#include "app/export/svg.hpp"
#include "app/messages.hpp"
#include "app/output_files.hpp"
#include "app/result_json.hpp"
#include "app/terminal.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

struct ExportedFile {
  std::string name;
  std::string text;
};

/// NAME of NAME.result.json, followed by the curve where that is not the profile.
std::string stem_of(const fs::path& file, ExportedCurve curve) {
  const fs::path stem = file.stem();
  std::string name = stem.extension() == ".result" ? stem.stem().string() : stem.string();
  if (curve == ExportedCurve::pitch) name += ".pitch";
  if (curve == ExportedCurve::cutter) name += ".cutter";
  return name;
}

/// One file, but of a table one for each curve.
std::vector<ExportedFile> exported_files(const CamDrawing& drawing, ExportFormat format,
                                         const std::string& stem) {
  switch (format) {
    case ExportFormat::dxf:
      return {{stem + ".dxf", dxf_text(drawing)}};
    case ExportFormat::svg:
      return {{stem + ".svg", svg_text(drawing)}};
    default:
      break;
  }
  std::vector<ExportedFile> files;
  for (const auto& curve : drawing.curves) {
    files.push_back(
        {stem + (curve.name.empty() ? "" : "." + curve.name) + ".csv", csv_text(curve)});
  }
  return files;
}

FileResult write_files(const fs::path& folder, const std::vector<ExportedFile>& files) {
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.name);
  auto written = prepare_folder(folder, names);
  for (std::size_t i = 0; written && i < files.size(); ++i) {
    written = write_file(folder / files[i].name, files[i].text);
  }
  return written;
}

std::size_t point_count(const CamDrawing& drawing) {
  std::size_t count = 0;
  for (const auto& curve : drawing.curves) count += curve.points.size();
  return count;
}

nlohmann::ordered_json export_document(const fs::path& file, const CamDrawing& drawing,
                                       const std::vector<std::string>& paths) {
  return {{"format", "cognate-export/1"},
          {"result", file.string()},
          {"files", paths},
          {"points", point_count(drawing)},
          {"chord_tolerance", drawing.chord_tolerance},
          {"notes", drawing.notes}};
}

ExitStatus complain_that(const std::string& what) {
  complain(what);
  return exit_bad_input;
}

}  // namespace

ExitStatus export_command(const fs::path& file, const ExportOptions& exporting,
                          const Options& options) {
  const auto given = read_result_cam(file, exporting.design);
  if (!given) {
    write_standard_error(printable(given.error()) + '\n');
    return exit_bad_input;
  }
  const auto drawing = cam_drawing(given->problem, given->design, exporting.order);
  if (!drawing) return complain_that(drawing.error());
  const auto files =
      exported_files(*drawing, exporting.format, stem_of(file, exporting.order.kind));
  const fs::path folder = options.out.value_or(".");
  if (const auto written = write_files(folder, files); !written) {
    return complain_that(written.error());
  }
  std::vector<std::string> paths;
  for (const auto& made : files) paths.push_back((folder / made.name).lexically_normal().string());
  if (options.json) return print(write_json(export_document(file, *drawing, paths)));
  for (const auto& note : drawing->notes) complain("note: " + note);
  if (options.quiet) return exit_done;
  std::string text;
  for (const auto& path : paths) text += "wrote " + printable(path) + '\n';
  return print(text + fmt::format("{} points, nowhere farther than {:.3g} from the curve\n",
                                  point_count(*drawing), drawing->chord_tolerance));
}

}  // namespace cognate::app
