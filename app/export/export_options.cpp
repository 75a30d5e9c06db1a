#include "app/export/export_options.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "app/export/option_values.hpp"

namespace cognate::app {
namespace {

using Text = std::optional<std::string>;

std::string drawn_formats() {
  return format_words([](const auto& format) { return format.is_drawn(); }, " or ");
}

std::string solid_formats() {
  return format_words([](const auto& format) { return format.is_solid(); }, " or ");
}

std::string tabled_formats() {
  return format_words([](const auto& format) { return format.is_tabled(); }, " or ");
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
    if (texts_.kerf) take(parse_length("--kerf", *texts_.kerf), options_.kerf);
    read_length("--thickness", texts_.thickness, options_.thickness);
    read_length("--hub-length", texts_.hub_length, options_.hub_length);
    read_wheel();
    if (texts_.parts) read_parts();
    if (faults_.empty()) check_together();
    if (!faults_.empty()) return tl::unexpected(faults_);
    name_subjects();
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

  /// The first option that is for one kind of result alone.
  void name_subjects() {
    options_.of_cams =
        first_given({{"--curve", &texts_.curve}, {"--cutter-radius", &texts_.cutter_radius}});
    if (options_.of_cams.empty() && texts_.timing_mark) options_.of_cams = "--timing-mark";
    options_.of_linkages =
        texts_.parts ? "--parts"
                     : first_given({{"--position", &texts_.position}, {"--steps", &texts_.steps}});
    options_.of_wheels = first_given(
        {{"--bore", &texts_.bore}, {"--hub", &texts_.hub}, {"--hub-length", &texts_.hub_length}});
  }

  void read_wheel() {
    WheelOrder& wheel = options_.wheel;
    if (texts_.bore) take(parse_lengths("--bore", *texts_.bore), wheel.bores);
    if (texts_.hub) take(parse_lengths("--hub", *texts_.hub), wheel.hubs);
    wheel.keyway = texts_.keyway;
    wheel.timing_mark = texts_.timing_mark;
    if (wheel.keyway && !texts_.bore) {
      faults_.emplace_back("--keyway: is that of a bore; expected --bore D with it");
    }
  }

  void read_parts() {
    PartOrder order;
    if (texts_.hole) take(parse_length("--hole", *texts_.hole), order.hole);
    if (texts_.width) take(parse_length("--width", *texts_.width), order.width);
    if (texts_.labels) take(parse_labels(*texts_.labels), order.labels);
    if (texts_.bearing) take(parse_bearing(*texts_.bearing), order.bearing);
    if (texts_.screw) take(parse_screw(*texts_.screw), order.screw);
    Vec2d washer{};
    if (texts_.washer) take(parse_washer(*texts_.washer), washer);
    order.washer = washer.x;
    order.washer_outside = washer.y;
    if (texts_.boss) take(parse_length("--boss", *texts_.boss), order.boss);
    if (texts_.block) take(parse_block(*texts_.block), order.block);
    if (texts_.sheet) take(parse_sheet(*texts_.sheet), order.sheet);
    order.kerf = options_.kerf;
    order.bill = texts_.bill;
    order.spacers = texts_.spacers;
    if (texts_.clearance) {
      take(parse_length_or_0("--clearance", *texts_.clearance), order.clearance);
    }
    if (texts_.gap) take(parse_length_or_0("--gap", *texts_.gap), order.gap);
    order.thickness = options_.thickness;
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
    const bool shown =
        format.is_drawn() || format.is_solid() || format.content == ExportContent::problem;
    if (options_.position && (!shown || (options_.parts && !format.is_solid()))) {
      faults_.push_back(fmt::format(
          "--position: is that of a drawing; expected --format {} with it", drawn_formats()));
    }
    check_cuts(format);
    if (format.is_solid()) check_solids();
    if (texts_.boss && !format.is_solid()) {
      faults_.push_back(
          fmt::format("--boss: is that of solids; expected --format {} with it", solid_formats()));
    } else if (texts_.boss && texts_.spacers) {
      faults_.emplace_back("--boss: is in the place of a spacer; expected it without --spacers");
    }
    if (options_.hub_length && !format.is_solid()) {
      faults_.push_back(fmt::format("--hub-length: is that of solids; expected --format {} with it",
                                    solid_formats()));
    }
    check_parts(shown);
  }

  /// What is cut is drawn.
  void check_cuts(const FormatDeclaration& format) {
    std::string cut =
        first_given({{"--kerf", &texts_.kerf}, {"--bore", &texts_.bore}, {"--hub", &texts_.hub}});
    if (cut.empty() && texts_.timing_mark) cut = "--timing-mark";
    if (cut.empty() || format.is_drawn() || format.is_solid()) return;
    faults_.push_back(fmt::format("{}: is that of a drawing; expected --format {} with it", cut,
                                  drawn_formats()));
  }

  /// What is of flat drawings alone.
  void check_solids() {
    std::string flat = first_given({{"--kerf", &texts_.kerf},
                                    {"--labels", &texts_.labels},
                                    {"--gap", &texts_.gap},
                                    {"--sheet", &texts_.sheet}});
    if (flat.empty() && texts_.timing_mark) flat = "--timing-mark";
    if (flat.empty()) return;
    faults_.push_back(fmt::format("{}: is that of a drawing; expected --format {} with it", flat,
                                  drawn_formats()));
  }

  void check_parts(bool shown) {
    if (options_.parts && !shown) {
      faults_.push_back(
          fmt::format("--parts: are drawn; expected --format {} with it", drawn_formats()));
    }
    const bool sized = texts_.width && (texts_.hole || texts_.bearing);
    if (options_.parts && sized && !options_.parts->bearing &&
        options_.parts->width <= options_.parts->hole) {
      faults_.push_back(
          fmt::format("--width: {} leaves nothing about a hole of {}; allowed is more than that",
                      options_.parts->width, options_.parts->hole));
    } else if (options_.parts && sized &&
               !(options_.parts->hole + options_.parts->clearance < options_.parts->width)) {
      faults_.push_back(
          fmt::format("--clearance: {} makes slots as wide as the bars; allowed is less than {}",
                      options_.parts->clearance, options_.parts->width - options_.parts->hole));
    }
    if (texts_.screw && texts_.washer) {
      faults_.emplace_back(
          "--washer: a screw has those of ISO 7089; expected --screw without --washer");
    }
    const std::string stray = first_given({{"--hole", &texts_.hole},
                                           {"--width", &texts_.width},
                                           {"--clearance", &texts_.clearance},
                                           {"--gap", &texts_.gap},
                                           {"--thickness", &texts_.thickness},
                                           {"--labels", &texts_.labels},
                                           {"--bearing", &texts_.bearing},
                                           {"--screw", &texts_.screw},
                                           {"--washer", &texts_.washer},
                                           {"--boss", &texts_.boss},
                                           {"--block", &texts_.block},
                                           {"--sheet", &texts_.sheet}});
    for (const auto& [name, given] :
         {std::pair("--bill", texts_.bill), std::pair("--spacers", texts_.spacers)}) {
      if (options_.parts || !given) continue;
      faults_.push_back(fmt::format("{}: is that of parts; expected --parts with it", name));
    }
    const bool is_of_solid = stray == "--thickness" && declaration(options_.format).is_solid();
    if (!options_.parts && !stray.empty() && !is_of_solid) {
      faults_.push_back(stray + ": is that of parts; expected --parts with it");
    }
  }

  const ExportTexts& texts_;
  ExportOptions options_;
  std::vector<std::string> faults_;
};

}  // namespace

std::string ExportTexts::any() const {
  for (const auto& [name, text] : kExportTexts) {
    if (this->*text) return std::string(name);
  }
  for (const auto& [name, given] : kExportFlags) {
    if (this->*given) return std::string(name);
  }
  return {};
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

}  // namespace cognate::app
