#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <utility>

#include "app/documents/csv.hpp"
#include "app/documents/json_values.hpp"
#include "app/documents/result_json.hpp"
#include "app/export/chain_sketch.hpp"
#include "app/export/exported.hpp"
#include "app/export/linkage_json.hpp"
#include "app/export/linkage_plan.hpp"
#include "app/export/svg.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using Result = tl::expected<Exported, std::string>;

constexpr double kDefaultTolerance = 1e-4;  // of the linkage's size
constexpr double kLeastTolerance = 1e-9;

const char* ending(ExportFormat format) {
  switch (format) {
    case ExportFormat::svg:
      return ".svg";
    case ExportFormat::csv:
      return ".csv";
    case ExportFormat::json:
      return ".json";
    case ExportFormat::dot:
      return ".dot";
    default:
      return ".dxf";
  }
}

/// The text of a drawing; an error where numbers beyond all measure are in it.
tl::expected<std::string, std::string> drawn(const Plan& plan, const ExportOptions& wanted) {
  if (!std::isfinite(norm(plan.high - plan.low))) {
    return tl::unexpected(
        std::string("the linkage is too large to be drawn; lengths up to 1e100 are allowed"));
  }
  return wanted.format == ExportFormat::svg ? svg_text(plan) : dxf_text(plan, wanted.version);
}

tl::expected<std::string, std::string> written(const ordered_json& document) {
  if (find_non_finite(document)) {
    return tl::unexpected(
        std::string("the linkage is too large to be told; lengths up to 1e100 are allowed"));
  }
  return write_json(document);
}

class LinkageExporter {
 public:
  LinkageExporter(const ResultLinkage& linkage, const ExportOptions& wanted, std::string stem,
                  const Options& options)
      : linkage_(linkage),
        wanted_(wanted),
        stem_(std::move(stem)),
        options_(options),
        motion_(linkage.problem.mechanism.mechanism, course_of(linkage)),
        shown_(shown_links(linkage)) {
    if (wanted.steps) linkage_.problem.drive.steps = *wanted.steps;
  }

  Result run() {
    if (!wanted_.of_cams.empty()) {
      return tl::unexpected(wanted_.of_cams +
                            ": is for cams; of a linkage --position, --steps and "
                            "--parts are allowed");
    }
    if (const auto idle = idle_tolerance()) return tl::unexpected(*idle);
    const auto position = shown_position(linkage_, wanted_.position, motion_);
    if (!position) return tl::unexpected(position.error());
    if (wanted_.parts) return parts();
    if (wanted_.format == ExportFormat::csv) return table();
    if (wanted_.format == ExportFormat::dot) return sketch();
    return drawing(*position);
  }

 private:
  /// Why a tolerance that is given has nothing to do.
  std::optional<std::string> idle_tolerance() const {
    const bool has_paths = !wanted_.parts && wanted_.format != ExportFormat::csv &&
                           wanted_.format != ExportFormat::dot;
    if (has_paths || !wanted_.order.chord_tolerance) return std::nullopt;
    return "--chord-tolerance: is that of the paths of a linkage; --format dxf, svg or json "
           "without --parts is wanted with it";
  }

  static Course course_of(const ResultLinkage& linkage) {
    const auto& drive = linkage.problem.drive;
    return follow(linkage.problem.mechanism.mechanism, drive.start, drive.end);
  }

  Result file(tl::expected<std::string, std::string> text, std::string summary,
              ordered_json facts = ordered_json::object()) {
    if (!text) return tl::unexpected(text.error());
    const std::string name = stem_ + (wanted_.parts ? ".parts" : "") + ending(wanted_.format);
    return Exported{{{name, *std::move(text)}}, notes_, std::move(summary), std::move(facts)};
  }

  /// Lets a drive that goes a hair beyond what can be assembled start and end with a position.
  void pull_in_drive() {
    constexpr double kInside = 1e-9;  // of the range: at its very ends rounding decides
    const auto& runs = motion_.course().runs;
    if (!linkage_.beyond || runs.empty()) return;
    const double from = runs.front().from, to = runs.back().to;
    linkage_.problem.drive.start = std::lerp(from, to, kInside);
    linkage_.problem.drive.end = std::lerp(from, to, 1 - kInside);
  }

  problems::AnalysisResult positions() {
    pull_in_drive();
    problems::Run run;
    run.threads = options_.threads;
    run.time_limit = options_.time_limit;
    auto result = problems::analyse(linkage_.problem, run);
    notes_ = result.notes;
    return result;
  }

  Result table() {
    const auto columns = positions().columns;
    const std::size_t rows = columns.front().values.size();
    return file(csv_text(columns), fmt::format("{} positions", rows), {{"rows", rows}});
  }

  Result sketch() {
    const auto& title = linkage_.problem.title;
    return file(chain_sketch(title.empty() ? stem_ : title, shown_),
                fmt::format("{} links, {} joints", shown_.links.size(), shown_.joints.size()));
  }

  /// The tolerance wanted, or what is wrong with it.
  tl::expected<double, std::string> tolerance() const {
    const double size = size_of(shown_);
    const double wanted = wanted_.order.chord_tolerance.value_or(kDefaultTolerance * size);
    if (size == 0 || (wanted >= kLeastTolerance * size && wanted <= size)) return wanted;
    return tl::unexpected(fmt::format(
        "--chord-tolerance: {} is not possible for a linkage of this size; allowed is a length "
        "from {:.3g} to {:.6g}",
        wanted, kLeastTolerance * size, size));
  }

  Result drawing(const ShownPosition& position) {
    const auto chord = tolerance();
    if (!chord) return tl::unexpected(chord.error());
    const auto paths = linkage_paths(linkage_, motion_.course(), *chord);
    if (!paths) return tl::unexpected(paths.error());
    const std::string where = fmt::format("shown with the drive at {:.6g}{}", position.value,
                                          is_driven_by_slider(linkage_) ? "" : " deg");
    const ordered_json facts = {{"position", position.value}, {"chord_tolerance", *chord}};
    if (wanted_.format != ExportFormat::json) {
      return file(drawn(linkage_plan(linkage_, shown_, motion_.bodies(), *paths), wanted_), where,
                  facts);
    }
    ordered_json document = {{"format", "cognate-linkage/1"}};
    document.update(linkage_json(linkage_, shown_, motion_.bodies(), position, *paths));
    document["positions"] = columns_json(positions().columns);
    return file(written(document), where, facts);
  }

  Result parts() {
    const PartOrder& order = *wanted_.parts;
    const auto made = link_parts(shown_, order);
    if (!made) return tl::unexpected(made.error());
    const auto planes = part_planes(shown_, *made, order);
    auto sheet = part_sheet(*made, planes, order);
    if (!linkage_.problem.title.empty()) sheet.plan.title = linkage_.problem.title + ": parts";
    notes_ = made->notes;
    notes_.insert(notes_.end(), planes.notes.begin(), planes.notes.end());
    const ordered_json told = parts_json({*made, planes, sheet, order});
    std::string summary = fmt::format("{} parts in {} planes", made->parts.size(), planes.count);
    if (order.thickness) {
      summary += fmt::format(", {:.6g} high", planes.count * *order.thickness);
    }
    if (wanted_.format != ExportFormat::json) {
      return file(drawn(sheet.plan, wanted_), summary, {{"sheet", told}});
    }
    ordered_json document = {{"format", "cognate-parts/1"}};
    document.update(told);
    return file(written(document), summary);
  }

  ResultLinkage linkage_;
  const ExportOptions& wanted_;
  std::string stem_;
  const Options& options_;
  FollowedMotion<0> motion_;
  ShownLinks shown_;
  std::vector<std::string> notes_;
};

}  // namespace

tl::expected<Exported, std::string> export_linkage(const ResultLinkage& linkage,
                                                   const ExportOptions& wanted,
                                                   const std::string& stem,
                                                   const Options& options) {
  return LinkageExporter(linkage, wanted, stem, options).run();
}

}  // namespace cognate::app
