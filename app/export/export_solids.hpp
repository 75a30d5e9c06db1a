/// @file Linkages, gears and cams as solids.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "analysis/mechanism/motion_state.hpp"
#include "app/export/exported.hpp"
#include "app/export/parts/link_parts.hpp"
#include "app/export/parts/part_bosses.hpp"
#include "app/export/solids.hpp"
#include "app/export/wheel_bore.hpp"

namespace cognate::app {

/// NAME.step, or NAME.PART.stl of each solid. The error says why one cannot be made.
tl::expected<Exported, std::string> export_solids(const SolidAssembly& assembly,
                                                  const ExportOptions& wanted,
                                                  const std::string& stem);

/// The note on solids of a problem that names no unit of length.
inline constexpr const char* kMillimetresAssumed =
    "the file names no unit of length: of the solids a length of 1 is a millimetre";

/// An assembly of lengths in `unit`; without one a length is a millimetre.
SolidAssembly empty_assembly(std::string title, std::optional<problems::LengthUnit> unit);

/// What parts are made of: `made` in `layers`, each as thick as the order says.
struct StackedParts {
  const LinkParts& made;
  const PartLayers& layers;
  const PartBill& bill;
  const PartBosses& bosses;
  const PartOrder& order;  ///< with a thickness
};

/// The plates of the links, the frame's lowest layer on z = 0, the pins through them or screws with
/// nuts, washers whose diameter is chosen, and bearings and spacers as far as they are ordered,
/// with every body where `bodies` has it.
std::vector<Solid> linkage_solids(const StackedParts& parts,
                                  std::span<const BodyMotion<double, 0>> bodies);

/// A gear or a cam, about its own centre.
struct WheelSolid {
  std::string name;
  SolidLoop outline;
  std::optional<SolidLoop> hollow{};  ///< of a ring: its teeth
  Vec2d centre{};                     ///< where it stands
  Vec2d direction{1, 0};              ///< by which its keyway is turned from +y
  WheelBore bore{};
  double low = 0;    ///< of its lower face
  double twist = 0;  ///< of its upper face against the lower
};

/// A wheel of the thickness that is wanted, its hub a boss about the bore on its upper face. The
/// error says which option is missing or not possible.
tl::expected<Solid, std::string> wheel_solid(const WheelSolid& wheel, const ExportOptions& wanted);

}  // namespace cognate::app
