#include "app/kinds/gear/kind.hpp"
#include "problems/gear/keys.hpp"

namespace cognate::app {
namespace {

constexpr auto kRack = entries_of(problems::reading::kRackKeys);

constexpr Entry kGear[] = {
    {"gearing", "\"spur\" (default) or \"helical\""},
    {"teeth", "3 to 2000"},
    {"module", "normal module of helical gears"},
    {"profile_shift", "in modules (default 0)"},
    {"helix_deg", "helical: on the reference cylinder, positive right-handed"},
    {"face_width", "for the overlap ratio"},
    {"tip_reduction", "of the tip circle, in modules (default 0)"}};

constexpr Entry kOutput[] = {
    {"points", "rows of the table for the fillet and for the involute (default 20)"}};

constexpr Entry kPair[] = {
    {"gearing", "\"spur\" (default), \"helical\", \"bevel\" (straight) or \"worm\""},
    {"teeth", "[z1, z2] of pinion and wheel; left out: found within bounds.teeth"},
    {"module", "normal of helical gears, outer of bevel, axial of worms; left out: bounds.modules"},
    {"profile_shift", "[x1, x2], each a number or \"free\"; left out: found; bevel: [x, -x]"},
    {"centre_distance", "left out: found, or that with the backlash"},
    {"backlash", "arc on the working pitch circles where a shift or the distance is found (0)"},
    {"helix_deg", "helical: of the pinion; the wheel has the other hand"},
    {"face_width", "for the overlap ratio; of bevel gears along the cone"},
    {"tip_reduction", "[k1, k2] of the tip circles, in modules (default 0)"},
    {"shaft_angle_deg", "bevel: between the axes (default 90)"},
    {"starts", "worm: its threads (default 1)"},
    {"wheel_teeth", "worm"},
    {"diameter_quotient", "worm: reference diameter over module (default 10)"},
    {"wheel_shift", "worm: profile shift of the wheel (default 0)"},
    {"friction", "worm: coefficient, for efficiency and self-locking"}};

constexpr Entry kBounds[] = {
    {"teeth", "[[min, max], [min, max]] of pinion and wheel, where teeth are left out"},
    {"modules", "[m, ...] to choose from, where module is left out"},
    {"profile_shift", "[min, max] of each that is free (default [-0.6, 1.2])"},
    {"centre_distance", "[min, max] where it is free; inf leaves a side open"}};

constexpr Entry kTarget[] = {
    {"ratio", "z2/z1"},
    {"ratio_tolerance", "relative (default 0)"},
    {"objective",
     "\"balanced-sliding\" (its maximum minimised; default), \"contact-ratio\" "
     "(maximised) or \"size\" (the centre distance, minimised)"}};

constexpr auto kConstraints =
    entries_of(problems::reading::kMeshKeys, problems::reading::kToothKeys);

constexpr Entry kSolve[] = {{"designs", "1 to 100 (default 3), one for each choice of teeth"}};

constexpr KeyedEntry kGearTables[] = {{"[mechanism]", "the gear", kGear},
                                      {"[rack]", "that cuts it", kRack},
                                      {"[output]", "of its flank", kOutput}};

constexpr KeyedEntry kPairTables[] = {
    {"[mechanism]", "the pair; what is left out is found", kPair},
    {"[rack]", "that cuts both", kRack},
    {"[bounds]", "of what is found (spur and helical gears)", kBounds},
    {"[target]", "what is sought", kTarget},
    {"[constraints]", "on the pair", kConstraints},
    {"[solve]", "how many designs are returned", kSolve}};

constexpr Metric kGearMetrics[] = {
    {"teeth", "1", "of a gear of a pair"},
    {"profile_shift", "1", "in modules"},
    {"reference_diameter", "length", "d (ISO 21771): module (transverse) times teeth"},
    {"base_diameter", "length", "d_b: of the involute's base circle"},
    {"tip_diameter, root_diameter", "length", "d_a, d_f: of bevel gears at the outer end"},
    {"form_diameter", "length", "d_Ff: where the involute begins, as the rack cuts it"},
    {"addendum, dedendum, tooth_depth", "length",
     "h_a, h_f from the reference circle; h: their sum"},
    {"pitch, base_pitch", "length",
     "p, p_b: arcs from tooth to tooth on reference and base circle"},
    {"tooth_thickness", "length", "s: arc on the reference circle"},
    {"space_width", "length", "e: arc on the reference circle"},
    {"base_thickness", "length", "s_b: arc on the base circle"},
    {"tip_thickness", "length", "arc (transverse) on the tip circle; negative: pointed below it"},
    {"pointed_diameter", "length", "of a pointed tooth: where its flanks meet"},
    {"undercut", "boolean", "whether the rack cuts into the involute"},
    {"least_teeth", "1", "without undercut at this shift"},
    {"least_profile_shift", "1", "without undercut of this number of teeth"},
    {"virtual_teeth", "1", "helical: z/cos3(helix); bevel: z/cos(cone angle)"},
    {"base_helix_deg", "deg", "helical: on the base cylinder"},
    {"lead", "length", "helical: along the axis in a turn; of a worm likewise"},
    {"normal_tip_thickness", "length", "helical: of the tip across the tooth"},
    {"span_teeth", "1", "teeth over which the span is measured"},
    {"span_measurement", "length", "over so many teeth (base tangent length)"},
    {"pin_diameter", "length", "1.728 modules"},
    {"measurement_over_pins", "length", "over two such pins (balls) in opposite spaces"},
    {"cone_angle_deg, tip_angle_deg, root_angle_deg", "deg", "bevel: of pitch, tip, root cones"},
    {"mean_module", "length", "bevel: at half the face width"},
    {"lead_angle_deg", "deg", "of a worm"},
    {"throat_diameter", "length", "of a worm's wheel"},
    {"working_diameter", "length", "in a pair: of the pitch circle that rolls"},
    {"contact_start_diameter, contact_end_diameter", "length", "of the flank that touches"},
    {"tip_clearance", "length", "from the tip to the other gear's root"},
    {"sliding_start, sliding_end", "1", "specific sliding 1 - v_other/v_own at these"},
    {"interferes", "boolean", "whether the other's tips dig into its fillet or root"}};

constexpr Metric kPairMetrics[] = {
    {"ratio", "1", "z2/z1; of a worm z2 over its starts"},
    {"module", "length", "as given or chosen"},
    {"centre_distance", "length", "of the axes"},
    {"reference_centre_distance", "length", "sum of the reference radii"},
    {"zero_backlash_distance", "length", "centre distance at which these gears have no backlash"},
    {"profile_shift_sum", "1", "in modules"},
    {"working_pressure_angle_deg", "deg", "at the centre distance"},
    {"contact_ratio", "1", "of the transverse section; below 1: it cannot drive continuously"},
    {"overlap_ratio", "1", "helical: face width over axial pitch; also of a gear"},
    {"total_contact_ratio", "1", "helical: the sum of both"},
    {"continuous_centre_distance_max", "length",
     "where the contact ratio is below 1: the maximum at which it is 1"},
    {"path_length", "length", "of contact"},
    {"approach_length, recess_length", "length", "before and after the pitch point"},
    {"backlash", "length", "arc on the working pitch circles; negative: the teeth overlap"},
    {"normal_backlash", "length", "along the line of action; of helical gears across the teeth"},
    {"sliding_max", "1", "maximum magnitude of specific sliding at the ends of the flanks"},
    {"sliding_speed_ratio_max", "1", "maximum sliding speed over the pitch line's"},
    {"shaft_angle_deg", "deg", "bevel: between the axes"},
    {"cone_distance", "length", "bevel: from the apex to the outer end"},
    {"normal_pressure_angle_deg", "deg", "of a worm"},
    {"sliding_speed_ratio", "1", "worm: sliding speed over its pitch line's"},
    {"efficiency", "1", "worm: where it drives; with friction"},
    {"self_locking", "boolean", "worm: whether the wheel cannot drive it; with friction"}};

constexpr Metric kGearColumns[] = {
    {"radius", "length", "of a point of the flank, from the root up"},
    {"x, y", "length", "from the gear's centre, the tooth's middle on the y axis"},
    {"thickness", "length", "arc of the tooth at this radius"},
    {"pressure_angle_deg", "deg", "of the involute there; empty in the fillet"},
    {"is_involute", "1", "1: of the involute, 0: of the fillet"}};

}  // namespace

std::span<const KeyedEntry> gear_tables() {
  return kGearTables;
}

std::span<const KeyedEntry> gear_pair_tables() {
  return kPairTables;
}

std::span<const Metric> gear_metrics() {
  return kGearMetrics;
}

std::span<const Metric> gear_pair_metrics() {
  return kPairMetrics;
}

std::vector<ListSection> Kind<problems::GearProblem>::sections() {
  return {list_section("gear_tables", "tables of a gear", kGearTables)};
}

std::vector<ListSection> Kind<problems::GearPairProblem>::sections() {
  return {list_section("gear_pair_tables", "tables of a gear pair", kPairTables)};
}

std::vector<MetricList> Kind<problems::GearProblem>::metric_lists() {
  return {{"gear_metrics", "metric of a gear (of a pair: pinion., wheel. or worm. before it)",
           kGearMetrics},
          {"gear_columns", "column of a gear", kGearColumns, false}};
}

std::vector<MetricList> Kind<problems::GearPairProblem>::metric_lists() {
  return {{"gear_pair_metrics", "metric of a gear pair", kPairMetrics}};
}

}  // namespace cognate::app
