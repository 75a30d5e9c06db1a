/// @file What an export writes and says.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/console/options.hpp"
#include "app/export/export_options.hpp"
#include "app/export/result_cam.hpp"
#include "app/export/result_gears.hpp"
#include "app/export/result_linkage.hpp"

namespace cognate::app {

struct ExportedFile {
  std::string name;
  std::string text;
};

struct Exported {
  std::vector<ExportedFile> files;
  std::vector<std::string> notes;
  std::string summary;                ///< one line for people
  nlohmann::ordered_json quantities;  ///< members of the document `cognate-export/1`
};

/// Why a design is not exported: an option is not possible, or the file holds nothing to export,
/// and `message` begins with its name.
struct ExportRefusal {
  std::string message;
  bool of_file = false;
};

using ExportOutcome = tl::expected<Exported, ExportRefusal>;

/// What `write` makes of what was `read` of a result file.
template <class Subject, class Write>
ExportOutcome exported(const tl::expected<Subject, std::string>& read, Write write) {
  if (!read) return tl::unexpected(ExportRefusal{read.error(), true});
  return write(*read).map_error([](const std::string& what) { return ExportRefusal{what}; });
}

/// The files of a cam's curves, called after `stem`: one, but of a table one for each curve. The
/// error says which option is not possible and what is allowed.
tl::expected<Exported, std::string> export_cam(const ResultCam& given, const ExportOptions& wanted,
                                               const std::string& stem);

/// The outlines of a gear or of two in mesh: one file, but of a table one for each gear.
tl::expected<Exported, std::string> export_gears(const ResultGears& given,
                                                 const ExportOptions& wanted,
                                                 const std::string& stem);

/// The file of a linkage: its drawing in one position, its parts, its positions over the drive, the
/// document `cognate-linkage/1`, or the sketch of its chain.
tl::expected<Exported, std::string> export_linkage(const LinkageScene& linkage,
                                                   const ExportOptions& wanted,
                                                   const std::string& stem, const Options& options);

}  // namespace cognate::app
