/// @file The keys of `[layers]` and the metrics of layers, as data.
#pragma once

#include "app/documents/catalogue.hpp"
#include "problems/layers/keys.hpp"

namespace cognate::app {

inline constexpr auto kLayersEntries = entries_of(problems::reading::kLayerKeys);

inline constexpr Metric kLayersMetrics[] = {
    {"layers.count", "1", "fewest layers above the frame in which links pass each other (layers)"},
    {"layers.pin_crossings", "1", "layers that pins cross without holding a link there (layers)"}};

}  // namespace cognate::app
