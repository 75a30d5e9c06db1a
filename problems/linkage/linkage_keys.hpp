/// @file The dimensions of a linkage by their keys, which `[mechanism]` gives and `[bounds]`
/// limits, and the key of what is reported of it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "analysis/linkage/four_bar.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

struct LinkKey {
  std::string_view key;
  double Lengths<double>::*length;
  std::optional<double> Given::*given;
  std::optional<Range> Bounds::*bounds;
};

inline constexpr std::array kLinkKeys{
    LinkKey{"crank", &Lengths<double>::crank, &Given::crank, &Bounds::crank},
    LinkKey{"coupler", &Lengths<double>::coupler, &Given::coupler, &Bounds::coupler},
    LinkKey{"rocker", &Lengths<double>::rocker, &Given::rocker, &Bounds::rocker},
    LinkKey{"frame", &Lengths<double>::frame, &Given::frame, &Bounds::frame}};

/// A place and the names of its coordinates.
struct BoundedPlaceKey {
  std::string_view key, first, second;
  std::optional<Vec2d> Given::*given;
  std::optional<Box> Bounds::*bounds;
  std::optional<Vec2d> (*of)(const FourBar& linkage);
};

inline constexpr std::array kPlaceKeys{
    BoundedPlaceKey{"pivot_a", "x", "y", &Given::pivot_a, &Bounds::pivot_a,
                    [](const FourBar& linkage) { return std::optional(linkage.pivot_a); }},
    BoundedPlaceKey{"pivot_d", "x", "y", &Given::pivot_d, &Bounds::pivot_d,
                    [](const FourBar& linkage) { return std::optional(linkage.pivot_d); }},
    BoundedPlaceKey{"coupler_point", "u", "v", &Given::coupler_point, &Bounds::coupler_point,
                    [](const FourBar& linkage) { return linkage.coupler_point; }}};

/// Reported of a four-bar with a change point: parallelogram, kite, …
inline constexpr QuantityKey<std::string> kChangePointKindKey{"change_point_kind"};

}  // namespace cognate::problems
