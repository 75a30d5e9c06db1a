/// @file What a file about gears asks for. Angles are in radians, lengths in the file's unit.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/gear/other_gears.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

/// `mechanism.gearing`.
enum class Gearing {
  spur,
  helical,
  internal,  ///< a pinion in a ring, both spur
  rack,      ///< a pinion on a rack, both spur
  bevel,
  worm
};

/// `kind = "gear"`: one gear as its rack cuts it. Other gearings are made of pairs alone.
struct GearProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  Gearing gearing = Gearing::spur;  ///< or helical
  gear::HelicalGear gear;           ///< of a spur gear without helix
  std::optional<int> span_teeth{};  ///< over which the span is measured; else the usual number
  int points = 20;                  ///< rows of the table for each part of the flank
};

template <>
struct KindTraits<GearProblem> {
  static constexpr std::string_view kWord = "gear";
  static GearProblem read(reading::TableReader& document, const std::filesystem::path& folder);
  static reading::Written written(const GearProblem& problem);
  static tl::expected<GearProblem, std::vector<std::string>> checked(const GearProblem& problem);
};

/// Teeth that a gear may have: more are a rack's to every digit that counts.
inline constexpr int kFewestTeeth = 3, kMostTeeth = 2000;

/// `target.objective` of a gear pair.
enum class GearObjective {
  balanced_sliding,  ///< the greatest specific sliding of the four flank ends, least
  contact_ratio,     ///< greatest
  size               ///< the centre distance, least
};

/// `[constraints]` of a gear pair; what is not given is not limited, but for the defaults here.
struct GearConstraints {
  double contact_ratio_min = 1;
  double tip_thickness_min = 0;  ///< in modules
  bool no_undercut = true;
  bool no_interference = true;
  bool hunting = false;  ///< no common divisor of the teeth: each meets every other one
  std::optional<double> sliding_max;        ///< greatest |specific sliding|
  std::optional<double> tip_clearance_min;  ///< in modules
};

/// `kind = "gear-pair"`. What is empty is found; nothing is given twice.
struct GearPairProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  Gearing gearing = Gearing::spur;
  gear::BasicRack rack;
  std::array<std::optional<int>, 2> teeth{};
  std::array<std::array<int, 2>, 2> teeth_bounds{};  ///< least and greatest, where teeth are free
  std::optional<double> module;
  std::vector<double> modules;  ///< to choose from, where the module is free
  std::array<std::optional<double>, 2> profile_shift{};
  Range profile_shift_bounds{-0.6, 1.2};
  std::array<double, 2> tip_reduction{};  ///< of each tip circle, in modules
  std::optional<double> centre_distance;
  Range centre_distance_bounds{0, HUGE_VAL};  ///< of a centre distance that is free
  std::optional<double> backlash;  ///< wanted, with shifts or a centre distance free; default 0
  std::optional<double> ratio;     ///< z₂/z₁ wanted, with teeth free
  double ratio_tolerance = 0;      ///< relative
  double helix = 0;                ///< of the pinion; the wheel's is opposite
  bool free_helix = false;         ///< it is that of the centre distance, all else being given
  double face_width = 0;
  double shaft_angle = kRightAngle;  ///< bevel
  int cutter_teeth = 20;             ///< internal: of the pinion-shaped tool that cuts the ring
  gear::WormPair worm;               ///< worm: all that there is
  std::optional<double> friction;    ///< worm: then efficiency and self-locking are reported
  GearObjective objective = GearObjective::balanced_sliding;
  GearConstraints constraints;
  Solve solve;
};

template <>
struct KindTraits<GearPairProblem> {
  static constexpr std::string_view kWord = "gear-pair";
  static GearPairProblem read(reading::TableReader& document, const std::filesystem::path& folder);
  static reading::Written written(const GearPairProblem& problem);
  static tl::expected<GearPairProblem, std::vector<std::string>> checked(
      const GearPairProblem& problem);
};

template <>
std::span<const Named<Gearing>> names<Gearing>();
template <>
std::span<const Named<GearObjective>> names<GearObjective>();

}  // namespace cognate::problems
