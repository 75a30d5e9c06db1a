/// @file A mechanism as `[mechanism]` describes it, defaults filled in, so that it can be written
/// down again in the user's own terms. Angles are in radians.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "analysis/linkage/double_slider.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/guide_bar.hpp"
#include "analysis/linkage/slider_crank.hpp"
#include "analysis/mechanism/attached.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate::problems {

/// `[[pivot]]`: a point of the frame.
struct PivotDescription {
  std::string name;
  Vec2d at{};
};

/// `slide = {through, direction_deg, offset, on}`: a straight guide on the body `on`. `through` is
/// a point in that body's axes or the name of one of its points, `direction` an angle from its
/// first axis.
struct SlideDescription {
  std::variant<Vec2d, std::string> through = Vec2d{};
  double direction = 0;
  double offset = 0;
  std::string on = "frame";
};

/// `[crank]` of a chain: turns about the pivot `at` and carries the point `pin`.
struct CrankDescription {
  std::string at;
  std::string pin;
  double length = 0;
  std::string name = "crank";
};

/// `[slider]` of a chain: driven along a guide of the frame, `pin` its origin.
struct SliderDescription {
  SlideDescription slide;
  std::string pin;
  std::string name = "slider";
};

/// `[cylinder]` of a chain: driven by its length from the pivot `at` to `pin`, the end of a link of
/// `length` that turns about the pivot `about`.
struct CylinderDescription {
  std::string at;
  std::string about;
  std::string pin;
  double length = 0;
  Assembly assembly = Assembly::open;
  std::array<std::string, 3> names;  ///< of rod, cylinder and link
};

enum class DyadType { rrr, rrp, rpr, prp, rpp, group };

/// `[[dyad.joint]]` of a group: a pin of two bodies at `at` in the axes of each, or, with
/// directions from their first axes, a slide of the second's point along the line of the first.
struct GroupJointDescription {
  std::string name;  ///< of a pin
  std::array<std::string, 2> of;
  std::array<Vec2d, 2> at{};
  std::optional<std::array<double, 2>> directions;
};

/// `type = "group"`: where the axes of its bodies stand with the drive at `drive`, and its joints.
struct GroupDescription {
  std::vector<std::string> names;
  std::vector<Placement> drawn;
  double drive = 0;
  std::vector<GroupJointDescription> joints;
};

/// `[[dyad]]`. What the type does not have is empty or zero.
struct DyadDescription {
  DyadType type = DyadType::rrr;
  std::vector<std::string> joins;        ///< RRR, RPR two points; RRP, RPP one; PRP none
  std::vector<double> lengths;           ///< RRR two, RRP one
  std::vector<SlideDescription> slides;  ///< PRP two; RRP, RPP one
  double offset = 0;                     ///< RPR: of the bar from its pivot
  double slot = 0;                       ///< RPP: of the slot from the guide
  Assembly assembly = Assembly::open;    ///< RRR, RRP, RPR
  std::string new_point;                 ///< `new`: the inner joint (RPP: where slot and guide
                                         ///< cross); empty for RPR
  std::array<std::string, 2> names;      ///< of its two bodies
  GroupDescription group;                ///< of a group, all that it has
};

/// `[[point]]`: `at` in the axes of a body. `on` holds its name, or the names of two of its points,
/// the first the origin, the second on the first axis.
struct PointDescription {
  std::string name;
  std::vector<std::string> on;
  Vec2d at{};
};

/// `type = "chain"`.
struct ChainDescription {
  std::vector<PivotDescription> pivots;
  std::variant<CrankDescription, SliderDescription, CylinderDescription> drive;
  std::vector<DyadDescription> dyads;
};

/// What `[mechanism]` says, by its type: the alternatives are in the order of `MechanismType`.
using MechanismDescription =
    std::variant<FourBar, SliderCrank, GuideBar, OscillatingBlock, FixedBlock, ScotchYoke,
                 TangentGenerator, EllipticTrammel, OldhamCoupling, ChainDescription>;

/// `mechanism.type`: the place of its alternative.
enum class MechanismType {
  four_bar,
  slider_crank,
  guide_bar,
  oscillating_block,
  fixed_block,
  scotch_yoke,
  tangent_generator,
  elliptic_trammel,
  oldham_coupling,
  chain
};

}  // namespace cognate::problems
