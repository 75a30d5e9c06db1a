#include "app/documents/catalogue.hpp"

#include <fmt/core.h>

#include <string>

#include "problems/linkage/keys.hpp"

namespace cognate::app {
namespace {

namespace keys = problems::reading;

constexpr Entry kObjectives[] = {{"objectives", {}}};  // see objectives_meaning

constexpr Entry kAtlas[] = {{"atlas",
                             "paths, closed curves: the study file of an atlas, whose nearest "
                             "curves a search begins with"}};

constexpr auto kSolveOptions =
    entries_of(keys::kSearchKeys, kObjectives, keys::kLossKeys, keys::kStoppingKeys, kAtlas,
               keys::kCertificateKeys, keys::kRobustKeys);

constexpr Metric kMotionMetrics[] = {
    {"class", "",
     "which of crank and rocker turns fully, by Grashof's criterion; a change point has the class "
     "that it borders, parallelogram and rhombus are double-cranks"},
    {"change_point", "", "true where all links can lie on one line"},
    {"change_point_kind", "",
     "of a four-bar with one: parallelogram, antiparallelogram, kite, rhombus; single: no equal "
     "lengths"},
    {"transmission_angle_deg.min", "deg", "minimum angle between coupler and rocker"},
    {"transmission_angle_deg.max", "deg", "maximum angle between coupler and rocker"},
    {"transmission_angle_deg.acute_min", "deg", "minimum of the angle and its supplement"},
    {"time_ratio", "1", "time of the slower over the quicker stroke; null without limits"},
    {"defects", "", "which of circuit, branch, order the design has; empty when sound"}};

constexpr Metric kKindMetrics[] = {
    {"input_start_deg", "deg", "input angle at the start, from A to D (functions)"},
    {"output_start_deg", "deg", "output angle at the start, from A to D (functions)"},
    {"precision_residual", "1", "residual of the equations of an exact synthesis"},
    {"condition", "1", "condition number of an exact synthesis"},
    {"output_start", "length", "displacement at the start (functions by a slider-crank)"},
    {"link_ratio", "1", "longest over shortest link, if it is an objective"},
    {"longest_link", "length",
     "of crank, coupler, rocker and frame (chains: of the crank and the links of the dyads), if "
     "size is an objective"},
    {"stray_between_points", "length",
     "how far a path strays from the ways between its points, root mean square, beyond what it "
     "misses at them and half of the way (chains, free timing)"},
    {"link_count", "1", "links of a chain, the frame among them, if their number is an objective"},
    {"transmission_NAME_min_deg", "deg",
     "minimum of the transmission angle and its supplement of the dyad whose joint is NAME, or of "
     "the link that holds the pin NAME of a three-pin link (chains)"},
    {"topology", "", "topology of the chain of dyads, chosen among several (paths, dwells, legs)"},
    {"crank_turns_fully", "", "whether the crank can turn through a whole turn"},
    {"output", "", "the output body of mechanisms other than four-bars"},
    {"output_swing_deg", "deg", "swing of the output in the range driven"},
    {"output_stroke", "length", "stroke of the output in the range driven"},
    {"circuit_swing_deg", "deg", "swing of the output on the whole circuit; 360: it turns fully"},
    {"circuit_stroke", "length", "stroke of the output on the whole circuit"},
    {"pressure_angle_max_deg", "deg", "maximum pressure angle of sliders and bars, unsigned"},
    {"swing_deg", "deg", "angle through which the output swings (quick returns, dwells)"},
    {"outer_limit_deg, inner_limit_deg", "deg",
     "the rocker's angle from A to D at its limits, crank and coupler extended and folded (quick "
     "returns)"},
    {"half_band_deg", "deg", "maximum deviation of the output from its mid position in a dwell"},
    {"dwell_from_deg, dwell_2_from_deg", "deg", "crank angle at which a dwell begins"},
    {"apart_deg", "deg", "difference of the output's mid positions in two dwells"},
    {"half_band, apart", "length", "the same of a slider (dwells)"},
    {"duty", "1", "share of the turn in which the foot stands, the duty factor (legs)"},
    {"stride", "length", "extent of the foot's path along the ground in stance (legs)"},
    {"step_height", "length", "extent of the foot's path across the ground over the turn (legs)"},
    {"flatness", "1", "greatest height of the foot above the ground in stance over stride (legs)"},
    {"foot_speed_min, foot_speed_max", "1",
     "of the foot in stance over its mean speed; below 0 it steps back (legs)"},
    {"stance_from_deg", "deg", "crank angle at which the stance begins (legs)"},
    {"stroke", "length",
     "distance through which the output slides (quick returns: over the full turn; functions by a "
     "slider-crank: over their motion)"},
    {"pressure_angle_deg", "deg", "maximum pressure angle of the slider (quick returns)"},
    {"crank_pivot_arc", "",
     "near or far: the circle on which the crank pivot lies (quick returns)"},
    {"dyads", "", "the two dyads that guide the body: RR, PR (slider), RP (block) (motions)"},
    {"angle_error_max_deg", "deg",
     "maximum error of the body's angle at a pose (motions, exact paths)"},
    {"angle_error_rms_deg", "deg", "its root mean square over the poses (motions, least squares)"},
    {"position_error_rms, position_error_max", "length",
     "errors of the position of the body's origin (motions, least squares)"},
    {"body_angle_in_link_deg", "deg", "of the body's first axis in its link's axes (motions)"},
    {"slide_1, slide_2, ...", "length", "position of a driving slider at each pose (motions)"},
    {"curve_deviation_max", "length",
     "maximum distance of the coupler curve from a closed target, over the full turn (paths)"},
    {"target_scale", "1", "place = \"similar\": scale factor of the closed target (paths)"},
    {"target_turn_deg", "deg", "then its rotation about the origin, counter-clockwise"},
    {"target_shift_x, target_shift_y", "length",
     "then its translation; errors are those before the transformation"},
    {"contact_points", "1",
     "coinciding points of path and line; 9: straight to 8th order (straight lines)"},
    {"straight_length_at_0_001, _at_0_01", "length",
     "longest segment with deviation/length at most 0.1 %, 1 %"},
    {"deviation_at_0_001, _at_0_01", "length", "its maximum distance from its best line"},
    {"direction_deg_at_0_001, _at_0_01", "deg", "of that line, with increasing crank angle"},
    {"crank_from_deg_at_0_001, _at_0_01", "deg", "crank angle at which the segment begins"},
    {"crank_to_deg_at_0_001, _at_0_01", "deg", "crank angle at which it ends"},
    {"speed_variation_at_0_001, _at_0_01", "1",
     "(max - min)/mean of the speed along the line for a crank of constant speed"},
    {"straight_length_over_longest_link", "1",
     "straight length (of exact designs at 0.1 %) over the longest link"},
    {"straight_length, deviation", "length",
     "of a searched segment: distance of its ends along the best line; maximum distance from it"},
    {"deviation_relative", "1", "deviation over the straight length"},
    {"start_family", "", "family of starts from which the linkage was refined (searched lines)"},
    {"crank_from_deg, crank_to_deg", "deg", "crank angles between which the segment lies"},
    {"direction_deg", "deg", "of its best line, with increasing crank angle"},
    {"speed_variation", "1", "(max - min)/mean of the speed along it at constant crank speed"},
    {"size_over_length", "1",
     "maximum dimension of a link, the coupler's with its point, over the straight length"},
    {"nominal_error, quantile, worst_case", "length",
     "paths and poses, solve.robust: root mean square error of the nominal design; quantile of the "
     "error over manufactured copies; the greatest within the tolerances"},
    {"nominal_error_deg, quantile_deg, worst_case_deg", "deg", "likewise of functions"},
    {"straight_length_over_box", "1",
     "over the diagonal of the box, along the line, of both moving pivots over the segment"}};

constexpr auto kMetrics = with_cycle_quantities(
    kMotionMetrics,
    [](const problems::CycleDeclaration& of) {
      return Metric{of.key(), of.unit, of.meaning};
    },
    kKindMetrics);

constexpr Metric kQuantities[] = {
    {"combinations", "1", "combinations of teeth and module that were tested (gear pairs)"},
    {"refused_by_ratio, refused_by_hunting", "1", "of these, outside the tolerance, or divisible"},
    {"refused_by_centre_distance", "1", "with no shifts within bounds for the distance"},
    {"refused_by_undercut", "1", "with such shifts only for undercut gears"},
    {"combinations_searched", "1", "searched for their best shifts"},
    {"problems_solved", "1", "searches and refinements from neighbours, with solve.objectives"},
    {"solutions", "1", "positions and points with the contact requested (straight lines)"},
    {"dyads", "1", "real dyads through five poses: 0, 2 or 4 (motions)"},
    {"circuit_defects", "1", "linkages left out that reach their limits on two circuits"},
    {"expected_solutions", "1",
     "complex ones of general positions: by theory, with given parts counted (exact paths)"},
    {"complex_solutions", "1", "those found; triplets of cognates where the points are nine"},
    {"solutions_at_infinity", "1", "those with pivots at infinity: a slider replaces a crank"},
    {"singular_solutions", "1", "those at which several meet, or a curve of them"},
    {"lost_paths", "1", "solutions that were not reached and are unknown"},
    {"certified_solutions", "1", "those proven true and distinct by an interval test"},
    {"real_solutions", "1", "those with linkages of the real plane"},
    {"certified_real_solutions", "1", "real ones proven to be real"},
    {"free_parameters", "1", "dimensions that the positions leave free"},
    {"family_members_solved", "1", "choices of these that were solved for"},
    {"raster_combinations", "1", "of values of the dimensions on a raster"},
    {"raster_covered", "1",
     "of these, that were evaluated or lie in ranges no local minimum of which is better"},
    {"raster_evaluated", "1", "of these, that were evaluated"},
    {"raster_boxes", "1", "ranges of the dimensions whose minima were found"},
    {"raster_complete", "boolean", "whether all combinations are covered"},
    {"raster_proven", "boolean",
     "whether each combination was evaluated, or of cams is larger or excluded by a lower bound of "
     "the base radius, of quick returns excluded by a bound of its error: none is better"},
    {"raster_error, raster_bound", "length or deg",
     "root mean square error of the best design on the raster, of straight lines the deviation, of "
     "dwells the half band; "
     "what a combination that is not covered may have by the minima of its range (no proof unless "
     "raster_proven)"},
    {"raster_error_deg, continuous_error_deg, rounded_error_deg", "deg",
     "four-bars and guide-bars of a quick return: the larger of the errors of theta and of the "
     "swing, likewise"},
    {"raster_error_relative, continuous_error_relative, rounded_error_relative", "1",
     "slider-cranks and shapers of a quick return: the larger of the errors of theta in radians "
     "and of the stroke over it, likewise"},
    {"raster_gap", "1", "|raster_error - raster_bound|/raster_error, likewise of length and size"},
    {"raster_length, continuous_length, rounded_length", "length",
     "straight lines of limited deviation: that of the segment, likewise"},
    {"raster_size, continuous_size, rounded_size", "1 or length",
     "straight lines of given length and deviation: size over length, likewise; cams: the base "
     "radius as files have it, of rollers that of the prime circle"},
    {"continuous_error, rounded_error", "length or deg",
     "of the optimum without a raster, and of that with each dimension rounded"},
    {"rounded_feasible", "boolean", "whether the latter meets every constraint"},
    {"robust_quantile, nominal_quantile", "length",
     "paths and poses, solve.robust: greatest error of that share of what is made of the robust "
     "design, of the nominal optimum"},
    {"robust_quantile_deg, nominal_quantile_deg", "deg", "likewise of functions"},
    {"robust_worst_case, nominal_worst_case, robust_worst_case_deg, nominal_worst_case_deg",
     "length or deg", "solve.robust = \"worst\": greatest error within the tolerances, likewise"},
    {"robust_samples", "1", "by which these are judged"},
    {"starts", "1", "local searches of a global one"},
    {"target_length", "length", "of a closed target curve (paths)"},
    {"best_hits", "1", "how many of them reached the best minimum"},
    {"chance_of_unseen_minimum", "1",
     "estimated probability that one more which leads to a minimum as good as the ten best leads "
     "to "
     "a new one (Good 1953)"}};

std::string objectives_meaning() {
  const auto quoted = [](const problems::CycleDeclaration& of) {
    return fmt::format("\"{}\"", of.key());
  };
  return fmt::format(
      "path-, function- and motion-generation by least squares or minimax: [\"error\"] (default); "
      "[\"error\", MEASURE]: a Pareto front of so many designs (default 12); [MEASURE]: its best "
      "within a bound on the error. MEASURE: \"transmission_angle\" (its minimum, folded to at "
      "most 90 deg, maximised), \"link_ratio\" (longest over shortest link), \"size\" (longest "
      "link), {} (over the full turn), all minimised",
      problems::list_of(quoted));
}

}  // namespace

std::span<const Entry> solve_options() {
  static const std::string objectives = objectives_meaning();
  static const auto options = [] {
    auto all = kSolveOptions;
    std::ranges::find(all, "objectives", &Entry::name)->meaning = objectives;
    return all;
  }();
  return options;
}

std::span<const Metric> metrics() {
  return kMetrics;
}

std::span<const Metric> quantities() {
  return kQuantities;
}

}  // namespace cognate::app
