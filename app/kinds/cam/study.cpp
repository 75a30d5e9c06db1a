#include <fmt/core.h>

#include "app/documents/tolerance_catalogue.hpp"
#include "app/kinds/cam/kind.hpp"
#include "app/study/metrics.hpp"

namespace cognate::app {
namespace {

using problems::MetricNames;

/// The place of each extreme of a cam, listed as "..._at_deg".
void add_places_of_extremes(MetricNames& names) {
  for (const Metric& metric : cam_metrics()) {
    for (const auto& key : single_keys(metric.key)) {
      const bool extreme = key.find("_max") != key.npos || key.find("_min") != key.npos;
      if (extreme) names.names.push_back({key + "_at_deg"});
    }
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

}  // namespace

MetricNames Kind<problems::CamProblem>::metric_names(const problems::CamProblem& /*base*/) {
  MetricNames names;
  add_metrics(names, cam_metrics());
  add_metrics(names, kToleranceMetrics);
  add_metrics(names, quantities(), "facts.");
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

}  // namespace cognate::app
