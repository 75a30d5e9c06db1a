#include <fmt/core.h>

#include <algorithm>

#include "app/documents/json_values.hpp"
#include "app/documents/tolerance_catalogue.hpp"
#include "app/kinds/evaluation/kind.hpp"
#include "app/study/design_values.hpp"
#include "app/study/metrics.hpp"
#include "problems/evaluation/curve_metrics.hpp"
#include "problems/linkage/gait_quantities.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::AnalysisProblem;
using problems::MetricNames;
using Names = std::vector<std::string>;

constexpr std::string_view kOfLayers = "layers.";

/// The joint whose force has this column, "B_on_coupler_Fx_N" or "block_on_bar_N"; one column of
/// each joint has one.
std::optional<std::string> joint_of_force(std::string_view column) {
  const bool of_joint = column.find("_on_") != column.npos;
  for (const std::string_view ending : {"_Fx_N", "_Fy_N", "_N"}) {
    if (!column.ends_with(ending)) continue;
    column.remove_suffix(ending.size());
    return of_joint && ending != "_Fy_N" ? std::optional(std::string(column)) : std::nullopt;
  }
  return std::nullopt;
}

/// The keys of reactions, one for each joint: "reaction_max_N.B_on_coupler".
void add_reactions(MetricNames& names, AnalysisProblem base) {
  base.drive.steps = 1;
  base.output = no_columns();
  base.output.reactions = true;
  problems::Run run;
  run.threads = 1;
  const auto result = problems::analyse(base, run);
  for (const auto& column : result.columns) {
    const auto joint = joint_of_force(column.name);
    if (!joint) continue;
    for (const char* of : {"reaction_max_N", "reaction_max_at_deg", "reaction_max_at",
                           "reaction_max_unbounded_at_deg", "reaction_max_unbounded_at"}) {
      names.names.push_back({fmt::format("{}.{}", of, *joint)});
    }
  }
}

bool is_of_gait(const std::string& name) {
  static const auto all = problems::gait_quantities({});
  return std::ranges::find(all, name, &problems::Quantity::name) != all.end();
}

/// Whether the mechanism of `base` has what `name` stands for: measures of a coupler curve are of
/// four-bars, and only those of links need no point that traces it; those of a gait need a foot.
bool has(const AnalysisProblem& base, const std::string& name) {
  if (is_of_gait(name)) return base.output.foot.has_value();
  const auto* measure = problems::find_curve_metric(name);
  if (!measure) return true;
  const FourBar* linkage = base.mechanism.four_bar();
  return linkage && (linkage->coupler_point || measure->group <= problems::CurveGroup::size);
}

bool any_starts(const Names& names, std::initializer_list<std::string_view> openings) {
  return std::ranges::any_of(names, [&](const std::string& name) {
    return std::ranges::any_of(openings, [&](auto opening) { return name.starts_with(opening); });
  });
}

/// Those of the coupler curve that have a name here.
std::vector<problems::Quantity> quantities_of_curve(const AnalysisProblem& problem,
                                                    const Names& names) {
  std::vector<problems::Quantity> quantities;
  if (!problem.mechanism.four_bar()) return quantities;
  const FourBar& linkage = *problem.mechanism.four_bar();
  problems::CurveValues values;
  values.begin(linkage, circuit_at(linkage, problem.drive.start));
  for (const auto& metric : problems::curve_metrics()) {
    if (std::ranges::find(names, metric.key) == names.end()) continue;
    if (const auto value = values(metric)) quantities.push_back({std::string(metric.key), *value});
  }
  return quantities;
}

/// The quantities of the motion need no column but those of forces.
problems::AnalysisOutput needed_output(const Names& names, const problems::AnalysisOutput& of) {
  problems::AnalysisOutput output = no_columns();
  output.foot = of.foot;
  output.duty = of.duty;
  output.reactions = any_starts(names, {"reaction_max", "power_residual"});
  output.torque = any_starts(names, {"torque_N_m", "drive_force_N", "power_residual"});
  return output;
}
}  // namespace

MetricNames Kind<AnalysisProblem>::metric_names(const AnalysisProblem& base) {
  MetricNames names;
  add_metrics(names, metric_lists().front().metrics);
  if (base.tolerances) add_metrics(names, kToleranceMetrics);
  std::erase_if(names.names,
                [](const auto& name) { return name.name.starts_with("reaction_max"); });
  for (const char* of : {"torque_N_m", "drive_force_N"}) {
    for (const char* extreme : {"min", "max", "abs_max"}) {
      for (const char* at : {"at", "at_deg", "unbounded_at", "unbounded_at_deg"}) {
        names.names.push_back({fmt::format("{}.{}_{}", of, extreme, at)});
      }
    }
  }
  add_reactions(names, base);
  std::erase_if(names.names, [&](const auto& name) {
    return !has(base, name.name) || (!base.layers && name.name.starts_with(kOfLayers));
  });
  add_values(names.names, mechanism_json(base.mechanism), "mechanism");
  return names;
}

Evaluated Kind<AnalysisProblem>::evaluate(const AnalysisProblem& problem, const Names& names,
                                          const problems::Run& run) {
  AnalysisProblem asked = problem;
  asked.output = needed_output(names, problem.output);
  if (!any_starts(names, {"tolerance_"})) asked.tolerances.reset();
  if (!any_starts(names, {kOfLayers})) asked.layers.reset();
  const auto result = problems::analyse(asked, run);
  Evaluated evaluated{result.status, ordered_json::object()};
  if (result.closed_rows == 0) return evaluated;
  ordered_json& metrics = evaluated.design["metrics"];
  add_quantities(metrics, result.quantities);
  add_quantities(metrics, quantities_of_curve(problem, names));
  metrics["defects"] = ordered_json::array();
  if (any_starts(names, {"mechanism."})) {
    evaluated.design["mechanism"] = mechanism_json(asked.mechanism);
  }
  return evaluated;
}

}  // namespace cognate::app
