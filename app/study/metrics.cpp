#include "app/study/metrics.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <variant>

#include "app/documents/mechanism_catalogue.hpp"
#include "app/kinds/cam/catalogue.hpp"
#include "app/kinds/evaluation/problem_json.hpp"
#include "app/kinds/gear/catalogue.hpp"
#include "app/kinds/machine/catalogue.hpp"
#include "app/kinds/machine/json.hpp"
#include "app/study/design_values.hpp"
#include "problems/evaluation/curve_metrics.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::app {
namespace {

using problems::AnalysisProblem;
using problems::CamProblem;
using problems::MetricNames;
using problems::Problem;

constexpr Metric kExtras[] = {
    {"error.rms", "of the target",
     "root mean square of the errors at the target; of functions with an output angle in radians"},
    {"error.max", "of the target", "the greatest of them, likewise"},
    {"error.sum_of_squares", "of the target", "unweighted; likewise in rad²"},
    {"error.rms_deg", "deg", "functions: of the rocker's angle"},
    {"error.max_deg", "deg", "functions: of the rocker's angle"},
    {"origin", "", "which exact synthesis or search the design came from"},
    {"certificate.lower_bound", "of the target", "with solve.certify"},
    {"certificate.gap_relative", "1", "with solve.certify"},
    {"facts.FACT", "its own", "a fact of a synthesis, as facts.solutions"},
    {"mechanism.KEY", "its own", "a dimension found, as mechanism.coupler_point[0]"}};

constexpr int kMostSlides = 20;

bool is_word(std::string_view unit) {
  return unit.empty() || unit == "boolean";
}

void add(MetricNames& names, std::span<const Metric> listed, std::string_view within = "") {
  for (const Metric& metric : listed) {
    for (const auto& key : single_keys(metric.key)) {
      names.names.push_back({std::string(within) + key, is_word(metric.unit)});
    }
  }
}

/// The place of each extreme of a cam, listed as "..._at_deg".
void add_places_of_extremes(MetricNames& names) {
  for (const Metric& metric : cam_metrics()) {
    for (const auto& key : single_keys(metric.key)) {
      const bool extreme = key.find("_max") != key.npos || key.find("_min") != key.npos;
      if (extreme) names.names.push_back({key + "_at_deg"});
    }
  }
}

/// The tables and keys that the mechanism of a design may have.
void add_mechanisms(MetricNames& names) {
  for (const KeyedEntry& mechanism : mechanisms()) {
    if (mechanism.name == "chain") continue;
    for (const Entry& key : mechanism.keys) {
      names.openings.push_back(fmt::format("mechanism.{}", key.name));
    }
  }
  for (const char* table : {"type", "pivot", "slider", "dyad", "point"}) {
    names.openings.push_back(fmt::format("mechanism.{}", table));
  }
}

void add_cam_mechanism(MetricNames& names) {
  for (const KeyedEntry& follower : cam_followers()) {
    for (const Entry& key : follower.keys) {
      names.openings.push_back(fmt::format("mechanism.{}", key.name));
    }
  }
  for (const char* key :
       {"follower", "side", "closure", "breadth", "arms_deg", "rotation", "motion", "preload"}) {
    names.openings.push_back(fmt::format("mechanism.{}", key));
  }
}

/// What `mechanism` of a gear or pair may hold, and what every design has.
void add_gear_mechanism(MetricNames& names, std::span<const KeyedEntry> tables) {
  for (const KeyedEntry& table : tables) {
    const bool is_rack = table.name == "[rack]";
    if (!is_rack && table.name != "[mechanism]") continue;
    for (const Entry& key : table.keys) {
      names.openings.push_back(fmt::format("mechanism.{}{}", is_rack ? "rack." : "", key.name));
    }
  }
  for (const char* word : {"class", "defects", "origin"}) names.names.push_back({word, true});
}

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

/// Whether the mechanism of `base` has what `name` stands for: measures of a coupler curve are of
/// four-bars, and only those of links need no point that traces it.
bool has(const AnalysisProblem& base, const std::string& name) {
  const auto* measure = problems::find_curve_metric(name);
  if (!measure) return true;
  const auto& linkage = base.mechanism.four_bar;
  return linkage && (linkage->coupler_point || measure->group <= problems::CurveGroup::size);
}

struct NamesOf {
  MetricNames operator()(const Problem&) const {
    MetricNames names;
    add(names, metrics());
    add(names, std::span(kExtras).first<std::size(kExtras) - 2>());  // the last two stand for many
    add(names, facts(), "facts.");
    add_mechanisms(names);
    names.openings.emplace_back("crank_deg");
    return names;
  }
  MetricNames operator()(const CamProblem&) const {
    MetricNames names;
    add(names, cam_metrics());
    add_places_of_extremes(names);
    std::erase_if(names.names, [](const auto& name) { return name.name.starts_with("..."); });
    for (const char* angle : {"min", "max", "acute_min"}) {
      names.names.push_back({fmt::format("transmission_angle_deg.{}", angle)});
    }
    names.names.push_back({"time_ratio"});
    for (const char* word : {"class", "defects", "origin"}) names.names.push_back({word, true});
    add_cam_mechanism(names);
    return names;
  }
  MetricNames operator()(const problems::GearProblem&) const {
    MetricNames names;
    add(names, gear_metrics());
    names.names.push_back({"overlap_ratio"});
    add_gear_mechanism(names, gear_tables());
    return names;
  }
  MetricNames operator()(const problems::GearPairProblem&) const {
    MetricNames names;
    add(names, gear_pair_metrics());
    for (const char* within : {"pinion.", "wheel.", "worm."}) add(names, gear_metrics(), within);
    add(names, facts(), "facts.");
    add_gear_mechanism(names, gear_pair_tables());
    return names;
  }
  MetricNames operator()(const problems::MachineProblem& base) const {
    MetricNames names;
    add(names, machine_metrics());
    add_values(names.names, machine_mechanism_json(base), "mechanism");
    return names;
  }
  MetricNames operator()(const AnalysisProblem& base) const {
    MetricNames names;
    add(names, analysis_metrics());
    std::erase_if(names.names,
                  [](const auto& name) { return name.name.starts_with("reaction_max"); });
    for (const char* of : {"torque_N_m", "drive_force_N"}) {
      for (const char* at : {"min_at", "max_at", "min_at_deg", "max_at_deg", "min_unbounded_at",
                             "max_unbounded_at", "min_unbounded_at_deg", "max_unbounded_at_deg"}) {
        names.names.push_back({fmt::format("{}.{}", of, at)});
      }
    }
    add_reactions(names, base);
    std::erase_if(names.names, [&](const auto& name) { return !has(base, name.name); });
    add_values(names.names, mechanism_json(base.mechanism), "mechanism");
    return names;
  }
};

}  // namespace

MetricNames study_metrics(const problems::Task& base) {
  return std::visit(NamesOf{}, base);
}

tl::expected<problems::Study, std::vector<problems::Fault>> read_study(
    const std::filesystem::path& file) {
  return problems::read_study(file, study_metrics);
}

std::span<const Metric> study_extras() {
  return kExtras;
}

std::vector<std::string> single_keys(std::string_view listed) {
  std::vector<std::string> keys;
  while (!listed.empty()) {
    const auto end = std::min(listed.find(", "), listed.size());
    const std::string_view key = listed.substr(0, end);
    if (key == "...") {
      const std::string stem = keys.front().substr(0, keys.front().rfind('_') + 1);
      for (int i = static_cast<int>(keys.size()) + 1; i <= kMostSlides; ++i) {
        keys.push_back(stem + std::to_string(i));
      }
    } else if (key.starts_with("_at_")) {
      keys.push_back(keys.front().substr(0, keys.front().rfind("_at_")).append(key));
    } else {
      keys.emplace_back(key);
    }
    listed.remove_prefix(std::min(end + 2, listed.size()));
  }
  return keys;
}

}  // namespace cognate::app
