/// @file What a gear or a cam has at its centre: bore, keyway and hub.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/drawing/plan.hpp"

namespace cognate::app {

/// What is wanted; of two wheels a list may have one entry for both or one for each.
struct WheelOrder {
  std::vector<double> bores, hubs;  ///< diameters; empty where there are none
  bool keyway = false;
  bool timing_mark = false;  ///< of a cam: a line at cam angle 0
};

/// A parallel keyway of DIN 6885-1, in millimetres.
struct Keyway {
  double width = 0;
  double hub_depth = 0;  ///< t2, how far it goes beyond the bore
};

/// The keyway for a bore of `diameter` millimetres: more than 6 and at most 230.
std::optional<Keyway> keyway_for(double diameter);

/// The bore of one wheel, in the lengths of its problem.
struct WheelBore {
  double diameter = 0;  ///< 0 where there is none
  double hub = 0;
  std::optional<Keyway> keyway;

  double keyway_top() const;  ///< height of the keyway's floor above the centre
  double reach() const;       ///< the greatest distance of its edge from the centre
};

/// A wheel that is to have a bore.
struct Wheel {
  std::string name;  ///< as messages call it: "the pinion"
  double body = 0;   ///< radius within which all is material: that of the root circle
  std::string body_name;
};

/// The bores of `wheels`; the error says which option is not possible and what is allowed.
tl::expected<std::vector<WheelBore>, std::string> wheel_bores(
    const WheelOrder& order, const std::vector<Wheel>& wheels,
    std::optional<problems::LengthUnit> unit);

/// Adds the bore about `centre` on the layer BORE, cut with a beam of width `kerf`, its keyway
/// towards +y turned by `direction`, and the hub on HUB. The error says that the kerf is too wide.
tl::expected<void, std::string> add_bore(const WheelBore& bore, const Vec2d& centre,
                                         const Vec2d& direction, double kerf, Plan& plan);

/// `bore`, `keyway` (width, hub_depth) and `hub`, as far as there are some.
nlohmann::ordered_json bore_json(const WheelBore& bore);

}  // namespace cognate::app
