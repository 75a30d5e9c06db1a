/// @file The keys of `[layers]`, for its reader, what is written of it and `cognate list`.
#pragma once

#include <array>
#include <string_view>

#include "problems/layers/layers.hpp"
#include "problems/toml/keys.hpp"

namespace cognate::problems::reading {

inline constexpr std::string_view kLayersTable = "layers", kLinkWidths = "widths";

inline constexpr NumberRule kPlayRule{[](double x) { return x >= 0 && is_magnitude(x); },
                                      "a length, 0 or from 1e-100 to 1e100,"};

inline constexpr std::array kLayerKeys{
    key<&LayerSizes::link_width>("link_width", "of every link, which has round ends", kLength),
    key<&LayerSizes::pin_diameter>("pin_diameter", "of every pin, no more than a link's width",
                                   kLength),
    key<&LayerSizes::clearance>("clearance",
                                "that links and pins of one layer keep from each other (default 0)",
                                kPlayRule),
    own_key<LayerSizes>(kLinkWidths, "{coupler = 8}: of links that have their own, by name")};

}  // namespace cognate::problems::reading
