#include "app/export/gear_sheet.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "app/export/parts/offset_outline.hpp"

namespace cognate::app {
namespace {

/// Of the chord tolerance, what chords leave of it and what the corners of their offset take.
constexpr double kChordShare = 0.9;

std::string called(const GearPose& gear) {
  return gear.name.empty() ? "gear" : gear.name;
}

double outer_radius(const GearPose& gear) {
  return gear.ring ? gear::root_radius(*gear.ring) : gear::tip_radius(gear.section);
}

double pitch_of(const GearPose& gear) {
  return kPi * gear.section.module;
}

/// The gears with the pinion away from what it meshes with.
std::vector<GearPose> laid_apart(std::vector<GearPose> gears, double kerf) {
  if (gears.size() < 2 || kerf == 0) return gears;
  GearPose& pinion = gears.front();
  const GearPose& wheel = gears.back();
  // No more for a kerf that is refused later, as places far away have no digits left.
  const double room = pinion.section.module + std::min(kerf, pitch_of(pinion));
  constexpr double kMesh = 3;  // more than teeth of a rack go in, in modules
  pinion.centre.y = wheel.rack ? pinion.centre.y - kMesh * pinion.section.module - room
                               : wheel.centre.y - outer_radius(wheel) - outer_radius(pinion) - room;
  return gears;
}

/// How far the beam's middle runs outside the outline: inside that of a ring.
double beam_distance(const GearPose& gear, double kerf) {
  return gear.ring ? -0.5 * kerf : 0.5 * kerf;
}

/// The greatest kerf of which the outline has a cut, rounded down to three digits.
double greatest_kerf(const PlanOutline& outline, const GearPose& gear, double kerf) {
  // No space is wider than the pitch.
  double low = 0, high = std::min(kerf, pitch_of(gear));
  constexpr int kHalvings = 20;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (offset_outline(outline, beam_distance(gear, middle)) ? low : high) = middle;
  }
  if (!(low > 0)) return 0;
  const double digit = std::pow(10.0, std::floor(std::log10(low)) - 2);
  return digit * std::floor(low / digit);
}

class GearCutter {
 public:
  GearCutter(const ResultGears& given, double kerf, const WheelOrder& order)
      : given_(given), order_(order) {
    sheet_.kerf = kerf;
  }

  tl::expected<GearSheet, std::string> make(double tolerance) {
    const double kerf = sheet_.kerf;
    for (const GearPose& gear : laid_apart(given_.gears, kerf)) {
      sheet_.outlines.push_back(gear_outline(gear, kerf > 0 ? kChordShare * tolerance : tolerance));
    }
    sheet_.plan = gear_plan(sheet_.outlines, given_.title);
    sheet_.plan.length_unit = given_.length_unit;
    return bore().and_then([&] { return cut((1 - kChordShare) * tolerance); }).map([&] {
      fit_to_shapes(sheet_.plan);
      return std::move(sheet_);
    });
  }

 private:
  using Done = tl::expected<void, std::string>;

  Done bore() {
    sheet_.bores.resize(sheet_.outlines.size());
    if (order_.bores.empty() && order_.hubs.empty()) return {};
    std::vector<std::size_t> bored;
    std::vector<Wheel> wheels;
    for (std::size_t i = 0; i < sheet_.outlines.size(); ++i) {
      const GearPose& gear = sheet_.outlines[i].gear;
      if (gear.ring || gear.rack) continue;
      bored.push_back(i);
      wheels.push_back({called(gear), gear::root_radius(gear.section), "root radius"});
    }
    const auto made = wheel_bores(order_, wheels, given_.length_unit);
    if (!made) return tl::unexpected(made.error());
    sheet_.plan.layers.push_back({"BORE"});
    sheet_.plan.layers.push_back({"HUB", PlanColour::grey, true});
    for (std::size_t k = 0; k < bored.size(); ++k) {
      sheet_.bores[bored[k]] = (*made)[k];
      const GearPose& gear = sheet_.outlines[bored[k]].gear;
      const Vec2d direction{std::cos(gear.angle), std::sin(gear.angle)};
      if (auto drawn = add_bore((*made)[k], gear.centre, direction, sheet_.kerf, sheet_.plan);
          !drawn) {
        return drawn;
      }
    }
    return {};
  }

  Done cut(double slack) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < sheet_.plan.outlines.size(); ++i) {
      PlanOutline& outline = sheet_.plan.outlines[i];
      if (outline.layer != "OUTLINE") continue;
      sheet_.cuts.push_back(i);
      const GearPose& gear = sheet_.outlines[next++].gear;
      auto moved = offset_outline(outline, beam_distance(gear, sheet_.kerf), slack);
      if (!moved) {
        return tl::unexpected(fmt::format(
            "--kerf: {:.6g} does not fit into the tooth spaces of the {}, or not into its fillets; "
            "allowed is less than {:.3g}",
            sheet_.kerf, called(gear), greatest_kerf(outline, gear, sheet_.kerf)));
      }
      outline = *std::move(moved);
    }
    return {};
  }

  const ResultGears& given_;
  const WheelOrder& order_;
  GearSheet sheet_;
};

}  // namespace

tl::expected<GearSheet, std::string> gear_sheet(const ResultGears& given, double kerf,
                                                const WheelOrder& order, double tolerance) {
  return GearCutter(given, kerf, order).make(tolerance);
}

}  // namespace cognate::app
