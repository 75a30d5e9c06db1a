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
    {"points", "rows of the table for the fillet and for the involute (default 20)"},
    {"span_teeth", "over which the span is measured (default: the number that touches midway)"}};

constexpr Entry kPair[] = {
    {"gearing",
     "\"spur\" (default), \"helical\", \"internal\", \"rack\", \"bevel\" (straight) or \"worm\""},
    {"teeth", "[z1, z2] of pinion and wheel; left out: found within bounds.teeth"},
    {"module", "normal of helical gears, outer of bevel, axial of worms; left out: bounds.modules"},
    {"profile_shift",
     "[x1, x2], each a number or \"free\"; left out: found; internal: 0; bevel: [x, -x]"},
    {"centre_distance", "left out: found, or that with the backlash"},
    {"backlash", "arc on the working pitch circles where a shift or the distance is found (0)"},
    {"helix_deg",
     "helical: of the pinion, the wheel has the other hand; \"free\": that of the centre distance"},
    {"face_width", "for the overlap ratio; of bevel gears along the cone"},
    {"tip_reduction", "[k1, k2] of the tip circles, in modules (default 0)"},
    {"cutter_teeth", "internal: of the pinion-shaped tool that cuts the ring (default 20)"},
    {"pinion_teeth", "rack: of the pinion"},
    {"pinion_shift", "rack: profile shift of the pinion (default 0)"},
    {"rack_distance",
     "rack: from the pinion's centre to its reference line; left out: that with the backlash"},
    {"shaft_angle_deg", "bevel: between the axes (default 90)"},
    {"starts", "worm: its threads (default 1)"},
    {"wheel_teeth", "worm"},
    {"diameter_quotient", "worm: reference diameter over module (default 10)"},
    {"wheel_shift", "worm: profile shift of the wheel (default 0)"},
    {"friction", "worm: coefficient, for efficiency and self-locking"}};

constexpr Entry kPairBounds[] = {
    {"teeth", "[[min, max], [min, max]] of pinion and wheel, where teeth are left out"},
    {"modules", "[m, ...] to choose from, where module is left out"},
    {"profile_shift", "[min, max] of each that is free (default [-0.6, 1.2])"},
    {"centre_distance", "[min, max] where it is free; inf leaves a side open"}};

constexpr Entry kPairTarget[] = {
    {"ratio", "z2/z1"},
    {"ratio_tolerance", "relative (default 0)"},
    {"objective",
     "\"balanced-sliding\" (its maximum minimised; default), \"contact-ratio\" "
     "(maximised) or \"size\" (the centre distance, minimised)"}};

constexpr auto kPairConstraints =
    entries_of(problems::reading::kMeshKeys, problems::reading::kToothKeys);

constexpr Entry kPairSolve[] = {{"designs", "1 to 100 (default 3), one for each choice of teeth"}};

constexpr KeyedEntry kGearTables[] = {{"[mechanism]", "the gear", kGear},
                                      {"[rack]", "that cuts it", kRack},
                                      {"[output]", "of its flank", kOutput}};

constexpr KeyedEntry kPairTables[] = {
    {"[mechanism]", "the pair; what is left out is found", kPair},
    {"[rack]", "that cuts both", kRack},
    {"[bounds]", "of what is found (spur and helical gears)", kPairBounds},
    {"[target]", "what is sought", kPairTarget},
    {"[constraints]", "on the pair", kPairConstraints},
    {"[solve]", "how many designs are returned", kPairSolve}};

constexpr Metric kGearMetrics[] = {
    {"teeth", "1", "of a gear of a pair", "z"},
    {"profile_shift", "1", "in modules", "x"},
    {"reference_diameter", "length", "module (transverse) times teeth", "d"},
    {"base_diameter", "length", "of the involute's base circle", "d_b"},
    {"tip_diameter, root_diameter", "length", "of bevel gears at the outer end", "d_a, d_f"},
    {"form_diameter", "length", "where the involute begins, as the rack cuts it", "d_Ff"},
    {"addendum, dedendum, tooth_depth", "length", "from the reference circle; their sum",
     "h_a, h_f, h"},
    {"pitch, base_pitch", "length", "arcs from tooth to tooth on reference and base circle",
     "p, p_b"},
    {"tooth_thickness", "length", "arc on the reference circle", "s"},
    {"space_width", "length", "arc on the reference circle", "e"},
    {"base_thickness", "length", "arc on the base circle", "s_b"},
    {"tip_thickness", "length", "arc (transverse) on the tip circle; negative: pointed below it",
     "s_a"},
    {"chordal_thickness, chordal_addendum", "length",
     "chord of s_n on the reference circle, across the tooth, and its depth below the tip",
     "s̄_n, h̄_a"},
    {"constant_chord, constant_chord_addendum", "length",
     "chord where the rack in mesh touches both flanks, and its depth below the tip", "s̄_c, h̄_c"},
    {"pointed_diameter", "length", "of a pointed tooth: where its flanks meet"},
    {"undercut", "boolean", "whether the rack cuts into the involute"},
    {"least_teeth", "1", "without undercut at this shift", "z_min"},
    {"least_profile_shift", "1", "without undercut of this number of teeth", "x_min"},
    {"virtual_teeth", "1", "helical: z/cos3(helix); bevel: z/cos(cone angle)", "z_v"},
    {"base_helix_deg", "deg", "helical: on the base cylinder", "β_b"},
    {"lead", "length", "helical: along the axis in a turn; of a worm likewise", "p_z"},
    {"normal_tooth_thickness", "length", "helical: on the reference circle across the tooth",
     "s_n"},
    {"normal_tip_thickness", "length", "helical: of the tip across the tooth", "s_an"},
    {"span_teeth", "1", "teeth over which the span is measured", "k"},
    {"span_measurement", "length", "over so many teeth (base tangent length)", "W_k"},
    {"pin_diameter", "length", "1.728 modules", "D_M"},
    {"measurement_over_pins", "length", "over two such pins (balls) in opposite spaces", "M_d"},
    {"cone_angle_deg, tip_angle_deg, root_angle_deg", "deg", "bevel: of pitch, tip, root cones",
     "δ, δ_a, δ_f"},
    {"mean_module", "length", "bevel: at half the face width", "m_m"},
    {"lead_angle_deg", "deg", "of a worm", "γ"},
    {"throat_diameter", "length", "of a worm's wheel"},
    {"working_diameter", "length", "in a pair: of the pitch circle that rolls", "d_w"},
    {"contact_start_diameter, contact_end_diameter", "length", "of the flank that touches",
     "d_Nf, d_Na"},
    {"tip_clearance", "length", "from the tip to the other gear's root", "c"},
    {"sliding_start, sliding_end", "1", "specific sliding 1 - v_other/v_own at these", "ζ_f, ζ_a"},
    {"interferes", "boolean", "whether the other's tips dig into its fillet or root"}};

constexpr Metric kPairMetrics[] = {
    {"ratio", "1", "z2/z1; of a worm z2 over its starts", "u"},
    {"module", "length", "as given or chosen", "m"},
    {"helix_deg", "deg", "helical: of the pinion on the reference cylinder", "β"},
    {"centre_distance", "length", "of the axes", "a_w"},
    {"reference_centre_distance", "length", "sum of the reference radii", "a"},
    {"zero_backlash_distance", "length", "centre distance at which these gears have no backlash"},
    {"profile_shift_difference", "1", "internal: the ring's less the pinion's, in modules"},
    {"tips_overlap", "boolean", "internal: whether tips meet beside the path of contact"},
    {"radial_assembly", "boolean", "internal: whether the pinion goes into the ring radially"},
    {"rack_distance", "length", "rack: from the pinion's centre to its reference line"},
    {"travel_per_turn", "length", "rack: in a turn of the pinion"},
    {"profile_shift_sum", "1", "in modules", "Σx"},
    {"working_pressure_angle_deg", "deg", "at the centre distance", "α_wt"},
    {"contact_ratio", "1", "of the transverse section; below 1: it cannot drive continuously",
     "ε_α"},
    {"overlap_ratio", "1", "helical: face width over axial pitch; also of a gear", "ε_β"},
    {"total_contact_ratio", "1", "helical: the sum of both", "ε_γ"},
    {"continuous_centre_distance_max", "length",
     "where the contact ratio is below 1: the maximum at which it is 1"},
    {"path_length", "length", "of contact", "g_α"},
    {"approach_length, recess_length", "length", "before and after the pitch point", "g_f, g_a"},
    {"backlash", "length", "arc on the working pitch circles; negative: the teeth overlap", "j_wt"},
    {"normal_backlash", "length", "along the line of action; of helical gears across the teeth",
     "j_bn"},
    {"sliding_max", "1", "maximum magnitude of specific sliding at the ends of the flanks"},
    {"sliding_speed_ratio_max", "1", "maximum sliding speed over the pitch line's", "K_g"},
    {"shaft_angle_deg", "deg", "bevel: between the axes", "Σ"},
    {"cone_distance", "length", "bevel: from the apex to the outer end", "R_e"},
    {"normal_pressure_angle_deg", "deg", "of a worm", "α_n"},
    {"sliding_speed_ratio", "1", "worm: sliding speed over its pitch line's"},
    {"efficiency", "1", "worm: where it drives; with friction", "η"},
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
  return {{"gear_metrics",
           "metric of a gear (of a pair: pinion., wheel., worm. or rack. before it)", kGearMetrics},
          {"gear_columns", "column of a gear", kGearColumns, false}};
}

std::vector<MetricList> Kind<problems::GearPairProblem>::metric_lists() {
  return {{"gear_pair_metrics", "metric of a gear pair", kPairMetrics}};
}

}  // namespace cognate::app
