/// @file The keys of `[layers]`, for its reader, what is written of it and `cognate list`.
#pragma once

#include <array>
#include <string_view>

#include "analysis/layers/stacking.hpp"
#include "problems/layers/layers.hpp"
#include "problems/toml/keys.hpp"

namespace cognate::problems::reading {

inline constexpr std::string_view kLayersTable = "layers", kLinkWidths = "widths";

inline constexpr NumberRule kPlayRule{[](double x) { return x >= 0 && is_magnitude(x); },
                                      "a length, 0 or from 1e-100 to 1e100"};

inline constexpr std::array kLayerKeys{
    key<&LayerSizes::link_width>("link_width", "of every link, which has round ends", kLength),
    key<&LayerSizes::pin_diameter>("pin_diameter", "of every pin, no more than a link's width",
                                   kLength),
    key<&LayerSizes::clearance>("clearance",
                                "that links and pins of one layer keep from each other (default 0)",
                                kPlayRule),
    key<&LayerSizes::thickness>("thickness", "of every link, for the bill of material", kLength),
    own_key<LayerSizes>(kLinkWidths, "{coupler = 8}: of links that have their own, by name")};

inline constexpr std::string_view kLayersMeaning = "in how many layers the links pass each other";

/// Of `[constraints]`. Links on one pin lie in different layers: no linkage has one layer alone.
inline constexpr std::array kLayersMaxKeys{key<&DesignLayers::max>(
    "layers_max", "with [layers]: the most layers above the frame that the links may need",
    IntegerRule{2, kMostStackedLinks})};

}  // namespace cognate::problems::reading
