#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/documents/csv.hpp"
#include "app/drawing/link_shapes.hpp"
#include "app/drawing/linkage_plan.hpp"
#include "app/drawing/linkage_scene.hpp"
#include "app/export/export_parts.hpp"
#include "app/export/exported.hpp"
#include "app/export/linkage_json.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/evaluation/drive_rows.hpp"
#include "problems/layers/assign.hpp"
#include "problems/layers/notes.hpp"
#include "synthesis/search/deadline.hpp"

namespace cognate::app {
namespace {

/// `drive` plus whole turns, so that it lies in the sweep where it can.
double in_sweep(const LinkageScene& linkage, double drive) {
  const auto [low, high] = std::minmax(linkage.problem.drive.start, linkage.problem.drive.end);
  if (is_driven_by_slider(linkage) || (low <= drive && drive <= high)) return drive;
  const double least = drive + kTurn * std::ceil((low - drive) / kTurn);
  return least <= high ? least : drive;
}

/// `drive` (radians, or a length for a driving slider) as people write it: degrees or a length.
double shown_drive(const LinkageScene& linkage, double drive) {
  return is_driven_by_slider(linkage) ? drive : problems::degrees(drive);
}

/// The drive coordinate at which `linkage` is drawn, and `motion` moved there: `wanted` (degrees,
/// or a length), else the first of the stations, else the first row of the drive at which the
/// linkage can be assembled. Empty where it cannot be assembled there.
std::optional<double> drive_position(const LinkageScene& linkage, std::optional<double> wanted,
                                     FollowedMotion<0>& motion) {
  if (wanted) {
    const double drive =
        in_sweep(linkage, is_driven_by_slider(linkage) ? *wanted : *wanted * kTurn / 360);
    return motion.move_to(drive) ? std::optional(drive) : std::nullopt;
  }
  for (const double station : linkage.stations) {
    const double drive = in_sweep(linkage, station);
    if (motion.move_to(drive)) return drive;
  }
  for (int row = 0; row < problems::row_count(linkage.problem.drive); ++row) {
    const double drive = problems::drive_at(linkage.problem.drive, row);
    if (motion.move_to(drive)) return drive;
  }
  return std::nullopt;
}

/// In quotes, as Graphviz reads it; a line break is a line break of the label.
std::string graph_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n') {
      out += "\\n";
    } else {
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out + '"';
}

/// The link's name, and how far its joints are from one another.
std::string label_of(const LinkShape& link) {
  std::string text = link.name;
  for (std::size_t i = 0; i < link.places.size(); ++i) {
    for (std::size_t k = i + 1; k < link.places.size(); ++k) {
      const LinkPlace &a = link.places[i], &b = link.places[k];
      text += fmt::format("\n{}-{} {:.6g}", a.name, b.name, norm(b.at - a.at));
    }
  }
  return text;
}

/// The chain in the language of Graphviz: a node for each link with the distances of its joints,
/// the frame marked, and an edge for each joint, dashed where it slides.
std::string chain_sketch(const std::string& title, const LinkShapes& shown) {
  std::string text = "graph " + graph_text(title) +
                     " {\n  node [shape=box, style=rounded];\n  edge [fontsize=11];\n";
  for (std::size_t i = 0; i < shown.links.size(); ++i) {
    text += fmt::format("  link{} [label={}{}];\n", i, graph_text(label_of(shown.links[i])),
                        i == 0 ? ", peripheries=2, style=filled, fillcolor=lightgrey" : "");
  }
  for (const JointShape& joint : shown.joints) {
    const bool slides = joint.type == JointType::prismatic;
    text += fmt::format("  link{} -- link{} [label={}{}];\n", joint.first, joint.second,
                        graph_text(slides ? joint.name + "\nslides" : joint.name),
                        slides ? ", style=dashed" : "");
  }
  return text + "}\n";
}

using nlohmann::ordered_json;
using Result = tl::expected<Exported, std::string>;

constexpr double kDefaultTolerance = 1e-4;  // of the linkage's size
constexpr double kLeastTolerance = 1e-9;

class LinkageExporter {
 public:
  LinkageExporter(const LinkageScene& linkage, const ExportOptions& wanted, std::string stem,
                  const Options& options)
      : linkage_(linkage),
        wanted_(wanted),
        stem_(std::move(stem)),
        options_(options),
        motion_(linkage.problem.mechanism.mechanism, assembly_ranges_of(linkage)),
        shown_(link_shapes(linkage)) {
    if (wanted.steps) linkage_.problem.drive.steps = *wanted.steps;
  }

  Result run() {
    if (!wanted_.of_cams.empty()) {
      return tl::unexpected(wanted_.of_cams +
                            ": is for cams; of a linkage --position, --steps and "
                            "--parts are allowed");
    }
    if (!wanted_.of_wheels.empty()) {
      return tl::unexpected(wanted_.of_wheels +
                            ": is for gears and cams; of a linkage --position, --steps and --parts "
                            "are allowed");
    }
    if (wanted_.kerf > 0 && !wanted_.parts) {
      return tl::unexpected(
          std::string("--kerf: of a linkage only parts are cut; expected --parts with it"));
    }
    if (declaration(wanted_.format).is_solid() && !wanted_.parts) {
      return tl::unexpected(
          std::string("--format: solids of a linkage are those of its parts; expected --parts "
                      "--hole D --width W --thickness T with it"));
    }
    if (const auto idle = idle_tolerance()) return tl::unexpected(*idle);
    const auto drive = drive_position(linkage_, wanted_.position, motion_);
    if (!drive) return tl::unexpected(unplaced());
    if (wanted_.parts) {
      return export_parts({linkage_, shown_, motion_.bodies()}, wanted_, stem_, options_);
    }
    if (wanted_.format == ExportFormat::csv) return table();
    if (wanted_.format == ExportFormat::dot) return sketch();
    return drawing(shown_drive(linkage_, *drive));
  }

 private:
  /// Why a tolerance that is given has nothing to do.
  std::optional<std::string> idle_tolerance() const {
    const bool has_paths = (!wanted_.parts && declaration(wanted_.format).is_drawn()) ||
                           wanted_.format == ExportFormat::stl;
    if (has_paths || !wanted_.chord_tolerance) return std::nullopt;
    return fmt::format(
        "--chord-tolerance: is that of the paths of a linkage; expected --format {} without "
        "--parts with it",
        format_words([](const auto& format) { return format.is_drawn(); }, " or "));
  }

  /// Why there is no position to draw.
  std::string unplaced() const {
    if (!wanted_.position) {
      return "the linkage can be assembled nowhere on the way of its drive; expected one that can "
             "be";
    }
    const auto& runs = motion_.assembly_ranges().runs;
    return fmt::format(
        "--position: at {} the linkage cannot be shown; allowed is {}", *wanted_.position,
        runs.empty() ? "another linkage, as this one can be assembled nowhere" : ranges(runs));
  }

  /// Ranges of the drive: "10 to 80 or 100 to 170".
  std::string ranges(const std::vector<AssemblyRange>& runs) const {
    constexpr std::size_t kMost = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(runs.size(), kMost); ++i) {
      text += fmt::format("{}{:.6g} to {:.6g}", i > 0 ? " or " : "",
                          shown_drive(linkage_, runs[i].from), shown_drive(linkage_, runs[i].to));
    }
    return text + (runs.size() > kMost ? " or further on" : "");
  }

  static AssemblyRanges assembly_ranges_of(const LinkageScene& linkage) {
    const auto& drive = linkage.problem.drive;
    return follow(linkage.problem.mechanism.mechanism, drive.start, drive.end);
  }

  Result file(tl::expected<std::string, std::string> text, std::string summary,
              ordered_json quantities = ordered_json::object()) {
    if (!text) return tl::unexpected(text.error());
    const std::string name = fmt::format("{}.{}", stem_, declaration(wanted_.format).word);
    return Exported{{{name, *std::move(text)}}, notes_, std::move(summary), std::move(quantities)};
  }

  /// Lets a drive that goes a hair beyond what can be assembled start and end with a position.
  void pull_in_drive() {
    const AssemblyRanges& ranges = motion_.assembly_ranges();
    if (!linkage_.beyond || ranges.runs.empty()) return;
    const problems::DriveSpan span = inside_longest(ranges);
    linkage_.problem.drive.start = span.from;
    linkage_.problem.drive.end = span.to;
  }

  problems::AnalysisResult positions() {
    pull_in_drive();
    problems::Run run;
    run.threads = options_.threads;
    run.time_limit = options_.time_limit;
    auto result = problems::analyse(linkage_.problem, run);
    std::ranges::copy(result.notes, std::back_inserter(notes_));
    return result;
  }

  Result table() {
    const auto columns = positions().columns;
    const std::size_t rows = columns.front().values.size();
    return file(csv_text(columns, {}, length_word(linkage_.problem.length_unit)),
                fmt::format("{} positions", rows), {{"rows", rows}});
  }

  Result sketch() {
    const auto& title = linkage_.problem.title;
    return file(chain_sketch(title.empty() ? stem_ : title, shown_),
                fmt::format("{} links, {} joints", shown_.links.size(), shown_.joints.size()));
  }

  /// The tolerance wanted, or what is wrong with it.
  tl::expected<double, std::string> tolerance() const {
    const double size = size_of(shown_);
    const double wanted = wanted_.chord_tolerance.value_or(kDefaultTolerance * size);
    if (size == 0 || (wanted >= kLeastTolerance * size && wanted <= size)) return wanted;
    return tl::unexpected(fmt::format(
        "--chord-tolerance: {} is not possible for a linkage of this size; allowed is a length "
        "from {:.3g} to {:.6g}",
        wanted, kLeastTolerance * size, size));
  }

  /// Those of the sizes of the file; a note says where there are none.
  void assign_layers() {
    const synthesis::Deadline deadline(options_.time_limit.value_or(kInfinity));
    const auto layers =
        problems::assign_layers(linkage_.problem.mechanism, motion_.assembly_ranges(),
                                *linkage_.layers, [&] { return deadline.reached(); });
    if (!layers || !layers->count) {
      notes_.push_back(layers ? blocked_note(*layers, is_driven_by_slider(linkage_))
                              : layers.error());
      return;
    }
    for (LinkShape& link : shown_.links) {
      const auto own =
          std::ranges::find(layers->links, link.name, &problems::LayerResult::Link::name);
      if (own != layers->links.end()) link.layer = own->layer;
    }
    if (shown_.cylinder) shown_.links[kDrivingRod].layer = shown_.links[kDrivingCylinder].layer;
  }

  /// In the position `drive`, degrees or a length.
  Result drawing(double drive) {
    const auto chord = tolerance();
    if (!chord) return tl::unexpected(chord.error());
    if (linkage_.layers) assign_layers();
    const auto paths = linkage_paths(linkage_, motion_.assembly_ranges(), *chord);
    if (!paths) {
      return tl::unexpected(fmt::format(
          "--chord-tolerance: {:.3g} would take more than {} points; allowed is a greater length",
          *chord, kMostPathCorners));
    }
    const std::string where = fmt::format("shown with the drive at {:.6g}{}", drive,
                                          is_driven_by_slider(linkage_) ? "" : " deg");
    const ordered_json quantities = {{"position", drive}, {"chord_tolerance", *chord}};
    if (wanted_.format != ExportFormat::json) {
      return file(drawn_text(linkage_plan(linkage_, shown_, motion_.bodies(), *paths),
                             linkage_.problem.length_unit, wanted_),
                  where, quantities);
    }
    ordered_json document = {{"format", "cognate-linkage/1"}};
    document.update(linkage_json(linkage_, shown_, motion_.bodies(), drive, *paths));
    document["positions"] = columns_json(positions().columns);
    return file(document_text(document), where, quantities);
  }

  LinkageScene linkage_;
  const ExportOptions& wanted_;
  std::string stem_;
  const Options& options_;
  FollowedMotion<0> motion_;
  LinkShapes shown_;
  std::vector<std::string> notes_;
};

}  // namespace

tl::expected<Exported, std::string> export_linkage(const LinkageScene& linkage,
                                                   const ExportOptions& wanted,
                                                   const std::string& stem,
                                                   const Options& options) {
  return LinkageExporter(linkage, wanted, stem, options).run();
}

}  // namespace cognate::app
