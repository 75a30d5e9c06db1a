/// @file The options of `cognate export`, and what each may be.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "app/drawing/cam_drawing.hpp"
#include "app/export/dxf.hpp"
#include "app/export/link_parts.hpp"

namespace cognate::app {

enum class ExportFormat { dxf, svg, csv, json, dot, toml };

/// The options as they were written; empty where they were not.
struct ExportTexts {
  std::optional<std::string> format, design, chord_tolerance, dxf_version;
  std::optional<std::string> curve, cutter_radius;
  std::optional<std::string> position, steps;
  bool parts = false;
  std::optional<std::string> hole, width, clearance, gap, thickness;

  /// The name of an option that is written; empty where none is.
  std::string any() const;
};

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
  std::string of_cams;      ///< an option that is for cams alone; empty where none is given
  std::string of_linkages;  ///< the same for linkages
};

/// What `texts` say, or every fault in them: what is wrong; what is allowed.
tl::expected<ExportOptions, std::vector<std::string>> export_options(const ExportTexts& texts);

/// The number of a design of a result, counted from 1.
tl::expected<int, std::string> parse_design(std::string_view text);

/// The number of a design of a study: a whole number from 0 on.
tl::expected<std::int64_t, std::string> parse_row(std::string_view text);

}  // namespace cognate::app
