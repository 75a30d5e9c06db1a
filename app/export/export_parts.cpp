#include "app/export/export_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "app/documents/json_values.hpp"
#include "app/documents/result_json.hpp"
#include "app/export/export_solids.hpp"
#include "app/export/linkage_json.hpp"
#include "app/export/parts/part_sheet.hpp"
#include "app/export/parts/stacked_parts.hpp"
#include "app/export/svg.hpp"
#include "synthesis/search/deadline.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

using Ordered = tl::expected<PartOrder, std::string>;

/// The order with its bearing in the linkage's lengths, and the bearing's bore as its hole.
Ordered with_bearing(PartOrder order, double millimetre) {
  if (!order.bearing) return order;
  Bearing& bearing = *order.bearing;
  for (double* size : {&bearing.bore, &bearing.outside, &bearing.width}) *size *= millimetre;
  if (order.hole > 0 && std::abs(order.hole - bearing.bore) > 1e-9 * bearing.bore) {
    return tl::unexpected(
        fmt::format("--hole: {:.6g} is not the bore of the bearing {}; allowed is {:.6g}, or no "
                    "--hole",
                    order.hole, bearing.designation, bearing.bore));
  }
  order.hole = bearing.bore;
  return order;
}

/// Likewise with its screw, the washers of that and, where none is ordered, its hole.
Ordered with_screw(PartOrder order, double millimetre) {
  if (!order.screw) return order;
  const Screw screw = order.screw->scaled(millimetre);
  if (order.hole == 0) order.hole = screw.hole;
  if (!order.thickness) {
    return tl::unexpected(
        std::string("--screw: its length follows from the thickness of the parts; expected "
                    "--thickness T with it"));
  }
  constexpr double kRounding = 1e-9;
  if (!(order.hole >= screw.diameter * (1 - kRounding))) {
    return tl::unexpected(
        fmt::format("--hole: {:.6g} is too small for the screw {}; allowed is {:.6g} or more",
                    order.hole, screw.designation, screw.diameter));
  }
  order.screw = screw;
  order.washer = screw.washer_thickness;
  order.washer_outside = screw.washer_outside;
  return order;
}

/// The order in the linkage's lengths.
Ordered in_lengths_of(std::optional<problems::LengthUnit> unit, PartOrder order) {
  if (!order.bearing && !order.screw) return order;
  if (!unit) {
    return tl::unexpected(
        fmt::format("{}: its sizes are millimetres, and the file names no unit of length; expected "
                    "--length-unit mm, cm, m or in with it",
                    order.bearing ? "--bearing" : "--screw"));
  }
  const double millimetre = 1e-3 / metres(unit);
  return with_bearing(std::move(order), millimetre).and_then([&](PartOrder borne) {
    return with_screw(std::move(borne), millimetre);
  });
}

/// The order with what it leaves open as the file's layers have it.
Ordered completed(PartOrder order, const std::optional<problems::LayerSizes>& sizes) {
  const bool no_hole = order.hole == 0 && !order.bearing && !order.screw;
  const bool no_width = order.width == 0;
  if (!sizes && no_hole && no_width) {
    return tl::unexpected(
        std::string("--parts: --hole and --width are missing; expected both with a LENGTH, or a "
                    "file with [layers]"));
  }
  if (!sizes && (no_hole || no_width)) {
    return tl::unexpected(
        fmt::format("--parts: {0} is missing; expected {0} LENGTH, or a file with [layers]",
                    no_hole ? "--hole" : "--width"));
  }
  if (!sizes) return order;
  const PartOrder of_file = part_order(*sizes);
  if (no_hole) order.hole = of_file.hole;
  if (no_width) {
    order.width = of_file.width;
    order.widths = of_file.widths;
    order.apart = of_file.apart;
  }
  if (!order.thickness) order.thickness = of_file.thickness;
  return order;
}

std::string parts_summary(const LinkParts& made, const PartLayers& layers, const PartSheet& sheet,
                          const PartOrder& order) {
  const auto cut =
      std::ranges::count_if(made.parts, [](const auto& part) { return !part.cylinder; });
  std::string summary = fmt::format("{} parts in {} layers", cut, layers.count);
  if (const auto height = stack_height(layers.count, order)) {
    summary += fmt::format(", {:.6g} high", *height);
  }
  if (order.sheet) {
    summary += fmt::format(", on {} sheet{}, of which they take {:.1f} %", sheet.sheets,
                           sheet.sheets == 1 ? "" : "s", 100 * sheet.utilisation);
  }
  return summary;
}

/// The sheet or the document.
tl::expected<Exported, std::string> parts_file(const PartSheet& sheet, const ordered_json& table,
                                               const std::string& name,
                                               std::optional<problems::LengthUnit> unit,
                                               const ExportOptions& wanted) {
  const auto one = [&](std::string text) {
    return Exported{{{name, std::move(text)}}, {}, {}, ordered_json::object()};
  };
  if (wanted.format == ExportFormat::json) {
    ordered_json document = {{"format", "cognate-parts/1"}};
    document.update(table);
    return document_text(document).map(one);
  }
  auto made = drawn_text(sheet.plan, unit, wanted).map(one);
  if (made) made->quantities["sheet"] = table;
  return made;
}

/// The parts and spacers side by side.
tl::expected<Exported, std::string> parts_sheet(const LinkageScene& scene, StackedParts parts,
                                                const ExportOptions& wanted,
                                                const std::string& stem) {
  LinkParts made = parts.made;
  PartLayers layers = parts.layers;
  if (parts.order.spacers) add_spacer_parts(parts.bill, parts.order, made, layers);
  auto sheet = part_sheet(made, layers, parts.order);
  if (!sheet) return tl::unexpected(sheet.error());
  if (!scene.problem.title.empty()) sheet->plan.title = scene.problem.title + ": parts";
  auto written = parts_file(*sheet, parts_json({made, layers, *sheet, parts.bill, parts.order}),
                            fmt::format("{}.parts.{}", stem, declaration(wanted.format).word),
                            scene.problem.length_unit, wanted);
  if (written) written->summary = parts_summary(made, layers, *sheet, parts.order);
  return written;
}

tl::expected<Exported, std::string> parts_solids(const PosedLinkage& linkage,
                                                 const StackedParts& parts,
                                                 const ExportOptions& wanted,
                                                 const std::string& stem) {
  if (!parts.order.thickness) {
    return tl::unexpected(
        std::string("--format: solids have a thickness; expected --thickness T with it"));
  }
  const auto& problem = linkage.scene.problem;
  constexpr double kShare = 1e-4;  // of the linkage's size
  SolidAssembly assembly =
      empty_assembly(problem.title.empty() ? stem : problem.title, problem.length_unit);
  assembly.chord_tolerance = wanted.chord_tolerance.value_or(kShare * size_of(linkage.shown));
  assembly.solids = linkage_solids(parts, linkage.bodies);
  auto made = export_solids(assembly, wanted, stem);
  if (!made) return made;
  made->summary += fmt::format(" in {} layers, {:.6g} high", parts.layers.count,
                               *stack_height(parts.layers.count, parts.order));
  if (!problem.length_unit) made->notes.push_back(kMillimetresAssumed);
  if (parts.order.washer > 0 && parts.order.washer_outside == 0) {
    made->notes.emplace_back(
        "washers are left out: their outside diameter is not chosen; --washer TxD chooses it");
  }
  return made;
}

}  // namespace

tl::expected<std::string, std::string> drawn_text(Plan plan,
                                                  std::optional<problems::LengthUnit> unit,
                                                  const ExportOptions& wanted) {
  plan.length_unit = unit;
  if (!std::isfinite(norm(plan.high - plan.low))) {
    return tl::unexpected(
        std::string("the linkage is too large to be drawn; lengths up to 1e100 are allowed"));
  }
  return wanted.format == ExportFormat::svg ? svg_text(plan) : dxf_text(plan, wanted.version);
}

tl::expected<std::string, std::string> document_text(const ordered_json& document) {
  if (find_non_finite(document)) {
    return tl::unexpected(
        std::string("the linkage is too large to be written; lengths up to 1e100 are allowed"));
  }
  return write_json(document);
}

tl::expected<Exported, std::string> export_parts(const PosedLinkage& linkage,
                                                 const ExportOptions& wanted,
                                                 const std::string& stem, const Options& options) {
  const auto& problem = linkage.scene.problem;
  const auto order = completed(*wanted.parts, linkage.scene.layers).and_then([&](auto complete) {
    return in_lengths_of(problem.length_unit, std::move(complete));
  });
  if (!order) return tl::unexpected(order.error());
  const synthesis::Deadline deadline(options.time_limit.value_or(kInfinity));
  const auto parts = stacked_parts(problem.mechanism.mechanism, linkage.shown, *order,
                                   [&] { return deadline.reached(); });
  if (!parts) return tl::unexpected(parts.error());
  const auto& [made, layers, bill, bosses] = *parts;
  auto written =
      declaration(wanted.format).is_solid()
          ? parts_solids(linkage, {made, layers, bill, bosses, *order}, wanted, stem)
          : parts_sheet(linkage.scene, {made, layers, bill, bosses, *order}, wanted, stem);
  if (!written) return written;
  const auto add = [&](const std::vector<std::string>& notes) {
    std::ranges::copy(notes, std::back_inserter(written->notes));
  };
  add(made.notes);
  add(layers.notes);
  add(bill.notes);
  add(bosses.notes);
  if (order->bill) {
    written->files.push_back({stem + ".bill.csv", bill_csv(bill, problem.length_unit)});
  }
  return written;
}

}  // namespace cognate::app
