#include "problems/linkage/constraint_words.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "problems/linkage/cycle/cycle_quantities.hpp"

namespace cognate::problems {
namespace {

constexpr std::string_view kMost = "<=", kLeast = ">=", kWithin = "in", kEqual = "=";

struct KeyWords {
  std::string_view key, label, unit;
  std::string_view relation{};  ///< of a number as bound, where the key's ending does not say it
};

/// Whole names where the key alone says too little.
constexpr KeyWords kNames[] = {{"no_undercut.pinion", "profile shift without undercut", "", kLeast},
                               {"no_undercut.wheel", "profile shift without undercut", "", kLeast},
                               {"mechanism.backlash", "backlash", "length", kEqual}};

constexpr KeyWords kKeys[] = {
    {"crank", "crank", "length"},
    {"coupler", "coupler", "length"},
    {"rocker", "rocker", "length"},
    {"frame", "frame", "length"},
    {"offset", "offset", "length"},
    {"frame_angle_deg", "direction of the frame", "deg"},
    {"pivot_a", "pivot A", "length"},
    {"pivot_d", "pivot D", "length"},
    {"fixed_pivot", "fixed pivot", "length"},
    {"coupler_point", "coupler point", "length"},
    {"moving_pivot_a", "moving pivot of A", "length"},
    {"moving_pivot_d", "moving pivot of D", "length"},
    {"assembly", "assembly", "length", kLeast},
    {"input_start_deg", "input angle at the start", "deg"},
    {"output_start_deg", "output angle at the start", "deg"},
    {"output_start", "displacement at the start", "length"},
    {"class", "class", ""},
    {"full_turn", "turning of the crank", ""},
    {"transmission_angle_deg", "transmission angle", "deg"},
    {"link_ratio_max", "longest over shortest link", ""},
    {"layers_max", "layers", ""},
    {"time_ratio", "time ratio", ""},
    {"clearance", "clearance", "length", kLeast},
    {"no_branch_defect", "branch defect", ""},
    {"no_order_defect", "order defect", ""},
    {"no_circuit_defect", "circuit defect", ""},
    {"rms_error_max", "root mean square of the error", "length"},
    {"rms_error_deg_max", "root mean square of the error", "deg"},
    {"max_error_max", "maximum error", "length"},
    {"max_error_deg_max", "maximum error", "deg"},
    {"crank_sense", "sense of the crank", ""},
    {"no_extra_loop", "distance of the whole curve from the target", "length"},
    {"half_band_deg_max", "half band", "deg"},
    {"swing_deg_min", "swing", "deg"},
    {"apart_deg", "distance of the levels", "deg", kLeast},
    {"half_band_max", "half band", "length"},
    {"stroke_min", "stroke", "length"},
    {"apart", "distance of the levels", "length", kLeast},
    {"stride", "stride", "length", kEqual},
    {"duty_min", "duty factor", ""},
    {"height_min", "step height", "length"},
    {"height_max", "step height", "length"},
    {"flatness_max", "flatness", ""},
    {"foot_speed_min", "foot speed over its mean", ""},
    {"foot_speed_max", "foot speed over its mean", ""},
    {"ends", "distance of the path's ends from those of the line", "length"},
    {"length", "length of the segment", "length", kLeast},
    {"deviation", "deviation", "length", kMost},
    {"deviation_relative", "deviation over length", "", kMost},
    {"direction_deg", "direction", "deg"},
    {"crank_range_deg", "range of the crank", "deg"},
    {"size_over_length_max", "size over length", ""},
    {"speed_variation_max", "speed variation", ""},
    {"outer_limit_deg", "rocker angle at the outer limit", "deg"},
    {"inner_limit_deg", "rocker angle at the inner limit", "deg"},
    {"crank_pivot_line", "line of the crank pivot", "length"},
    {"bar", "length of the bar", "length"},
    {"contact_ratio_min", "contact ratio", ""},
    {"backlash", "backlash", "length", kLeast},
    {"sliding_max", "specific sliding", ""},
    {"tip_thickness_min", "tip thickness", "module"},
    {"no_interference", "interference", "module", kMost},
    {"tip_clearance_min", "tip clearance", "module"},
    {"profile_shift", "profile shift", ""},
    {"centre_distance", "centre distance", "length", kLeast},
    {"ratio_tolerance", "relative error of the ratio", "", kMost},
    {"hunting", "common divisor of the teeth", "", kMost},
    {"planet_assembly", "equally spaced planets", ""},
    {"neighbour_clearance", "clearance of neighbouring planets", "length", kLeast},
    {"teeth", "teeth", ""},
    {"face_width", "width of the teeth", "length", kMost},
    {"cone_angle_deg", "cone angle", "deg", kMost},
    {"base_radius", "prime radius", "length"},
    {"roller_radius", "roller radius", "length", kMost},
    {"arm", "arm", "length"},
    {"face_offset", "offset of the face", "length"},
    {"pressure_angle_deg_max", "pressure angle", "deg"},
    {"pressure_angle_deg_max_rise", "pressure angle in the rises", "deg", kMost},
    {"pressure_angle_deg_max_return", "pressure angle in the returns", "deg", kMost},
    {"pressure_angle_deg_max_rise_working", "working pressure angle in the rises", "deg", kMost},
    {"pressure_angle_deg_max_return_working", "working pressure angle in the returns", "deg",
     kMost},
    {"no_undercut", "radius of curvature without undercut", "length", kLeast},
    {"curvature_radius_min", "radius of curvature", "length"},
    {"concave_radius_min", "radius of curvature where concave", "length"},
    {"face_width_max", "face width", "length"},
    {"profile_radius_min", "radius of the profile", "length"},
    {"profile_radius_max", "radius of the profile", "length"},
    {"constant_breadth", "deviation from constant breadth", "length", kMost},
    {"breadth", "breadth", "length", kEqual},
    {"second_cam", "second cam", ""},
    {"no_separation", "least contact force", "N", kLeast},
    {"contact_force_max", "contact force", "N"},
    {"torque_max", "torque of the cam", "N m"},
    {"contact_stress_max", "contact stress", "N/length2"}};

constexpr std::string_view kPivotRegion = "pivot_region.";

/// The tables in which a key stands; what they add to its label.
constexpr std::pair<std::string_view, std::string_view> kTables[] = {{"bounds.", ""},
                                                                     {"mechanism.", ""},
                                                                     {"target.", ""},
                                                                     {kPivotRegion, ""},
                                                                     {"follower.", ""},
                                                                     {"dwell", ""},
                                                                     {"second_cam.", "second cam"}};

/// A name taken apart: "second_cam.torque_max", "bounds.pivot_a.x", "clearance[2]".
struct NameParts {
  std::string_view key;
  std::string remark;  ///< "x", "pinion", "2", "second cam"
};

void add_remark(std::string& remark, std::string_view more) {
  if (more.empty()) return;
  if (!remark.empty()) remark += ", ";
  remark += more;
}

NameParts parts_of(std::string_view name) {
  NameParts parts{name, {}};
  for (const auto& [table, remark] : kTables) {
    if (!parts.key.starts_with(table)) continue;
    parts.key.remove_prefix(table.size());
    add_remark(parts.remark, remark);
  }
  const auto bracket = parts.key.find('[');
  if (bracket != parts.key.npos) {
    const auto end = parts.key.find(']', bracket);
    add_remark(parts.remark, parts.key.substr(bracket + 1, end - bracket - 1));
    parts.key = bracket == 0 ? parts.key.substr(std::min(end + 2, parts.key.size()))
                             : parts.key.substr(0, bracket);
  }
  // The joint of a dyad by its name.
  const bool is_joint =
      name.starts_with(kPivotRegion) && !name.substr(kPivotRegion.size()).starts_with("pivot_");
  const auto dot = parts.key.find('.');
  if (is_joint) add_remark(parts.remark, parts.key.substr(0, dot));
  if (dot != parts.key.npos) {
    std::string place(parts.key.substr(dot + 1));
    std::ranges::replace(place, '_', ' ');
    add_remark(parts.remark, place);
    parts.key = parts.key.substr(0, dot);
  }
  if (is_joint) parts.key = "fixed_pivot";
  return parts;
}

std::optional<KeyWords> key_words(std::string_view key, bool angular) {
  const auto found = std::ranges::find(kKeys, key, &KeyWords::key);
  if (found != std::end(kKeys)) return *found;
  for (const CycleDeclaration& quantity : kCycleQuantities) {
    if (quantity.limit_key != key) continue;
    return KeyWords{key, quantity.heading, quantity.unit_of(angular)};
  }
  return std::nullopt;
}

/// Of a key that no table has: its words, and the unit that it ends with.
KeyWords unknown_words(std::string_view key) {
  return {key, key, key.find("_deg") != key.npos ? "deg" : ""};
}

std::string_view relation_of(const ConstraintCheck& check, const KeyWords& words, bool is_given) {
  if (check.relation) return *check.relation == BoundSide::most ? kMost : kLeast;
  if (const auto* range = std::get_if<Range>(&check.bound)) {
    if (range->min == range->max) return kEqual;
    if (std::isinf(range->max)) return kLeast;
    return std::isinf(range->min) ? kMost : kWithin;
  }
  if (std::holds_alternative<std::string>(check.bound) || is_given) return kEqual;
  if (!words.relation.empty()) return words.relation;
  if (words.key.ends_with("_max")) return kMost;
  return words.key.ends_with("_min") ? kLeast : kEqual;
}

}  // namespace

bool has_words(std::string_view name) {
  return std::ranges::find(kNames, name, &KeyWords::key) != std::end(kNames) ||
         key_words(parts_of(name).key, false).has_value();
}

ConstraintWords words_of(const ConstraintCheck& check, bool angular) {
  NameParts parts = parts_of(check.name);
  const auto whole = std::ranges::find(kNames, check.name, &KeyWords::key);
  const KeyWords words = whole != std::end(kNames)
                             ? *whole
                             : key_words(parts.key, angular).value_or(unknown_words(parts.key));
  ConstraintWords all;
  all.label = words.label;
  std::ranges::replace(all.label, '_', ' ');
  if (!parts.remark.empty()) all.label += fmt::format(" ({})", parts.remark);
  all.relation = relation_of(check, words, check.name.starts_with("mechanism."));
  const bool is_word = std::holds_alternative<std::string>(check.value) &&
                       std::holds_alternative<std::string>(check.bound);
  if (!is_word) all.unit = words.unit;
  return all;
}

}  // namespace cognate::problems
