#include "app/study/metrics.hpp"

#include <algorithm>

#include "app/kinds/kinds.hpp"

namespace cognate::app {
namespace {

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
