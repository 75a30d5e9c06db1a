#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/computation.hpp"
#include "app/commands/export_design.hpp"
#include "app/console/messages.hpp"
#include "app/console/terminal.hpp"
#include "app/documents/output_files.hpp"
#include "app/documents/result_json.hpp"
#include "app/export/exported.hpp"
#include "app/export/toml_text.hpp"
#include "app/kinds/kinds.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

using nlohmann::ordered_json;

FileResult write_files(const fs::path& folder, const std::vector<ExportedFile>& files) {
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.name);
  auto written = prepare_folder(folder, names);
  for (std::size_t i = 0; written && i < files.size(); ++i) {
    written = write_file(folder / files[i].name, files[i].text);
  }
  return written;
}

ordered_json export_document(const fs::path& file, const Exported& made,
                             const std::vector<std::string>& paths) {
  ordered_json document = {
      {"format", "cognate-export/1"}, {"result", file.string()}, {"files", paths}};
  document.update(made.quantities);
  document["notes"] = made.notes;
  return document;
}

ExitStatus complain_that(const std::string& what) {
  complain(what);
  return exit_bad_input;
}

ExitStatus write_and_tell(const fs::path& file, const Exported& made, const Options& options) {
  const fs::path folder = options.out.value_or(".");
  if (const auto written = write_files(folder, made.files); !written) {
    return complain_that(written.error());
  }
  std::vector<std::string> paths;
  for (const auto& each : made.files) {
    paths.push_back((folder / each.name).lexically_normal().string());
  }
  if (options.json) return print(write_json(export_document(file, made, paths)));
  for (const auto& note : made.notes) complain("note: " + note);
  if (options.quiet) return exit_done;
  std::string text;
  for (const auto& path : paths) text += "wrote " + printable(path) + '\n';
  return print(text + made.summary + '\n');
}

/// The file NAME.designN.toml, for `cognate analyze`.
ExportOutcome analysis_file(const ResultDesign& design, const ExportOptions& exporting,
                            const std::string& stem) {
  for (const std::string& option : {exporting.of_linkages, exporting.of_cams}) {
    if (!option.empty()) {
      return tl::unexpected(ExportRefusal{option + ": is for drawings and tables; of toml --design "
                                                   "is allowed"});
    }
  }
  return exported(analysis_of_design(design), [&](const ordered_json& tables) {
    const std::string name = design_stem(stem, exporting.design) + ".toml";
    return tl::expected<Exported, std::string>(
        Exported{{{name, toml_text(tables)}}, {}, "for cognate analyze", ordered_json::object()});
  });
}

}  // namespace

ExportOutcome export_design(const ResultDesign& design, const ExportOptions& exporting,
                            const std::string& stem, const Options& options) {
  const std::string type = text_under(design.table["mechanism"], "type");
  std::optional<ExportOutcome> made;
  problems::for_each_kind([&]<class Problem>(std::type_identity<Problem>) {
    if constexpr (requires { Kind<Problem>::kOwnType; }) {
      if (Kind<Problem>::kOwnType == type) {
        made = Kind<Problem>::export_design(design, exporting, stem);
      }
    }
  });
  if (made) return *made;
  if (exporting.format == ExportFormat::toml) return analysis_file(design, exporting, stem);
  return exported(result_linkage(design), [&](const LinkageScene& linkage) {
    return export_linkage(linkage, exporting, stem, options);
  });
}

ExitStatus export_command(const fs::path& file, const ExportOptions& exporting,
                          const Options& options) {
  const auto design = read_result_design(file, exporting.design).and_then([&](ResultDesign read) {
    return in_length_unit(std::move(read), options.length_unit);
  });
  if (!design) return refuse_result(file, design.error(), options);
  const auto made = export_design(*design, exporting, stem_of_result(file), options);
  if (made) return write_and_tell(file, *made, options);
  const auto& [message, of_file] = made.error();
  return of_file ? refuse_result(file, message, options) : complain_that(message);
}

}  // namespace cognate::app
