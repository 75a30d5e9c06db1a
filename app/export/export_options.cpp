#include "app/export/export_options.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "app/console/option_text.hpp"

namespace cognate::app {
namespace {

using Text = std::optional<std::string>;

tl::expected<ExportFormat, std::string> parse_format(std::string_view text) {
  const auto found = std::ranges::find(kExportFormats, text, &FormatDeclaration::word);
  if (found != kExportFormats.end()) return found->id;
  const auto of_cams = [](const auto& format) { return format.of_cams; };
  const auto of_no_cams = [](const auto& format) { return format.of_gears && !format.of_cams; };
  const auto of_linkages = [](const auto& format) { return !format.of_gears && !format.of_cams; };
  return refusal("--format", text,
                 fmt::format("{}, of gears and linkages also {}, of linkages also {}",
                             format_words(of_cams, " or "), format_words(of_no_cams, " and "),
                             format_words(of_linkages, " and ")));
}

std::string drawn_formats() {
  return format_words([](const auto& format) { return format.is_drawn(); }, " or ");
}

std::string tabled_formats() {
  return format_words([](const auto& format) { return format.is_tabled(); }, " or ");
}

tl::expected<DxfVersion, std::string> parse_version(std::string_view text) {
  if (text == "r12") return DxfVersion::r12;
  if (text == "2000") return DxfVersion::r2000;
  return refusal("--dxf-version", text, "r12 or 2000");
}

tl::expected<CamCurveKind, std::string> parse_curve(std::string_view text) {
  if (text == "profile") return CamCurveKind::profile;
  if (text == "pitch") return CamCurveKind::pitch;
  if (text == "cutter") return CamCurveKind::cutter;
  return refusal("--curve", text, "profile, pitch or cutter");
}

/// A whole number from 1 to `most`.
tl::expected<int, std::string> parse_count(std::string_view option, std::string_view text,
                                           int most) {
  const auto number = parse_all<int>(text);
  if (number && *number >= 1 && *number <= most) return *number;
  return refusal(option, text, fmt::format("a whole number from 1 to {}", most));
}

tl::expected<double, std::string> parse_position(std::string_view text) {
  constexpr double kMost = 1e9;
  const auto number = parse_all<double>(text);
  if (number && std::abs(*number) <= kMost) return *number;
  return refusal("--position", text, "degrees, or of a driving slider a length, up to 1e9");
}

tl::expected<double, std::string> parse_length(std::string_view option, std::string_view text) {
  const auto length = parse_all<double>(text);
  if (length && *length >= 1e-30 && *length <= 1e30) return *length;
  return refusal(option, text, "a length from 1e-30 to 1e30");
}

tl::expected<double, std::string> parse_length_or_0(std::string_view option,
                                                    std::string_view text) {
  const auto length = parse_all<double>(text);
  if (length && (*length == 0 || (*length >= 1e-30 && *length <= 1e30))) return *length;
  return refusal(option, text, "0 or a length from 1e-30 to 1e30");
}

/// Reads options one by one and keeps what is wrong with them.
class OptionReader {
 public:
  explicit OptionReader(const ExportTexts& texts) : texts_(texts) {}

  tl::expected<ExportOptions, std::vector<std::string>> read() {
    take(parse_format(texts_.format.value_or("")), options_.format);
    constexpr int kMostSteps = 100'000;
    if (texts_.design) {
      take(parse_design(*texts_.design), options_.design);
    }
    if (texts_.dxf_version) take(parse_version(*texts_.dxf_version), options_.version);
    read_length("--chord-tolerance", texts_.chord_tolerance, options_.chord_tolerance);
    if (texts_.curve) take(parse_curve(*texts_.curve), options_.curve);
    read_length("--cutter-radius", texts_.cutter_radius, options_.cutter_radius);
    if (texts_.position) take(parse_position(*texts_.position), options_.position);
    if (texts_.steps) take(parse_count("--steps", *texts_.steps, kMostSteps), options_.steps);
    if (texts_.parts) read_parts();
    if (faults_.empty()) check_together();
    if (!faults_.empty()) return tl::unexpected(faults_);
    options_.of_cams =
        first_given({{"--curve", &texts_.curve}, {"--cutter-radius", &texts_.cutter_radius}});
    options_.of_linkages =
        texts_.parts ? "--parts"
                     : first_given({{"--position", &texts_.position}, {"--steps", &texts_.steps}});
    return options_;
  }

 private:
  template <class Parsed, class Value>
  void take(const Parsed& parsed, Value& value) {
    if (parsed) {
      value = *parsed;
    } else {
      faults_.push_back(parsed.error());
    }
  }

  void read_length(const char* name, const Text& text, std::optional<double>& value) {
    if (text) take(parse_length(name, *text), value);
  }

  void read_parts() {
    PartOrder order;
    for (const auto& [name, text, value] : {std::tuple("--hole", &texts_.hole, &order.hole),
                                            std::tuple("--width", &texts_.width, &order.width)}) {
      if (*text) {
        take(parse_length(name, **text), *value);
      } else {
        faults_.push_back(fmt::format("--parts: {0} is missing; expected {0} LENGTH", name));
      }
    }
    if (texts_.clearance) {
      take(parse_length_or_0("--clearance", *texts_.clearance), order.clearance);
    }
    if (texts_.gap) take(parse_length_or_0("--gap", *texts_.gap), order.gap);
    read_length("--thickness", texts_.thickness, order.thickness);
    options_.parts = order;
  }

  static std::string first_given(const std::vector<std::pair<const char*, const Text*>>& list) {
    for (const auto& [name, text] : list) {
      if (*text) return name;
    }
    return {};
  }

  /// What each option wants of others.
  void check_together() {
    const bool cuts = options_.curve == CamCurveKind::cutter;
    if (cuts != texts_.cutter_radius.has_value()) {
      faults_.emplace_back(
          cuts ? "--curve: 'cutter' needs the cutter's radius; --cutter-radius R is missing"
               : "--cutter-radius: only the path of a cutter has one; expected --curve cutter "
                 "with it");
    }
    if (texts_.dxf_version && options_.format != ExportFormat::dxf) {
      faults_.emplace_back("--dxf-version: only DXF has one; expected --format dxf with it");
    }
    const FormatDeclaration& format = declaration(options_.format);
    if (options_.steps && (!format.is_tabled() || options_.parts)) {
      faults_.push_back(fmt::format("--steps: are those of a table; expected --format {} with it",
                                    tabled_formats()));
    }
    // What is written as a problem refuses the options of linkages itself.
    const bool shown = format.is_drawn() || format.content == ExportContent::problem;
    if (options_.position && (!shown || options_.parts)) {
      faults_.push_back(fmt::format(
          "--position: is that of a drawing; expected --format {} with it", drawn_formats()));
    }
    check_parts(shown);
  }

  void check_parts(bool shown) {
    if (options_.parts && !shown) {
      faults_.push_back(
          fmt::format("--parts: are drawn; expected --format {} with it", drawn_formats()));
    }
    if (options_.parts && !(options_.parts->hole < options_.parts->width)) {
      faults_.push_back(
          fmt::format("--width: {} leaves nothing about a hole of {}; allowed is more than that",
                      options_.parts->width, options_.parts->hole));
    } else if (options_.parts &&
               !(options_.parts->hole + options_.parts->clearance < options_.parts->width)) {
      faults_.push_back(
          fmt::format("--clearance: {} makes slots as wide as the bars; allowed is less than {}",
                      options_.parts->clearance, options_.parts->width - options_.parts->hole));
    }
    const std::string stray = first_given({{"--hole", &texts_.hole},
                                           {"--width", &texts_.width},
                                           {"--clearance", &texts_.clearance},
                                           {"--gap", &texts_.gap},
                                           {"--thickness", &texts_.thickness}});
    if (!options_.parts && !stray.empty()) {
      faults_.push_back(stray + ": is that of parts; expected --parts with it");
    }
  }

  const ExportTexts& texts_;
  ExportOptions options_;
  std::vector<std::string> faults_;
};

}  // namespace

std::string ExportTexts::any() const {
  const std::array<std::pair<const char*, const Text*>, 13> all = {
      {{"--format", &format},
       {"--design", &design},
       {"--chord-tolerance", &chord_tolerance},
       {"--dxf-version", &dxf_version},
       {"--curve", &curve},
       {"--cutter-radius", &cutter_radius},
       {"--position", &position},
       {"--steps", &steps},
       {"--hole", &hole},
       {"--width", &width},
       {"--clearance", &clearance},
       {"--gap", &gap},
       {"--thickness", &thickness}}};
  for (const auto& [name, text] : all) {
    if (*text) return name;
  }
  return parts ? "--parts" : "";
}

tl::expected<ExportOptions, std::vector<std::string>> export_options(const ExportTexts& texts) {
  return OptionReader(texts).read();
}

std::string refused_format(bool FormatDeclaration::*has, std::string_view subject) {
  const auto of_subject = [has](const auto& format) { return format.*has; };
  const auto of_others = [has](const auto& format) { return !(format.*has); };
  return fmt::format("--format: {} are for linkages; of {} {} is allowed",
                     format_words(of_others, " and "), subject, format_words(of_subject, " or "));
}

tl::expected<int, std::string> parse_design(std::string_view text) {
  constexpr int kMostDesigns = 1'000'000;
  return parse_count("--design", text, kMostDesigns);
}

tl::expected<std::int64_t, std::string> parse_row(std::string_view text) {
  const auto number = parse_all<std::int64_t>(text);
  if (number && *number >= 0) return *number;
  return refusal("--row", text, "the id of a row, a whole number from 0 on");
}

}  // namespace cognate::app
