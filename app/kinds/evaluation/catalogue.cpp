#include "app/documents/mechanism_catalogue.hpp"
#include "app/kinds/evaluation/kind.hpp"

namespace cognate::app {
namespace {

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
    {"transmission_angle_deg.min", "deg", "minimum transmission angle of all dyads in all ranges"},
    {"transmission_angle_deg.max", "deg", "maximum transmission angle of all dyads in all ranges"},
    {"transmission_angle_deg.acute_min", "deg", "minimum of the angle and its supplement"},
    {"pressure_angle_max_deg", "deg",
     "maximum pressure angle of sliders and bars in all ranges, unsigned"},
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
    {"curve_width_min", "length", "minimum distance of parallel lines that hold it (curve)"},
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
    {"straight_length_at_0_001", "length", "longest segment with deviation/length 0.1 % (curve)"},
    {"straight_length_at_0_01", "length", "the same with 1 % (curve)"},
    {"straight_length_over_longest_link", "1", "straight length at 0.1 % over that (curve)"},
    {"cusps", "1", "of the coupler curve on its circuit (curve)"},
    {"double_points", "1", "where that crosses itself (curve)"},
    {"inflections", "1", "of it (curve)"},
    {"torque_N_m.min", "N m", "minimum driving torque, with the crank angle as min_at_deg"},
    {"torque_N_m.max", "N m", "maximum driving torque, with the crank angle as max_at_deg"},
    {"torque_N_m.abs_max", "N m",
     "maximum of either sign, which sizes the motor, with the crank angle as abs_max_at_deg"},
    {"torque_N_m.rms", "N m", "root mean square of the driving torque over the crank's angle"},
    {"drive_force_N.min", "N", "minimum driving force, with the displacement as min_at"},
    {"drive_force_N.max", "N", "maximum driving force, with the displacement as max_at"},
    {"drive_force_N.abs_max", "N", "maximum of either sign, with the displacement as abs_max_at"},
    {"drive_force_N.rms", "N", "root mean square of the driving force over the displacement"},
    {"torque_N_m.max_unbounded_at_deg", "deg",
     "instead of max: the dead point near which it grows without bound; min, abs_max and "
     "drive_force_N alike"},
    {"reaction_max_N.P_on_LINK", "N", "maximum force at the joint P on LINK"},
    {"reaction_max_at_deg.P_on_LINK", "deg",
     "the crank angle there; reaction_max_at: displacement"},
    {"reaction_max_unbounded_at_deg.P_on_LINK", "deg",
     "instead of both: the dead or change point near which it grows without bound"},
    {"layers.count", "1", "fewest layers above the frame in which links pass each other (layers)"},
    {"layers.pin_crossings", "1", "layers that pins cross without holding a link there (layers)"},
    {"closure_residual", "1", "maximum gap at a joint over the size of the mechanism"},
    {"power_residual", "1", "torque of the reactions less that of virtual work, over its maximum"},
    {"defects", "", "always empty for an analysis"}};

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

std::vector<ListSection> Kind<problems::AnalysisProblem>::sections() {
  return {
      list_section("mechanisms",
                   "mechanisms to be analysed (mechanism.type = ...) and their keys in [mechanism]",
                   mechanisms()),
      list_section("dyads",
                   "dyads of a chain (dyad.type = ...; names = [\"...\", \"...\"] of the bodies)",
                   dyads()),
      list_section("analysis_tables", "tables of an analysis", analysis_tables())};
}

std::vector<MetricList> Kind<problems::AnalysisProblem>::metric_lists() {
  return {{"analysis_metrics", "metric of an analysis", kAnalysisMetrics},
          {"analysis_columns", "column of an analysis", kAnalysisColumns, false}};
}

}  // namespace cognate::app
