/// @file A load on a mechanism, as a file gives it.
#pragma once

#include <optional>
#include <utility>

#include "analysis/mechanism/mechanism.hpp"
#include "problems/basics/names.hpp"

namespace cognate::problems {

/// `advance`: while the body it acts on moves in its positive sense (along its guide, or
/// counter-clockwise), `retreat` (written "return"): in the negative sense.
enum class LoadSense { always, advance, retreat };

template <>
std::span<const Named<LoadSense>> names<LoadSense>();

/// `[[load]]`.
struct LoadRule {
  Attached<double> at;
  Vec2d force{};
  double torque = 0;
  LoadSense sense = LoadSense::always;
  /// Drive angles between which it acts, counter-clockwise from first to second; empty: all.
  std::optional<std::pair<double, double>> between;
  /// The part of the body's stroke in which it acts, as fractions 0…1 of the stroke; empty: all.
  std::optional<std::pair<double, double>> within_stroke;
};

}  // namespace cognate::problems
