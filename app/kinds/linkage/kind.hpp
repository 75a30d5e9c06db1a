/// @file What the program does alike with all kinds that design a linkage.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/console/table.hpp"
#include "app/kinds/basics/kind.hpp"
#include "app/report/design_drawing.hpp"
#include "app/report/page.hpp"
#include "app/report/report_data.hpp"
#include "problems/chain/topology.hpp"

namespace cognate::app {

/// What a study may ask of the best design of a synthesis.
problems::MetricNames linkage_metric_names();

/// Also, of a design that is one of these chains, the transmission angle of each of its joints.
problems::MetricNames chain_metric_names(std::span<const problems::Topology> topologies);

/// The size of a design that is a four-bar, among its metrics.
void add_size(nlohmann::ordered_json& metrics, const problems::NamedMechanism& mechanism);

/// Adds to each of the first designs of a page's data the bill of its parts.
void add_bills(const problems::Result& result, const problems::LayerSizes& sizes,
               nlohmann::ordered_json& data);

/// The page of designs. With the kernel of mechanisms, where one that is no four-bar is moved by
/// the page.
std::string linkage_page(bool moves, const problems::Result& result);

/// Why `cognate analyze` takes no problem of these kinds.
inline constexpr const char* kDesignsLinkage =
    "kind is that of a design problem, which 'cognate solve' solves; expected kind = \"analysis\" "
    "with a whole [mechanism]";

/// In addition to what every kind has, each of these has
/// - `kMethods` and `keys()`, how its designs are found and what `cognate list` says of its keys;
/// - `columns(problem)`, the columns of designs in addition to those of all kinds;
/// - `target_json(problem)`, what the page draws of its target.
template <class Problem>
struct LinkageKind : KindBase<Problem, problems::Result> {
  using Result = problems::Result;
  using Json = nlohmann::ordered_json;

  static std::string refusal(const Problem& /*problem*/, Command command) {
    return command == Command::solve ? "" : kDesignsLinkage;
  }

  static Result run(const Problem& problem, const problems::Run& run) {
    return solve(problem, run);
  }

  static Json design_json(const Problem& problem, const Result& result, std::size_t index) {
    const bool angular = Kind<Problem>::columns(problem).error_unit == "deg";
    return app::design_json(result.designs[index], angular);
  }

  static void add_facts(Json& table, const Result& result) { add_linkage_facts(table, result); }

  static void add_findings(Json& document, const Problem& /*problem*/, const Result& result) {
    add_linkage_findings(document, result);
  }

  /// Without a limit of layers those are looked at only where a name asks for them.
  static Evaluated evaluate(const Problem& problem, const std::vector<std::string>& names,
                            const problems::Run& run) {
    Problem asked = problem;
    const auto of_layers = [](const std::string& name) { return name.starts_with("layers."); };
    const bool is_limited = asked.layers && asked.layers->max;
    if (!is_limited && std::ranges::none_of(names, of_layers)) asked.layers.reset();
    const Result result = solve(asked, run);
    Evaluated evaluated{result.status, LinkageKind::best_design_json(problem, result)};
    if (!result.designs.empty()) {
      add_size(evaluated.design["metrics"], result.designs.front().mechanism);
    }
    return evaluated;
  }

  static std::string table(const Problem& problem, const Result& result, const Screen& screen) {
    return design_table(Kind<Problem>::describe(problem), Kind<Problem>::columns(problem), result,
                        screen);
  }

  static std::string page(const Problem& problem, const Result& result) {
    const bool moves = problem.tolerances.has_value() || Kind<Problem>::edits(problem);
    return linkage_page(moves, result);
  }

  /// Whether the page edits designs that are no four-bars: the kernel of pages evaluates those of
  /// which all dimensions are given.
  static bool edits(const Problem& /*problem*/) { return false; }

  static Json report_data(const Problem& problem, const Result& result) {
    Json data = app::report_data(result, Kind<Problem>::target_json(problem),
                                 problem.constraints.transmission_angle,
                                 [&](const problems::Design& design) {
                                   return Kind<Problem>::reached_json(problem, design);
                                 });
    if (problem.layers) add_bills(result, problem.layers->sizes, data);
    return data;
  }

  /// What a design reaches at the targets, or how it errs.
  static Json reached_json(const Problem& /*problem*/, const problems::Design& design) {
    return reached_points(design);
  }

  static problems::MetricNames metric_names(const Problem& /*base*/) {
    return linkage_metric_names();
  }
};

}  // namespace cognate::app
