#include "app/export/wheel_bore.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/export/parts/offset_outline.hpp"

namespace cognate::app {
namespace {

/// Up to which bore which keyway is for.
struct KeywayRow {
  double most = 0;
  Keyway keyway;
};

// DIN 6885-1: over 6 mm.
constexpr double kLeastKeyedBore = 6;
constexpr std::array kKeyways = {
    KeywayRow{8, {2, 1.0}},     KeywayRow{10, {3, 1.4}},   KeywayRow{12, {4, 1.8}},
    KeywayRow{17, {5, 2.3}},    KeywayRow{22, {6, 2.8}},   KeywayRow{30, {8, 3.3}},
    KeywayRow{38, {10, 3.3}},   KeywayRow{44, {12, 3.3}},  KeywayRow{50, {14, 3.8}},
    KeywayRow{58, {16, 4.3}},   KeywayRow{65, {18, 4.4}},  KeywayRow{75, {20, 4.9}},
    KeywayRow{85, {22, 5.4}},   KeywayRow{95, {25, 5.4}},  KeywayRow{110, {28, 6.4}},
    KeywayRow{130, {32, 7.4}},  KeywayRow{150, {36, 8.4}}, KeywayRow{170, {40, 9.4}},
    KeywayRow{200, {45, 10.4}}, KeywayRow{230, {50, 11.4}}};

using Bores = tl::expected<std::vector<WheelBore>, std::string>;

tl::expected<double, std::string> entry_of(const char* option, const std::vector<double>& list,
                                           std::size_t i, std::size_t wheels) {
  if (list.empty()) return 0.0;
  if (list.size() == 1) return list.front();
  if (list.size() == wheels) return list[i];
  return tl::unexpected(fmt::format("{}: two lengths are those of a pair; allowed is one", option));
}

tl::expected<std::optional<Keyway>, std::string> keyway_of(
    double bore, std::optional<problems::LengthUnit> unit) {
  if (!unit) {
    return tl::unexpected(
        std::string("--keyway: its sizes are millimetres, and the file names no unit of length; "
                    "expected --length-unit mm, cm, m or in with it"));
  }
  const double millimetre = 1e-3 / metres(unit);
  const auto keyway = keyway_for(bore / millimetre);
  if (!keyway) {
    return tl::unexpected(fmt::format(
        "--keyway: DIN 6885 has none for a bore of {:.6g} mm; allowed are bores over {} mm and up "
        "to {} mm",
        bore / millimetre, kLeastKeyedBore, kKeyways.back().most));
  }
  return Keyway{keyway->width * millimetre, keyway->hub_depth * millimetre};
}

/// Why this bore does not fit into the wheel.
std::optional<std::string> misfit(const WheelBore& bore, const Wheel& wheel) {
  if (!(bore.reach() < wheel.body)) {
    return fmt::format(
        "--bore: {:.6g}{} reaches {:.6g} from the centre of the {}, whose {} is {:.6g}; allowed is "
        "less than that",
        bore.diameter, bore.keyway ? " with its keyway" : "", bore.reach(), wheel.name,
        wheel.body_name, wheel.body);
  }
  if (bore.hub > 0 && !(0.5 * bore.hub > bore.reach() && 0.5 * bore.hub < wheel.body)) {
    return fmt::format(
        "--hub: {:.6g} is not possible for the {}; allowed is a diameter of more than {:.6g}, that "
        "of the bore{}, and less than {:.6g}, twice the {}",
        bore.hub, wheel.name, 2 * bore.reach(), bore.keyway ? " with its keyway" : "",
        2 * wheel.body, wheel.body_name);
  }
  return std::nullopt;
}

/// Counter-clockwise from the right foot of the keyway, which is at the top.
PlanOutline keyed_bore(const WheelBore& bore) {
  const double radius = 0.5 * bore.diameter, half = 0.5 * bore.keyway->width;
  const double foot = std::sqrt((radius - half) * (radius + half));
  const double arc = kTurn - 2 * std::asin(half / radius);
  return {"BORE",
          {{{half, foot}},
           {{half, bore.keyway_top()}},
           {{-half, bore.keyway_top()}},
           {{-half, foot}, std::tan(arc / 4)}},
          true};
}

}  // namespace

std::optional<Keyway> keyway_for(double diameter) {
  constexpr double kHair = 1e-9;  // an 8 that was converted is 8
  if (!(diameter > kLeastKeyedBore * (1 + kHair))) return std::nullopt;
  const auto row = std::ranges::find_if(
      kKeyways, [&](const KeywayRow& each) { return diameter <= each.most * (1 + kHair); });
  return row == kKeyways.end() ? std::nullopt : std::optional(row->keyway);
}

double WheelBore::keyway_top() const {
  return 0.5 * diameter + keyway->hub_depth;
}

double WheelBore::reach() const {
  return keyway ? std::hypot(keyway_top(), 0.5 * keyway->width) : 0.5 * diameter;
}

Bores wheel_bores(const WheelOrder& order, const std::vector<Wheel>& wheels,
                  std::optional<problems::LengthUnit> unit) {
  std::vector<WheelBore> bores;
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    const auto bore = entry_of("--bore", order.bores, i, wheels.size());
    const auto hub = entry_of("--hub", order.hubs, i, wheels.size());
    if (!bore) return tl::unexpected(bore.error());
    if (!hub) return tl::unexpected(hub.error());
    WheelBore made{*bore, *hub, {}};
    if (order.keyway) {
      const auto keyway = keyway_of(*bore, unit);
      if (!keyway) return tl::unexpected(keyway.error());
      made.keyway = *keyway;
    }
    if (const auto why = misfit(made, wheels[i])) return tl::unexpected(*why);
    bores.push_back(made);
  }
  return bores;
}

tl::expected<void, std::string> add_bore(const WheelBore& bore, const Vec2d& centre,
                                         const Vec2d& direction, double kerf, Plan& plan) {
  if (bore.hub > 0) plan.circles.push_back({"HUB", centre, 0.5 * bore.hub});
  if (bore.diameter == 0) return {};
  if (!(kerf < bore.diameter)) {
    return tl::unexpected(fmt::format(
        "--kerf: {:.6g} leaves nothing of the bore of {:.6g}; allowed is less than that", kerf,
        bore.diameter));
  }
  if (!bore.keyway) {
    plan.circles.push_back({"BORE", centre, 0.5 * (bore.diameter - kerf)});
    return {};
  }
  auto outline = offset_outline(keyed_bore(bore), -0.5 * kerf);
  if (!outline) {
    return tl::unexpected(fmt::format(
        "--kerf: {:.6g} leaves nothing of the keyway, which is {:.6g} wide; allowed is less than "
        "that",
        kerf, bore.keyway->width));
  }
  for (PlanCorner& corner : outline->corners) corner.at = centre + direction * corner.at;
  plan.outlines.push_back(*std::move(outline));
  return {};
}

nlohmann::ordered_json bore_json(const WheelBore& bore) {
  nlohmann::ordered_json table = nlohmann::ordered_json::object();
  if (bore.diameter > 0) table["bore"] = bore.diameter;
  if (bore.keyway) {
    table["keyway"] = {{"width", bore.keyway->width}, {"hub_depth", bore.keyway->hub_depth}};
  }
  if (bore.hub > 0) table["hub"] = bore.hub;
  return table;
}

}  // namespace cognate::app
