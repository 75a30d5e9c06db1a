#include "app/documents/result_json.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/documents/json_values.hpp"
#include "app/documents/layers_json.hpp"
#include "app/documents/tolerance_json.hpp"
#include "app/documents/version.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/constraint_words.hpp"
#include "problems/mechanism/write_mechanism.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::to_string;

ordered_json error_json(const problems::TargetError& error, bool angular) {
  ordered_json table = {
      {"sum_of_squares", error.sum_of_squares}, {"rms", error.rms}, {"max", error.max}};
  if (angular) {
    table["rms_deg"] = degrees(error.rms);
    table["max_deg"] = degrees(error.max);
  }
  return table;
}

void set_finite(ordered_json& table, const std::string& key, const std::optional<double>& value) {
  if (value && std::isfinite(*value)) table[key] = *value;
}

ordered_json metrics_json(const problems::Metrics& metrics) {
  ordered_json table = ordered_json::object();
  if (metrics.mobility) table["class"] = to_string(*metrics.mobility);
  add_finite_quantities(table, metrics.quantities);
  table["change_point"] = metrics.change_point;
  table["transmission_angle_deg"] = {{"min", degrees(metrics.transmission_min)},
                                     {"max", degrees(metrics.transmission_max)},
                                     {"acute_min", degrees(metrics.transmission_acute_min)}};
  table["time_ratio"] = metrics.time_ratio ? ordered_json(*metrics.time_ratio) : nullptr;
  table["defects"] = ordered_json::array();
  for (const auto defect : metrics.defects) table["defects"].push_back(to_string(defect));
  for (const problems::CycleDeclaration& quantity : problems::kCycleQuantities) {
    set_finite(table, std::string(quantity.key()), metrics.cycle[quantity.id]);
  }
  if (metrics.input_start) table["input_start_deg"] = degrees(*metrics.input_start);
  if (metrics.output_start) table["output_start_deg"] = degrees(*metrics.output_start);
  set_finite(table, "precision_residual", metrics.precision_residual);
  set_finite(table, "condition", metrics.condition);
  return table;
}

/// The JSON of one side of a check; infinite numbers, which JSON cannot hold, give null.
struct CheckedValue {
  ordered_json operator()(double value) const {
    return std::isfinite(value) ? ordered_json(value) : nullptr;
  }
  ordered_json operator()(const std::string& value) const { return value; }
  ordered_json operator()(const problems::Range& value) const { return to_json(value); }
};

/// A branch ends where a point is not finite, and another begins after it.
ordered_json locus_json(const problems::Locus& locus) {
  ordered_json branches = ordered_json::array();
  for (const auto& branch : locus.branches) {
    ordered_json points = ordered_json::array();
    for (const Vec2d& point : branch) {
      if (std::isfinite(point.x) && std::isfinite(point.y)) {
        points.push_back(to_json(point));
      } else if (!points.empty()) {
        branches.push_back(std::exchange(points, ordered_json::array()));
      }
    }
    if (!points.empty()) branches.push_back(points);
  }
  return {{"name", locus.name}, {"branches", branches}};
}

ordered_json family_json(const problems::Family& family) {
  ordered_json columns = ordered_json::array();
  for (const auto& column : family.columns) {
    ordered_json values = ordered_json::array();
    for (const double value : column.values) {
      values.push_back(std::isfinite(value) ? ordered_json(value) : nullptr);
    }
    columns.push_back({{"name", column.name}, {"values", values}});
  }
  return {{"name", family.name}, {"columns", columns}};
}

bool is_row(const ordered_json& value) {
  return value.is_array() && std::ranges::none_of(value, &ordered_json::is_structured);
}

/// Appends the text of `value`; `line` is a line break and the present indentation.
void append_json(std::string& text, const ordered_json& value, const std::string& line) {
  if (!value.is_structured() || value.empty() || is_row(value)) {
    text += value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    return;
  }
  const std::string inner = line + "  ";
  text += value.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, member] : value.items()) {
    if (!first) text += ',';
    first = false;
    text += inner;
    if (value.is_object()) {
      text += ordered_json(key).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
      text += ": ";
    }
    append_json(text, member, inner);
  }
  text += line;
  text += value.is_object() ? '}' : ']';
}

}  // namespace

ordered_json document_head(problems::Status status, std::uint64_t seed, ordered_json problem) {
  return {{"format", "cognate-result/1"},
          {"version", version()},
          {"seed", seed},
          {"status", to_string(status)},
          {"problem", std::move(problem)}};
}

tl::expected<ordered_json, std::string> finished_document(ordered_json document,
                                                          const Sentences& sentences,
                                                          const problems::Work& work) {
  document["warnings"] = sentences.warnings;
  document["notes"] = sentences.notes;
  document["work"] = to_json(work);
  if (const auto where = find_non_finite(document)) {
    return tl::unexpected(fmt::format("the result has no finite number at {}", *where));
  }
  return document;
}

ordered_json mechanism_json(const problems::NamedMechanism& mechanism) {
  return to_json(problems::reading::mechanism_writer(mechanism).take());
}

ordered_json design_json(const problems::Design& design, bool angular) {
  ordered_json table = {{"mechanism", mechanism_json(design.mechanism)}};
  const bool slides = driven_by_length(design.mechanism.mechanism.drive);
  auto& stations = table[slides ? "slide" : "crank_deg"] = ordered_json::array();
  for (const double at : design.crank_angles) stations.push_back(slides ? at : degrees(at));
  table["error"] = error_json(design.error, angular);
  table["metrics"] = metrics_json(design.metrics);
  table["constraints"] = ordered_json::array();
  for (const auto& check : design.constraints) {
    table["constraints"].push_back(to_json(check, angular));
  }
  table["warnings"] = design.warnings;
  table["origin"] = design.origin;
  if (design.cognate_of) table["cognate_of"] = *design.cognate_of;
  if (design.mirror_of) table["mirror_of"] = *design.mirror_of;
  if (design.twin_of) table["twin_of"] = *design.twin_of;
  if (!design.differs.empty()) table["differs"] = design.differs;
  if (design.tolerance) table["tolerance"] = tolerance_json(*design.tolerance);
  if (design.layers) table["layers"] = layers_json(*design.layers, slides);
  return table;
}

void add_linkage_facts(ordered_json& document, const problems::Result& result) {
  if (!result.quantities.empty()) add_finite_quantities(document["facts"], result.quantities);
  if (const auto& proof = result.certificate) {
    document["certificate"] = {{"lower_bound", proof->lower_bound},
                               {"upper_bound", proof->upper_bound},
                               {"gap_relative", proof->gap_relative},
                               {"complete", proof->complete},
                               {"boxes", proof->boxes},
                               {"domain", proof->domain}};
  }
}

void add_linkage_findings(ordered_json& document, const problems::Result& result) {
  for (const auto& locus : result.loci) document["loci"].push_back(locus_json(locus));
  for (const auto& family : result.families) document["families"].push_back(family_json(family));
  add_linkage_facts(document, result);
}

void add_finite_quantities(ordered_json& table, std::vector<problems::Quantity> quantities) {
  std::erase_if(quantities, [](const problems::Quantity& quantity) {
    const auto* number = std::get_if<double>(&quantity.value);
    return number != nullptr && !std::isfinite(*number);
  });
  add_quantities(table, quantities);
}

ordered_json to_json(const problems::ConstraintCheck& check, bool angular) {
  const problems::ConstraintWords words = problems::words_of(check, angular);
  return {{"name", check.name},
          {"label", words.label},
          {"relation", words.relation},
          {"unit", words.unit},
          {"value", std::visit(CheckedValue{}, check.value)},
          {"bound", std::visit(CheckedValue{}, check.bound)},
          {"satisfied", check.satisfied}};
}

ordered_json to_json(const problems::Work& work) {
  return {{"seconds", work.seconds},
          {"threads", work.threads},
          {"candidates", work.candidates},
          {"positions", work.positions},
          {"velocities", work.velocities},
          {"accelerations", work.accelerations},
          {"reactions", work.reactions},
          {"gradients", work.gradients},
          {"solver_iterations", work.solver_iterations},
          {"skipped", work.skipped}};
}

std::string write_json(const ordered_json& document) {
  std::string text;
  append_json(text, document, "\n");
  return text + '\n';
}

}  // namespace cognate::app
