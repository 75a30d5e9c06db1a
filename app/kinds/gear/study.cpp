#include <fmt/core.h>

#include "app/kinds/gear/kind.hpp"
#include "app/study/metrics.hpp"

namespace cognate::app {
namespace {

using problems::MetricNames;

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

}  // namespace

MetricNames Kind<problems::GearProblem>::metric_names(const problems::GearProblem& /*base*/) {
  MetricNames names;
  add_metrics(names, gear_metrics());
  names.names.push_back({"overlap_ratio"});
  add_gear_mechanism(names, gear_tables());
  return names;
}

MetricNames Kind<problems::GearPairProblem>::metric_names(
    const problems::GearPairProblem& /*base*/) {
  MetricNames names;
  add_metrics(names, gear_pair_metrics());
  for (const char* within : {"pinion.", "wheel.", "worm.", "rack."})
    add_metrics(names, gear_metrics(), within);
  add_metrics(names, quantities(), "facts.");
  add_gear_mechanism(names, gear_pair_tables());
  return names;
}

}  // namespace cognate::app
