/// @file The options of `cognate export`, and what each may be.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "app/drawing/cam_drawing.hpp"
#include "app/export/dxf.hpp"
#include "app/export/parts/link_parts.hpp"
#include "app/export/wheel_bore.hpp"

namespace cognate::app {

enum class ExportFormat { dxf, svg, csv, json, dot, toml, step, stl };

/// What a file of a linkage holds.
enum class ExportContent {
  drawing,   ///< one position, with paths
  table,     ///< positions over the drive
  document,  ///< both
  chain,     ///< links and joints in no position
  problem,   ///< the mechanism, for `cognate analyze`
  solids     ///< its parts
};

/// What is said once of a format. All are of linkages.
struct FormatDeclaration {
  ExportFormat id;
  std::string_view word;  ///< of `--format`, and the ending of its files
  ExportContent content;
  bool of_cams = false;
  bool of_gears = false;
  std::string_view help;  ///< the lines of `cognate export --help` on files of linkages

  constexpr bool is_drawn() const {
    return content == ExportContent::drawing || content == ExportContent::document;
  }
  constexpr bool is_solid() const { return content == ExportContent::solids; }
  constexpr bool is_tabled() const {
    return content == ExportContent::table || content == ExportContent::document;
  }
};

/// In the order of `ExportFormat`.
inline constexpr std::array kExportFormats{
    FormatDeclaration{ExportFormat::dxf, "dxf", ExportContent::drawing, true, true,
                      "NAME.dxf   one position and the paths of the points, on layers FRAME,\n"
                      "               GUIDES, LINKS, JOINTS, POINTS, PATHS, TARGET and LABELS"},
    FormatDeclaration{ExportFormat::svg, "svg", ExportContent::drawing, true, true,
                      "NAME.svg   a picture with the same"},
    FormatDeclaration{ExportFormat::csv, "csv", ExportContent::table, true, true,
                      "NAME.csv   where every point is over the drive, units in the header"},
    FormatDeclaration{ExportFormat::json, "json", ExportContent::document, false, true,
                      "NAME.json  lengths, joints, paths and positions in one document"},
    FormatDeclaration{ExportFormat::dot, "dot", ExportContent::chain, false, false,
                      "NAME.dot   the chain for Graphviz: links as boxes, joints as edges"},
    FormatDeclaration{ExportFormat::toml, "toml", ExportContent::problem, false, false,
                      "NAME.designN.toml   the mechanism and its drive, for cognate analyze"},
    FormatDeclaration{ExportFormat::step, "step", ExportContent::solids, true, true,
                      "NAME.step  with --parts and --thickness: the parts as solids for CAD,\n"
                      "               assembled in one position (needs OpenCASCADE)"},
    FormatDeclaration{ExportFormat::stl, "stl", ExportContent::solids, true, true,
                      "NAME.PART.stl   each of those solids by itself, for printing"}};

constexpr const FormatDeclaration& declaration(ExportFormat format) {
  return kExportFormats.at(static_cast<std::size_t>(format));
}

static_assert([] {
  for (const FormatDeclaration& format : kExportFormats) {
    if (declaration(format.id).word != format.word) return false;
  }
  return true;
}());

/// "dxf, svg or csv": the words of the formats of which `has` is true, `last` between the last two.
template <class Has>
std::string format_words(Has has, std::string_view last) {
  std::string text;
  std::string_view word;
  for (const FormatDeclaration& format : kExportFormats) {
    if (!has(format)) continue;
    if (!word.empty()) text.append(text.empty() ? "" : ", ").append(word);
    word = format.word;
  }
  return text.append(text.empty() ? "" : last).append(word);
}

/// Why a format is not one of `subject` ("a cam"), whose formats are those with `has`.
std::string refused_format(bool FormatDeclaration::*has, std::string_view subject);

/// The options as they were written; empty where they were not.
struct ExportTexts {
  std::optional<std::string> format, design, chord_tolerance, dxf_version;
  std::optional<std::string> curve, cutter_radius;
  std::optional<std::string> position, steps;
  bool parts = false;
  std::optional<std::string> hole, width, clearance, gap, thickness;
  std::optional<std::string> labels, bearing, screw, washer, sheet, boss, block;
  bool bill = false, spacers = false;
  std::optional<std::string> kerf, bore, hub, hub_length;
  bool keyway = false, timing_mark = false;

  /// The name of an option that is written; empty where none is.
  std::string any() const;
};

/// An option and the member of `ExportTexts` that it sets.
template <class Value>
struct ExportOption {
  std::string_view name;
  Value ExportTexts::*member;
};

inline constexpr auto kExportTexts = std::to_array<ExportOption<std::optional<std::string>>>(
    {{"--format", &ExportTexts::format},
     {"--design", &ExportTexts::design},
     {"--chord-tolerance", &ExportTexts::chord_tolerance},
     {"--dxf-version", &ExportTexts::dxf_version},
     {"--curve", &ExportTexts::curve},
     {"--cutter-radius", &ExportTexts::cutter_radius},
     {"--position", &ExportTexts::position},
     {"--steps", &ExportTexts::steps},
     {"--hole", &ExportTexts::hole},
     {"--width", &ExportTexts::width},
     {"--clearance", &ExportTexts::clearance},
     {"--gap", &ExportTexts::gap},
     {"--thickness", &ExportTexts::thickness},
     {"--labels", &ExportTexts::labels},
     {"--bearing", &ExportTexts::bearing},
     {"--screw", &ExportTexts::screw},
     {"--washer", &ExportTexts::washer},
     {"--sheet", &ExportTexts::sheet},
     {"--boss", &ExportTexts::boss},
     {"--block", &ExportTexts::block},
     {"--kerf", &ExportTexts::kerf},
     {"--bore", &ExportTexts::bore},
     {"--hub", &ExportTexts::hub},
     {"--hub-length", &ExportTexts::hub_length}});

inline constexpr auto kExportFlags =
    std::to_array<ExportOption<bool>>({{"--parts", &ExportTexts::parts},
                                       {"--bill", &ExportTexts::bill},
                                       {"--spacers", &ExportTexts::spacers},
                                       {"--keyway", &ExportTexts::keyway},
                                       {"--timing-mark", &ExportTexts::timing_mark}});

struct ExportOptions {
  ExportFormat format = ExportFormat::dxf;
  int design = 1;  ///< counted from 1
  DxfVersion version = DxfVersion::r2000;
  std::optional<double> chord_tolerance;
  CamCurveKind curve = CamCurveKind::profile;  ///< of a cam
  std::optional<double> cutter_radius;         ///< where `curve` is cutter
  std::optional<double> position;              ///< of the drive: degrees, or a length
  std::optional<int> steps;                    ///< of the drive
  std::optional<PartOrder> parts;              ///< where links are to be drawn as parts
  std::optional<double> thickness;             ///< of solids
  std::optional<double> hub_length;            ///< of solids: from the wheel's lower face
  double kerf = 0;                             ///< width of the cut
  WheelOrder wheel;                            ///< what gears and cams have at their centres
  std::string of_cams;      ///< an option that is for cams alone; empty where none is given
  std::string of_linkages;  ///< the same for linkages
  std::string of_wheels;    ///< the same for gears and cams
};

/// What `texts` say, or every fault in them: what is wrong; what is allowed.
tl::expected<ExportOptions, std::vector<std::string>> export_options(const ExportTexts& texts);

/// The number of a design of a result, counted from 1.
tl::expected<int, std::string> parse_design(std::string_view text);

/// The number of a design of a study: a whole number from 0 on.
tl::expected<std::int64_t, std::string> parse_row(std::string_view text);

}  // namespace cognate::app
