#include "app/study/metrics.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "app/documents/layers_catalogue.hpp"
#include "app/documents/tolerance_catalogue.hpp"
#include "app/kinds/kinds.hpp"

namespace cognate::app {
namespace {

/// What names end with or have before the part they belong to.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kNamed = {
    {{"_deg", "deg"}, {"_N_m", "N m"}, {"_N", "N"}}};

/// Keys of mechanisms and bounds that hold a length.
constexpr std::array<std::string_view, 12> kLengths = {
    "crank",       "coupler",       "rocker",          "frame", "offset",      "length",
    "base_radius", "roller_radius", "centre_distance", "arm",   "face_offset", "stroke"};

/// Whether `part` ends `name` or stands before the part it belongs to.
bool ends_part(std::string_view name, std::string_view part) {
  const auto at = name.find(part);
  if (at == std::string_view::npos) return false;
  const auto behind = name.substr(at + part.size());
  return behind.empty() || behind.front() == '.';
}

std::string unit_in(std::string_view name) {
  for (const auto& [part, unit] : kNamed) {
    const auto at = name.find(part);
    if (at == std::string_view::npos) continue;
    const auto behind = name.substr(at + part.size());
    if (behind.empty() || behind.front() == '.' || behind.front() == '_') return std::string(unit);
  }
  return "";
}

/// A metric of a gear of a pair without the gear's name.
std::string_view of_gear(std::string_view name) {
  for (const std::string_view gear : {"pinion.", "wheel.", "worm.", "rack."}) {
    if (name.starts_with(gear)) return name.substr(gear.size());
  }
  return name;
}

using problems::MetricNames;

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

}  // namespace

std::string metric_unit(std::string_view name) {
  if (ends_part(name, "_at_deg")) return "deg";
  if (ends_part(name, "_at")) return "length";
  name = of_gear(name);
  for (const MetricList& list : metric_lists()) {
    if (!list.of_design) continue;
    for (const Metric& metric : list.metrics) {
      const auto keys = single_keys(metric.key);
      if (std::ranges::find(keys, name) == keys.end()) continue;
      const bool is_bare = metric.unit == "1" || metric.unit == "boolean";
      return is_bare ? "" : std::string(metric.unit);
    }
  }
  const auto key = name.substr(name.rfind('.') + 1);
  if (std::ranges::find(kLengths, key) != kLengths.end()) return "length";
  return unit_in(name);
}

void add_metrics(MetricNames& names, std::span<const Metric> listed, std::string_view within) {
  for (const Metric& metric : listed) {
    for (const auto& key : single_keys(metric.key)) {
      names.names.push_back({std::string(within) + key, is_word(metric.unit)});
    }
  }
}

MetricNames study_metrics(const problems::Task& base) {
  return visit_kind(base,
                    [](auto kind, const auto& problem) { return kind.metric_names(problem); });
}

tl::expected<problems::Study, std::vector<problems::Fault>> read_study(
    const std::filesystem::path& file) {
  return problems::read_study(file, study_metrics);
}

std::vector<MetricList> metric_lists() {
  std::vector<MetricList> all{{"metrics", "metric of a design", metrics()}};
  problems::for_each_kind([&]<class Problem>(std::type_identity<Problem>) {
    const auto own = Kind<Problem>::metric_lists();
    all.insert(all.end(), own.begin(), own.end());
  });
  all.push_back({"tolerance_metrics", "metric where a file has tolerances", kToleranceMetrics});
  all.push_back({"layers_metrics", "metric of designs where a file has layers", kLayersMetrics});
  all.push_back({"facts", "fact of a synthesis", quantities(), false});
  all.push_back({"study_metrics", "further metric of a study", study_extras()});
  return all;
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
