#include "app/export/export_solids.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using Refusal = std::optional<std::string>;

// What OpenCASCADE, to which 1e-7 mm is nothing, shapes soundly.
constexpr double kLeastMillimetres = 1e-2, kMostMillimetres = 1e6;

/// The rectangle about a loop: its lower left and its upper right corner.
std::pair<Vec2d, Vec2d> box_of(const SolidLoop& loop) {
  const Vec2d radius{loop.radius, loop.radius};
  if (loop.corners.empty()) return {loop.centre - radius, loop.centre + radius};
  Vec2d low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};
  for (const PlanCorner& corner : loop.corners) {
    low = {std::min(low.x, corner.at.x), std::min(low.y, corner.at.y)};
    high = {std::max(high.x, corner.at.x), std::max(high.y, corner.at.y)};
  }
  return {low, high};
}

/// The least extent of a prism along any axis.
double least_extent(const SolidPrism& prism) {
  const auto [low, high] = box_of(prism.loop);
  return std::min({high.x - low.x, high.y - low.y, prism.high - prism.low});
}

/// How far a prism of `solid` is from the origin of the assembly.
double reach_of(const Solid& solid, const SolidPrism& prism) {
  const auto [low, high] = box_of(prism.loop);
  return std::max(norm(solid.at) + std::max(norm(low), norm(high)), prism.high);
}

/// Why the solids are too small or too large for numbers of millimetres.
Refusal out_of_scale(const SolidAssembly& assembly) {
  for (const Solid& solid : assembly.solids) {
    for (const auto* prisms : {&solid.material, &solid.holes}) {
      for (const SolidPrism& prism : *prisms) {
        const double reach = assembly.millimetres * reach_of(solid, prism);
        const double least = assembly.millimetres * least_extent(prism);
        if (reach <= kMostMillimetres && least >= kLeastMillimetres) continue;
        return fmt::format(
            "--format: of {} {} mm; solids from {} mm to 1 km are allowed", solid.name,
            reach <= kMostMillimetres ? fmt::format("something measures {:.3g}", least)
                                      : fmt::format("something reaches {:.3g}", reach),
            kLeastMillimetres);
      }
    }
  }
  return std::nullopt;
}

/// `name` as a part of file names, which no other in `taken` is.
std::string file_word(const std::string& name, std::set<std::string>& taken) {
  std::string word;
  for (const char c : name) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    word += plain || c == '_' || c == '-' ? c : '-';
  }
  std::string own = word;
  for (int i = 2; !taken.insert(own).second; ++i) own = fmt::format("{}-{}", word, i);
  return own;
}

std::vector<ExportedFile> files_of(const SolidAssembly& assembly, ShapedSolids shaped,
                                   SolidFormat format, const std::string& stem) {
  if (format == SolidFormat::step) return {{stem + ".step", std::move(shaped.texts.front())}};
  std::vector<ExportedFile> files;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < shaped.texts.size(); ++i) {
    files.push_back({fmt::format("{}.{}.stl", stem, file_word(assembly.solids[i].name, taken)),
                     std::move(shaped.texts[i])});
  }
  return files;
}

ordered_json solids_json(const SolidAssembly& assembly, const std::vector<double>& volumes) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    const Solid& solid = assembly.solids[i];
    double low = kInfinity, high = -kInfinity;
    for (const SolidPrism& prism : solid.material) {
      low = std::min(low, prism.low);
      high = std::max(high, prism.high);
    }
    list.push_back({{"name", solid.name},
                    {"low", low},
                    {"high", high},
                    {"at", {solid.at.x, solid.at.y}},
                    {"turned_deg", problems::degrees(angle_of(solid.direction))},
                    {"volume", volumes[i]}});
    const double twist = solid.material.front().twist;
    if (twist != 0) list.back()["twist_deg"] = problems::degrees(twist);
  }
  return list;
}

}  // namespace

SolidAssembly empty_assembly(std::string title, std::optional<problems::LengthUnit> unit) {
  SolidAssembly assembly;
  assembly.title = std::move(title);
  if (unit) assembly.millimetres = 1e3 * metres(unit);
  return assembly;
}

tl::expected<Exported, std::string> export_solids(const SolidAssembly& assembly,
                                                  const ExportOptions& wanted,
                                                  const std::string& stem) {
  if (const auto why = out_of_scale(assembly)) return tl::unexpected(*why);
  const SolidFormat format =
      wanted.format == ExportFormat::stl ? SolidFormat::stl : SolidFormat::step;
  auto shaped = shape_solids(assembly, format);
  if (!shaped) return tl::unexpected(shaped.error());
  Exported made;
  made.quantities = {{"solids", solids_json(assembly, shaped->volumes)}};
  made.files = files_of(assembly, *std::move(shaped), format, stem);
  made.summary =
      fmt::format("{} solid{}", assembly.solids.size(), assembly.solids.size() == 1 ? "" : "s");
  return made;
}

tl::expected<Solid, std::string> wheel_solid(const WheelSolid& wheel, const ExportOptions& wanted) {
  if (!wanted.thickness) {
    return tl::unexpected(
        std::string("--format: solids have a thickness; expected --thickness T with it"));
  }
  const double high = wheel.low + *wanted.thickness;
  Solid solid{.name = wheel.name, .at = wheel.centre};
  solid.material.push_back({wheel.outline, wheel.low, high, wheel.hollow, wheel.twist});
  double top = high;
  if (wheel.bore.hub > 0) {
    if (!(wanted.hub_length && *wanted.hub_length > *wanted.thickness)) {
      return tl::unexpected(fmt::format(
          "--hub: of a solid it has a length; expected --hub-length L with it, more than the "
          "thickness {:.6g}",
          *wanted.thickness));
    }
    top = wheel.low + *wanted.hub_length;
    solid.material.push_back({circle_loop({}, 0.5 * wheel.bore.hub), wheel.low, top});
  }
  Plan bore;
  if (const auto made = add_bore(wheel.bore, {}, wheel.direction, 0, bore); !made) {
    return tl::unexpected(made.error());
  }
  for (const PlanCircle& circle : bore.circles) {
    if (circle.layer != "BORE") continue;
    solid.holes.push_back({circle_loop({}, circle.radius), wheel.low, top});
  }
  for (const PlanOutline& outline : bore.outlines) {
    solid.holes.push_back({{outline.corners}, wheel.low, top});
  }
  return solid;
}

}  // namespace cognate::app
