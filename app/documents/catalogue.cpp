#include "app/documents/catalogue.hpp"

namespace cognate::app {
namespace {

constexpr Entry kProblemKinds[] = {
    {"analysis", "a given mechanism is evaluated over its drive (cognate analyze)"},
    {"cam", "a follower is to move by given laws over a turn of a cam"},
    {"function-generation", "the rocker's angle is to follow a function of the crank's angle"},
    {"gear", "a gear as its rack cuts it is evaluated (cognate analyze)"},
    {"gear-pair", "two gears are to mesh; teeth, shifts or centre distance are found"},
    {"machine",
     "what a motor, loads and inertias make of a mechanism's motion: steady, start, stop (cognate "
     "analyze)"},
    {"motion-generation", "a body is to be carried through poses"},
    {"path-generation",
     "a point of the coupler is to pass through given points or follow a closed curve"},
    {"quick-return", "the return is to take less time than the advance, by a given ratio"},
    {"straight-line", "a point of the coupler is to move along a straight line"},
    {"study", "any of these with other numbers, as many designs as wanted (cognate sweep)"}};

constexpr Entry kSolveOptions[] = {
    {"solver", "one of the solvers above (default \"auto\")"},
    {"starts", "how many starts are refined (default: chosen by the problem)"},
    {"designs",
     "how many different designs to return, 1 to 100 (default 3); where the solutions are finitely "
     "many: to 10000, by default all"},
    {"objectives",
     "path-, function- and motion-generation by least squares or minimax: [\"error\"] (default); "
     "[\"error\", MEASURE]: a Pareto front of so many designs (default 12); [MEASURE]: its best "
     "within a bound on the error. MEASURE: \"transmission_angle\" (the least acute one, "
     "greatest), "
     "\"link_ratio\" (longest over shortest link, least), \"size\" (longest link, least), "
     "\"peak_acceleration\", \"torque_ripple\", \"speed_fluctuation\", \"flywheel_inertia\" or "
     "\"motor_power\" (over the full turn, least)"},
    {"loss",
     "none (default), huber, soft-l1, cauchy, arctan, tukey: least squares of paths and functions "
     "that gross errors in the target do not govern"},
    {"loss_scale",
     "with a loss: the error from which it differs, a length for paths, radians for functions"},
    {"tolerance", "relative change of the error at which a refinement stops"},
    {"atlas",
     "paths, closed curves: the study file of an atlas, whose nearest curves a search begins with"},
    {"certify",
     "true: prove how near the best design is to the best possible; timed paths and functions by "
     "least squares (at most 60 s, or what --time-limit leaves)"},
    {"certify_gap", "the relative gap at which a certificate is complete (default 1e-3)"}};

constexpr Metric kMetrics[] = {
    {"class", "",
     "which of crank and rocker turns fully, by Grashof's criterion; a change point has the class "
     "that it borders, parallelogram and rhombus are double-cranks"},
    {"change_point", "", "true where all links can lie on one line"},
    {"change_point_kind", "",
     "of a four-bar with one: parallelogram, antiparallelogram, kite, rhombus; single: no equal "
     "lengths"},
    {"transmission_angle_deg.min", "deg", "least angle between coupler and rocker"},
    {"transmission_angle_deg.max", "deg", "greatest angle between coupler and rocker"},
    {"transmission_angle_deg.acute_min", "deg", "least of the angle and its supplement"},
    {"time_ratio", "1", "time of the slower over the quicker stroke; null without limits"},
    {"defects", "", "which of circuit, branch, order the design has; empty when sound"},
    {"peak_acceleration", "length/s2 or rad/s2",
     "greatest over the turn, of the coupler point or of a function's rocker, where asked for"},
    {"torque_ripple", "N m", "greatest less least driving torque, where asked for"},
    {"speed_fluctuation", "1",
     "(greatest - least)/mean speed, where asked for; from 2 on the machine does not come round"},
    {"flywheel_inertia", "kg m2", "least flywheel for a given fluctuation, where asked for"},
    {"motor_power", "W", "greatest power of the drive over the turn, where asked for"},
    {"input_start_deg", "deg", "input angle at the start, from A to D (functions)"},
    {"output_start_deg", "deg", "output angle at the start, from A to D (functions)"},
    {"precision_residual", "1", "what an exact synthesis leaves of its equations"},
    {"condition", "1", "condition number of an exact synthesis"},
    {"output_start", "length", "displacement at the start (functions by a slider-crank)"},
    {"link_ratio", "1", "longest over shortest link, where it is an objective"},
    {"longest_link", "length", "of crank, coupler, rocker and frame, where size is an objective"},
    {"crank_turns_fully", "", "whether the crank can turn through a whole turn"},
    {"output", "", "of mechanisms other than four-bars: the body that is the output"},
    {"output_swing_deg", "deg", "angle through which that swings in the range driven"},
    {"output_stroke", "length", "distance through which it slides in the range driven"},
    {"circuit_swing_deg", "deg",
     "angle through which it swings on the whole circuit; 360: it turns"},
    {"circuit_stroke", "length", "distance through which it slides on the whole circuit"},
    {"pressure_angle_max_deg", "deg", "greatest pressure angle of sliders and bars, unsigned"},
    {"swing_deg", "deg", "angle through which the output swings (quick returns)"},
    {"stroke", "length",
     "distance through which the output slides (quick returns: over the full turn; functions by a "
     "slider-crank: over their motion)"},
    {"pressure_angle_deg", "deg", "greatest pressure angle of the slider (quick returns)"},
    {"crank_pivot_arc", "",
     "near or far: the circle on which the crank pivot lies (quick returns)"},
    {"dyads", "", "the two dyads that guide the body: RR, PR (slider), RP (block) (motions)"},
    {"angle_error_max_deg", "deg",
     "greatest error of the body's angle at a pose (motions, exact paths)"},
    {"angle_error_rms_deg", "deg", "its root mean square over the poses (motions, least squares)"},
    {"position_error_rms, position_error_max", "length",
     "of the distances of the body's origin alone (motions, least squares)"},
    {"body_angle_in_link_deg", "deg", "of the body's first axis in its link's axes (motions)"},
    {"slide_1, slide_2, ...", "length", "a driving slider's place at each pose (motions)"},
    {"curve_deviation_max", "length",
     "greatest distance of the coupler curve from a closed target, over the full turn (paths)"},
    {"target_scale", "1", "place = \"similar\": what the closed target was enlarged by (paths)"},
    {"target_turn_deg", "deg", "what it was then turned by, counter-clockwise, about the origin"},
    {"target_shift_x, target_shift_y", "length",
     "what it was then moved by; errors are before all"},
    {"contact_points", "1", "of path and line, 9 for one straight to 8th order (straight lines)"},
    {"straight_length_at_0_001, _at_0_01", "length",
     "longest stretch with deviation/length at most 0.1 %, 1 %"},
    {"deviation_at_0_001, _at_0_01", "length", "its largest distance from its best line"},
    {"direction_deg_at_0_001, _at_0_01", "deg", "of that line as the crank's angle grows"},
    {"crank_from_deg_at_0_001, _at_0_01", "deg", "crank angle at which the stretch begins"},
    {"crank_to_deg_at_0_001, _at_0_01", "deg", "crank angle at which it ends"},
    {"speed_variation_at_0_001, _at_0_01", "1",
     "(max - min)/mean of the speed along the line for a crank of constant speed"},
    {"straight_length_over_longest_link", "1",
     "straight length (of exact designs at 0.1 %) over the longest link"},
    {"straight_length, deviation", "length",
     "of a searched stretch: between the feet of its ends on the best line; farthest from it"},
    {"deviation_relative", "1", "that over the straight length"},
    {"start_family", "", "how the linkage was drawn that it was refined from (searched lines)"},
    {"crank_from_deg, crank_to_deg", "deg", "crank angles between which the stretch lies"},
    {"direction_deg", "deg", "of its best line as the crank's angle grows"},
    {"speed_variation", "1", "(max - min)/mean of the speed along it at constant crank speed"},
    {"size_over_length", "1",
     "largest dimension of a link, the coupler's with its point, over the straight length"},
    {"straight_length_over_box", "1",
     "over the diagonal of the box along the line that holds both moving pivots meanwhile"}};

constexpr Metric kFacts[] = {
    {"combinations", "1", "of teeth and module that were tested (gear pairs)"},
    {"refused_by_ratio, refused_by_hunting", "1", "of these, outside the tolerance, or divisible"},
    {"refused_by_centre_distance", "1", "that no shifts within bounds bring to the distance"},
    {"refused_by_undercut", "1", "that only undercut gears would"},
    {"combinations_searched", "1", "for their best shifts"},
    {"problems_solved", "1", "searches and refinements from neighbours, with solve.objectives"},
    {"solutions", "1", "positions and points with the contact asked for (straight lines)"},
    {"dyads", "1", "real dyads through five poses: 0, 2 or 4 (motions)"},
    {"circuit_defects", "1", "linkages left out that reach their limits on two circuits"},
    {"expected_solutions", "1",
     "complex ones of general positions: by theory, with given parts counted (exact paths)"},
    {"complex_solutions", "1", "those found; triplets of cognates where the points are nine"},
    {"solutions_at_infinity", "1", "those whose pivots go there: a slider for a crank"},
    {"singular_solutions", "1", "those at which several meet, or a curve of them"},
    {"lost_paths", "1", "solutions that were not reached, of which nothing is known"},
    {"certified_solutions", "1", "those proven true and distinct by an interval test"},
    {"real_solutions", "1", "those with linkages of the real plane"},
    {"certified_real_solutions", "1", "real ones proven to be real"},
    {"free_parameters", "1", "dimensions that the positions leave free"},
    {"family_members_solved", "1", "choices of these that were solved for"},
    {"starts", "1", "local searches of a global one"},
    {"target_length", "length", "of a closed target curve (paths)"},
    {"best_hits", "1", "how many of them led to the best minimum"},
    {"chance_of_unseen_minimum", "1",
     "that one more would lead to a minimum not seen, as good as those kept (Good 1953)"}};

constexpr Metric kAnalysisMetrics[] = {
    {"class", "", "which link turns fully; of a chain its dyads"},
    {"change_point", "", "true where all links can lie on one line"},
    {"change_point_kind", "",
     "of a four-bar with one: parallelogram, antiparallelogram, kite, rhombus; single: no equal "
     "lengths"},
    {"rocker_turns_fully", "", "of a four-bar: whether the rocker can turn through a whole turn"},
    {"moves_as", "", "of a four-bar with a change point: parallelogram, antiparallelogram..."},
    {"crank_turns_fully", "", "whether the crank can turn through a whole turn"},
    {"mobility", "1", "independent motions, by Gruebler's count of bodies and joints"},
    {"transmission_angle_deg.min", "deg", "least transmission angle of all dyads in all ranges"},
    {"transmission_angle_deg.max", "deg", "greatest transmission angle of all dyads in all ranges"},
    {"transmission_angle_deg.acute_min", "deg", "least of the angle and its supplement"},
    {"pressure_angle_max_deg", "deg",
     "greatest pressure angle of sliders and bars in all ranges, unsigned"},
    {"output", "", "the body whose motion is the mechanism's output"},
    {"output_swing_deg", "deg", "angle through which the output swings in the range driven"},
    {"output_stroke", "length", "distance through which the output slides in the range driven"},
    {"circuit_swing_deg", "deg",
     "angle through which it swings on the whole circuit, all branches; 360: it turns"},
    {"circuit_stroke", "length", "distance through which it slides on the whole circuit"},
    {"time_ratio", "1", "time of the slower over the quicker stroke; null without limits"},
    {"longest_link", "length", "of a four-bar's links (curve)"},
    {"link_ratio", "1", "of that to the shortest (curve)"},
    {"size", "length", "diagonal of the box along the axes that holds B and C (curve)"},
    {"curve_length", "length", "of the coupler curve over its circuit (curve)"},
    {"curve_area", "length^2", "enclosed, positive where it runs counter-clockwise (curve)"},
    {"curve_width_min", "length", "least distance of parallel lines that hold it (curve)"},
    {"curve_width_max", "length", "its diameter (curve)"},
    {"fourier.m4", "1", "magnitude of its descriptor -4 (curve)"},
    {"fourier.m3", "1", "magnitude of its descriptor -3 (curve)"},
    {"fourier.m2", "1", "magnitude of its descriptor -2 (curve)"},
    {"fourier.m1", "1", "magnitude of its descriptor -1 (curve)"},
    {"fourier.p1", "1", "magnitude of its descriptor 1 (curve)"},
    {"fourier.p2", "1", "magnitude of its descriptor 2 (curve)"},
    {"fourier.p3", "1", "magnitude of its descriptor 3 (curve)"},
    {"fourier.p4", "1", "magnitude of its descriptor 4 (curve)"},
    {"fourier_phase_deg.m4", "deg", "phase of its descriptor -4 (curve)"},
    {"fourier_phase_deg.m3", "deg", "phase of its descriptor -3 (curve)"},
    {"fourier_phase_deg.m2", "deg", "phase of its descriptor -2 (curve)"},
    {"fourier_phase_deg.p2", "deg", "phase of its descriptor 2 (curve)"},
    {"fourier_phase_deg.p3", "deg", "phase of its descriptor 3 (curve)"},
    {"fourier_phase_deg.p4", "deg", "phase of its descriptor 4 (curve)"},
    {"straight_length_at_0_001", "length", "longest stretch with deviation/length 0.1 % (curve)"},
    {"straight_length_at_0_01", "length", "the same with 1 % (curve)"},
    {"straight_length_over_longest_link", "1", "straight length at 0.1 % over that (curve)"},
    {"cusps", "1", "of the coupler curve on its circuit (curve)"},
    {"double_points", "1", "where that crosses itself (curve)"},
    {"inflections", "1", "of it (curve)"},
    {"torque_N_m.min", "N m", "least driving torque, with the crank angle as min_at_deg"},
    {"torque_N_m.max", "N m", "greatest driving torque, with the crank angle as max_at_deg"},
    {"drive_force_N.min", "N", "least driving force, with the displacement as min_at"},
    {"drive_force_N.max", "N", "greatest driving force, with the displacement as max_at"},
    {"torque_N_m.max_unbounded_at_deg", "deg",
     "instead of max: the dead point near which it grows without bound; min and drive_force_N "
     "alike"},
    {"reaction_max_N.P_on_LINK", "N", "greatest force at the joint P on LINK"},
    {"reaction_max_at_deg.P_on_LINK", "deg",
     "the crank angle there; reaction_max_at: displacement"},
    {"reaction_max_unbounded_at_deg.P_on_LINK", "deg",
     "instead of both: the dead or change point near which it grows without bound"},
    {"closure_residual", "1", "greatest gap at a joint over the size of the mechanism"},
    {"power_residual", "1", "torque of the reactions less that of virtual work, over its greatest"},
    {"defects", "", "always empty: nothing was asked of the motion"}};

constexpr Metric kAnalysisColumns[] = {
    {"crank_deg", "deg", "the crank's angle from the x axis, the first column"},
    {"slide", "length", "the driving slider's displacement, the first column"},
    {"LINK_deg", "deg", "angle of the link from the x axis, going on from row to row"},
    {"LINK_omega_rad_s", "rad/s", "its angular velocity"},
    {"LINK_alpha_rad_s2", "rad/s2", "its angular acceleration"},
    {"SLIDER_s", "length", "displacement along its guide or slot"},
    {"SLIDER_v_per_s", "length/s", "its velocity along the guide"},
    {"SLIDER_a_per_s2", "length/s2", "its acceleration along the guide"},
    {"P_x, P_y", "length", "where the point P stands"},
    {"P_vx_per_s, P_vy_per_s", "length/s", "its velocity"},
    {"P_ax_per_s2, P_ay_per_s2", "length/s2", "its acceleration"},
    {"P_curvature", "1/length", "of its path, positive to the left as the drive rises"},
    {"LINK_pole_x, LINK_pole_y", "length", "its pole (instant centre), whose path is a centrode"},
    {"LINK_moving_centrode_u, _v", "length", "the pole in the link's own axes"},
    {"LINK_inflection_diameter", "length",
     "of the inflection circle: d in Euler-Savary's relation"},
    {"LINK_inflection_centre_x, _y", "length", "of the circle of points that move straight"},
    {"LINK_return_centre_x, _y", "length", "of the return circle, of the same diameter"},
    {"LINK_tangential_diameter", "length", "of Bresse's circle without tangential acceleration"},
    {"LINK_tangential_centre_x, _y", "length", "its centre"},
    {"LINK_acceleration_pole_x, _y", "length", "the point without acceleration"},
    {"LINK_ball_x, LINK_ball_y", "length", "Ball's point, whose path is straightest"},
    {"LINK_inflection_line_x, _y, _deg", "length, deg",
     "of a link that slides: the line that the circle then is"},
    {"LINK_stationary_m, _n", "length", "1/r = 1/(m sin t) + 1/(n cos t): stationary curvature"},
    {"transmission_deg", "deg", "between the links of an RRR dyad; C_transmission_deg of several"},
    {"pressure_deg", "deg", "of a slider or bar, signed; SLIDER_pressure_deg of several"},
    {"torque_N_m", "N m", "that drives the crank, counter-clockwise"},
    {"drive_force_N", "N", "that drives the slider, along its guide"},
    {"P_on_LINK_Fx_N, P_on_LINK_Fy_N", "N", "force on LINK in the joint P, by the link before it"},
    {"BODY_on_SLIDER_N", "N", "normal force in a slide, to the left of its direction"},
    {"BODY_on_SLIDER_moment_N_m", "N m", "moment in a slide, about the slider's pin"},
    {"shaking_Fx_N, shaking_Fy_N", "N", "force of the mechanism on the frame"},
    {"shaking_moment_N_m", "N m", "moment of these about the origin, driving torque included"}};

}  // namespace

std::span<const Entry> problem_kinds() {
  return kProblemKinds;
}

std::span<const Entry> solve_options() {
  return kSolveOptions;
}

std::string_view meaning(problems::SolverChoice solver) {
  switch (solver) {
    case problems::SolverChoice::automatic:
      return "the one that suits the problem";
    case problems::SolverChoice::gauss_newton:
      return "Gauss-Newton with constraints, made for linkages";
    case problems::SolverChoice::ceres:
      return "Levenberg-Marquardt (Ceres): least squares within bounds only";
    case problems::SolverChoice::slsqp:
      return "sequential quadratic programming (NLopt)";
    case problems::SolverChoice::mma:
      return "method of moving asymptotes (NLopt)";
    case problems::SolverChoice::ccsaq:
      return "conservative separable quadratic models (NLopt)";
    case problems::SolverChoice::cobyla:
      return "linear models without derivatives (NLopt)";
    case problems::SolverChoice::bobyqa:
      return "quadratic models without derivatives (NLopt)";
    case problems::SolverChoice::ags:
      return "global: intervals on a space-filling curve, ten unknowns at most (NLopt)";
    case problems::SolverChoice::isres:
      return "global: evolution strategy with stochastic ranking (NLopt)";
    case problems::SolverChoice::crs:
      return "global: controlled random search (NLopt)";
    case problems::SolverChoice::mlsl:
      return "global: multi-level single linkage of local searches (NLopt)";
    case problems::SolverChoice::direct:
      return "global: dividing rectangles (NLopt)";
    case problems::SolverChoice::ipopt:
      return "interior point (Ipopt)";
  }
  return "";
}

std::span<const Metric> metrics() {
  return kMetrics;
}

std::span<const Metric> facts() {
  return kFacts;
}

std::span<const Metric> analysis_metrics() {
  return kAnalysisMetrics;
}

std::span<const Metric> analysis_columns() {
  return kAnalysisColumns;
}

}  // namespace cognate::app
