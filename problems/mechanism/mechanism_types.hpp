/// @file The types of mechanisms that their dimensions define: what files call each, its keys, the
/// names of its parts and its output. Readers, results, `cognate list`, tables and the pages take
/// them from here.
#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "problems/mechanism/mechanism_description.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/mechanism/named_parts.hpp"

namespace cognate::problems {

/// The links whose lengths `[bounds]` limits.
enum class LinkRole { crank, coupler, rocker };

// What keys hold, each with the word by which pages know it, `kForm`.

/// A positive length, which must be given.
template <class Type>
struct LengthKey {
  static constexpr std::string_view kForm = "length";
  double Type::*of;
  LinkRole role;
};

/// A signed distance from a pivot, 0 by default.
template <class Type>
struct OffsetKey {
  static constexpr std::string_view kForm = "number";
  double Type::*of;
};

/// The same where it must be given and is not 0.
template <class Type>
struct NonzeroKey {
  static constexpr std::string_view kForm = "number";
  double Type::*of;
};

/// [x, y], the origin by default.
template <class Type>
struct PlaceKey {
  static constexpr std::string_view kForm = "place";
  Vec2d Type::*of;
};

/// [[x, y], [x, y]], two different points, between which the frame is.
template <class Type>
struct PivotsKey {
  static constexpr std::string_view kForm = "pivots";
  Vec2d Type::*first;
  Vec2d Type::*second;
};

/// An angle, of which the member is the unit vector: 0° by default.
template <class Type>
struct DirectionKey {
  static constexpr std::string_view kForm = "direction";
  Vec2d Type::*of;
};

/// An angle from another line, which is not parallel: 90° by default.
template <class Type>
struct InclinationKey {
  static constexpr std::string_view kForm = "direction";
  Vec2d Type::*of;
  std::string_view from;  ///< that line, in words
};

template <class Type>
struct AssemblyKey {
  static constexpr std::string_view kForm = "assembly";
  Assembly Type::*of;
};

/// [u, v], where there is one.
template <class Type>
struct PointKey {
  static constexpr std::string_view kForm = "point";
  std::optional<Vec2d> Type::*of;
};

/// A key of `[mechanism]`, what it holds, and what `cognate list` says of it.
template <class Type>
struct DimensionKey {
  std::string_view name;
  std::variant<LengthKey<Type>, OffsetKey<Type>, NonzeroKey<Type>, PlaceKey<Type>, PivotsKey<Type>,
               DirectionKey<Type>, InclinationKey<Type>, AssemblyKey<Type>, PointKey<Type>>
      holds;
  std::string_view meaning;
};

/// Of each alternative of `MechanismDescription`:
/// - `kWord`, its `mechanism.type`, and `kMeaning`, what `cognate list` says of it.
/// Of all but a chain:
/// - `kKeys` in the order in which they are read and written;
/// - `kOutput`, the body whose motion is its output: the follower, the sliding or driven one;
/// - `parts(dimensions)`, what its bodies and points are called.
template <class Type>
struct TypeTraits;

inline constexpr std::string_view kPivotMeaning = "[x, y] of the crank's pivot A (default [0, 0])";
inline constexpr std::string_view kOffsetMeaning =
    "of the slide line from A, positive to its left (default 0)";
inline constexpr std::string_view kSlideMeaning = "of the slide line (default 0)";

template <>
struct TypeTraits<FourBar> {
  static constexpr std::string_view kWord = "four-bar";
  static constexpr std::string_view kMeaning = "four links and four hinges: A-B-C-D";
  static constexpr DimensionKey<FourBar> kKeys[] = {
      {"fixed_pivots", PivotsKey<FourBar>{&FourBar::pivot_a, &FourBar::pivot_d},
       "[[x, y], [x, y]] of A and D"},
      {"crank", LengthKey<FourBar>{&FourBar::crank, LinkRole::crank}, "length A-B"},
      {"coupler", LengthKey<FourBar>{&FourBar::coupler, LinkRole::coupler}, "length B-C"},
      {"rocker", LengthKey<FourBar>{&FourBar::rocker, LinkRole::rocker}, "length C-D"},
      {"assembly", AssemblyKey<FourBar>{&FourBar::assembly},
       "\"open\" (default): C to the left of the line from B to D; or \"crossed\""},
      {"coupler_point", PointKey<FourBar>{&FourBar::coupler_point},
       "[u, v] of P: origin B, first axis from B to C"}};
  static constexpr int kOutput = 3;

  /// Bodies crank, coupler, rocker; points A, B, C, D and, with a coupler point, P.
  static NamedParts parts(const FourBar& linkage);
};

/// The keys of a slider-crank and of what it is when stood on its slider.
template <class Type>
inline constexpr DimensionKey<Type> kSliderCrankKeys[] = {
    {"pivot", PlaceKey<Type>{&Type::pivot}, kPivotMeaning},
    {"crank", LengthKey<Type>{&Type::crank, LinkRole::crank}, "length A-B"},
    {"coupler", LengthKey<Type>{&Type::coupler, LinkRole::coupler}, "length B-C"},
    {"offset", OffsetKey<Type>{&Type::offset}, kOffsetMeaning},
    {"direction_deg", DirectionKey<Type>{&Type::direction}, kSlideMeaning},
    {"assembly", AssemblyKey<Type>{&Type::assembly},
     "\"open\" (default): C ahead of B; or \"crossed\""}};

template <>
struct TypeTraits<SliderCrank> {
  static constexpr std::string_view kWord = "slider-crank";
  static constexpr std::string_view kMeaning = "a crank A-B, a coupler B-C, a slider at C";
  static constexpr auto& kKeys = kSliderCrankKeys<SliderCrank>;
  static constexpr int kOutput = 3;

  /// Bodies crank, coupler, slider; points A, B, C.
  static NamedParts parts(const SliderCrank& mechanism);
};

template <>
struct TypeTraits<FixedBlock> {
  static constexpr std::string_view kWord = "fixed-block";
  static constexpr std::string_view kMeaning = "a slider-crank stood on its slider: a hand pump";
  static constexpr auto& kKeys = kSliderCrankKeys<FixedBlock>;
  static constexpr int kOutput = 3;

  /// Bodies crank, coupler, rod; points A, B, C.
  static NamedParts parts(const FixedBlock& mechanism);
};

/// The keys of a guide-bar and of its inversion.
template <class Type>
inline constexpr DimensionKey<Type> kGuideBarKeys[] = {
    {"fixed_pivots", PivotsKey<Type>{&Type::pivot_a, &Type::pivot_c},
     "[[x, y], [x, y]] of the crank (A) and of the guide or block (D)"},
    {"crank", LengthKey<Type>{&Type::crank, LinkRole::crank}, "length A-B"},
    {"offset", OffsetKey<Type>{&Type::offset},
     "of the guide line from its pivot, positive to its left (default 0)"},
    {"assembly", AssemblyKey<Type>{&Type::assembly},
     "with an offset: \"open\" (default) or \"crossed\""}};

template <>
struct TypeTraits<GuideBar> {
  static constexpr std::string_view kWord = "guide-bar";
  static constexpr std::string_view kMeaning =
      "a crank whose block slides on a bar that swings or turns";
  static constexpr auto& kKeys = kGuideBarKeys<GuideBar>;
  static constexpr int kOutput = 3;

  /// Bodies crank, slider (the block), guide; points A, B, D (the guide's pivot).
  static NamedParts parts(const GuideBar& mechanism);
};

template <>
struct TypeTraits<OscillatingBlock> {
  static constexpr std::string_view kWord = "oscillating-block";
  static constexpr std::string_view kMeaning =
      "a crank whose rod slides through a block that swings";
  static constexpr auto& kKeys = kGuideBarKeys<OscillatingBlock>;
  static constexpr int kOutput = 2;

  /// Bodies crank, block, rod; points A, B, D (the block's pivot).
  static NamedParts parts(const OscillatingBlock& mechanism);
};

template <>
struct TypeTraits<ScotchYoke> {
  static constexpr std::string_view kWord = "scotch-yoke";
  static constexpr std::string_view kMeaning = "a crank whose pin runs in the slot of a slide";
  static constexpr DimensionKey<ScotchYoke> kKeys[] = {
      {"pivot", PlaceKey<ScotchYoke>{&ScotchYoke::pivot}, kPivotMeaning},
      {"crank", LengthKey<ScotchYoke>{&ScotchYoke::crank, LinkRole::crank}, "length A-B"},
      {"offset", OffsetKey<ScotchYoke>{&ScotchYoke::offset}, kOffsetMeaning},
      {"direction_deg", DirectionKey<ScotchYoke>{&ScotchYoke::direction}, kSlideMeaning},
      {"slot_deg", InclinationKey<ScotchYoke>{&ScotchYoke::slot, "the slide line"},
       "of the slot from the slide (default 90)"}};
  static constexpr int kOutput = 3;

  /// Bodies crank, block, yoke; points A, B, C (where slot and slide line cross).
  static NamedParts parts(const ScotchYoke& mechanism);
};

template <>
struct TypeTraits<TangentGenerator> {
  static constexpr std::string_view kWord = "tangent-generator";
  static constexpr std::string_view kMeaning = "a slotted lever moves the pin of a slider";
  static constexpr DimensionKey<TangentGenerator> kKeys[] = {
      {"pivot", PlaceKey<TangentGenerator>{&TangentGenerator::pivot},
       "[x, y] of the lever's pivot A (default [0, 0])"},
      {"offset", NonzeroKey<TangentGenerator>{&TangentGenerator::offset},
       "of the slide line from A, positive to its left"},
      {"direction_deg", DirectionKey<TangentGenerator>{&TangentGenerator::direction},
       kSlideMeaning}};
  static constexpr int kOutput = 3;

  /// Bodies lever, block, slider; points A, B (the slider's pin).
  static NamedParts parts(const TangentGenerator& mechanism);
};

template <>
struct TypeTraits<EllipticTrammel> {
  static constexpr std::string_view kWord = "elliptic-trammel";
  static constexpr std::string_view kMeaning = "a link with both ends on slides";
  static constexpr DimensionKey<EllipticTrammel> kKeys[] = {
      {"centre", PlaceKey<EllipticTrammel>{&EllipticTrammel::centre},
       "[x, y] where the lines cross (default [0, 0])"},
      {"length", LengthKey<EllipticTrammel>{&EllipticTrammel::length, LinkRole::coupler},
       "of the link, A-B"},
      {"direction_deg", DirectionKey<EllipticTrammel>{&EllipticTrammel::direction},
       "of the line of A (default 0)"},
      {"second_line_deg",
       InclinationKey<EllipticTrammel>{&EllipticTrammel::second_line, "the first line"},
       "of the line of B from that of A (default 90)"}};
  static constexpr int kOutput = 3;

  /// Bodies link, first-block, second-block; points A, B (the link's pins).
  static NamedParts parts(const EllipticTrammel& mechanism);
};

template <>
struct TypeTraits<OldhamCoupling> {
  static constexpr std::string_view kWord = "oldham-coupling";
  static constexpr std::string_view kMeaning = "two parallel shafts and a disc between them";
  static constexpr DimensionKey<OldhamCoupling> kKeys[] = {
      {"fixed_pivots",
       PivotsKey<OldhamCoupling>{&OldhamCoupling::pivot_a, &OldhamCoupling::pivot_d},
       "[[x, y], [x, y]] of the shafts, A and D"},
      {"slot_deg", InclinationKey<OldhamCoupling>{&OldhamCoupling::slot, "the first tongue"},
       "of the second tongue from the first (default 90)"}};
  static constexpr int kOutput = 2;

  /// Bodies driver, driven, disc; points A, D (the shafts), C (where the tongues cross).
  static NamedParts parts(const OldhamCoupling& mechanism);
};

template <>
struct TypeTraits<ChainDescription> {
  static constexpr std::string_view kWord = "chain";
  static constexpr std::string_view kMeaning = "a drive and any number of dyads";
};

/// Whether the dimensions define a mechanism completely: not of a chain.
template <class Type>
concept SimpleType = requires {
  TypeTraits<Type>::kKeys;
};

/// Calls `visit` with `std::type_identity` of each type, in the order of `MechanismType`.
template <class Visit>
constexpr void for_each_mechanism_type(Visit visit) {
  const auto fold = [&]<class... Type>(std::type_identity<std::variant<Type...>>) {
    (visit(std::type_identity<Type>{}), ...);
  };
  fold(std::type_identity<MechanismDescription>{});
}

}  // namespace cognate::problems
