/// @file What an export writes and says.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "app/console/options.hpp"
#include "app/drawing/gear_plan.hpp"
#include "app/drawing/linkage_scene.hpp"
#include "app/export/export_options.hpp"
#include "app/export/result_cam.hpp"
#include "app/export/result_document.hpp"
#include "problems/linkage/drive_span.hpp"

namespace cognate::app {

/// The linkage of a design whose mechanism is none of type "cam", made anew of its table
/// `mechanism`. The drive is that of an analysis, else the range in which the linkage can be
/// assembled and that holds most of its stations, in 360 steps. The error is a message that begins
/// with the document's name: what is wrong; what is allowed.
tl::expected<LinkageScene, std::string> result_linkage(const ResultDesign& given);

/// The tables of a file that asks for the analysis of the design's mechanism: of an analysis those
/// that it was made of, of a synthesis the mechanism over the drive of `result_linkage`. The same
/// errors.
tl::expected<nlohmann::ordered_json, std::string> analysis_of_design(const ResultDesign& given);

/// The longest of `ranges`, which are not empty, a hair inside its ends, at which rounding decides.
problems::DriveSpan inside_longest(const AssemblyRanges& ranges);

/// "walk.design2": what files made of design 2 of walk.result.json are called.
std::string design_stem(const std::string& stem, int design);

/// A gear, or the two of a pair in mesh.
struct ResultGears {
  std::string title;
  std::string gearing;
  std::optional<problems::LengthUnit> length_unit;
  std::vector<GearPose> gears;
  std::vector<std::string> notes;  ///< what is wrong with them
  std::optional<double> face_width{};
};

/// The gears of a design whose mechanism is of type "gear" or "gear-pair", made anew of its table
/// `mechanism`. The error is a message that begins with the document's name: what is wrong; what is
/// allowed.
tl::expected<ResultGears, std::string> result_gears(const ResultDesign& given);

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
