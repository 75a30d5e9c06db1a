#include "app/documents/problem_catalogue.hpp"

namespace cognate::app {
namespace {

constexpr Entry kFunction[] = {
    {"target.function", "an expression in x, as \"log10(x)\""},
    {"target.domain", "[x0, x1] of the function"},
    {"target.table",
     "or: [[x, y], ...]; between the rows a cubic that rises and falls only where the rows do"},
    {"target.pairs_deg", "or: [[input, output], ...]"},
    {"target.pairs", "of a slider-crank: [[input_deg, displacement], ...]"},
    {"target.input_range_deg", "the input's sweep for the domain"},
    {"target.output_range_deg", "the output's sweep for the values (negative: the other sense)"},
    {"target.output_range", "of a slider-crank: the slider's travel"},
    {"target.relation", "\"angles\": x and y are the angles themselves, in radians"},
    {"target.precision_points", "3, 4 or 5: exact synthesis"},
    {"target.at", "the precision points' x (default: by spacing)"},
    {"target.multiplicity", "how often each of at counts: 2 takes the first derivative too, ..."},
    {"target.derivatives", "of pairs: [[first, second, ...], ...] to be met at each"},
    {"target.spacing", "\"chebyshev\" (default), or \"equal-peaks\": a minimax generator"},
    {"target.objective", "\"least-squares\" (default), \"minimax\" or \"exact\""},
    {"target.method", "\"exact\": exact synthesis, of pairs"},
    {"target.samples", "how many samples the error is taken at (default 61)"},
    {"target.sample_at", "or: their x"},
    {"mechanism.type", "\"four-bar\" (default) or, exactly, \"slider-crank\""},
    {"mechanism.crank", "its length (default 1); coupler, rocker, frame: likewise, or free"},
    {"mechanism.input_start_deg", "input angle at the start, from A to D; free by default"},
    {"mechanism.output_start_deg", "output angle at the start; free by default"},
    {"mechanism.output_start", "of a slider-crank: displacement at the start"},
    {"mechanism.start",
     "\"free\" (default), \"outer-dead-centre\" or \"inner-dead-centre\" of the output"},
    {"solve.best_by", "order of exact designs: \"transmission\" or \"error\""}};

constexpr Entry kMotion[] = {
    {"target.poses", "[[x, y, angle_deg], ...], 2 to 10000 of them"},
    {"target.segments", "or: [[[x1, y1], [x2, y2]], ...], two points of the body in each pose"},
    {"target.method", "\"exact\" (default of 2 to 5 poses) or \"least-squares\" (3 and more)"},
    {"target.angle_weight",
     "least squares: length that counts as much as one radian (default: the rms way of the poses)"},
    {"mechanism.dyads", "which kinds may guide the body: \"RR\", \"PR\" (slider), \"RP\" (block)"},
    {"mechanism.fixed_pivots", "2 or 3 poses, or least squares: one or two of them [x, y]"},
    {"mechanism.moving_pivots",
     "2 or 3 poses, or least squares: one or two of them [u, v] in the body"},
    {"mechanism.fixed_pivot_line", "2 poses: [a, b, c], a x + b y = c, for the fixed pivots"},
    {"mechanism.crank", "2 poses, or least squares: length of the first dyad's link"},
    {"mechanism.rocker", "2 poses, or least squares: length of the second's"},
    {"bounds.moving_pivot_a",
     "least squares: [[umin, vmin], [umax, vmax]] in the body; moving_pivot_d: likewise"}};

constexpr Entry kPath[] = {
    {"target.points", "[[x, y], ...]; 3 to 10000, or 2 to 9 for exact synthesis"},
    {"target.curve",
     "or: [[x, y], ...], a closed polyline, which a full turn of the crank follows"},
    {"target.svg_path",
     "or: a closed curve as SVG path data, \"M 0 0 C ...\", its y turned upwards"},
    {"target.svg", "or: an SVG file beside this one, its only path, in user units, untransformed"},
    {"target.svg_id", "of several paths the one of this id"},
    {"target.samples",
     "of a closed curve: points in equal steps along it (12 to 1000, default 80)"},
    {"target.place",
     "of a closed curve: \"given\" (default), or \"similar\": moved, turned, enlarged, not "
     "mirrored"},
    {"target.poses", "exact: [[x, y, angle_deg], ...] among the positions"},
    {"target.method", "\"least-squares\" (default) or \"exact\": every four-bar through them"},
    {"target.weights", "of the points (default 1)"},
    {"target.timing", "\"free\" (default), \"prescribed\" by crank_deg, or \"mixed\""},
    {"target.crank_deg", "the crank's angle at each point; mixed: or \"free\""},
    {"target.crank_reference",
     "of crank_deg: \"first\" (default; of the first timed point), \"frame\" or \"global\""},
    {"target.crank_sense", "\"either\" (default), \"ccw\" or \"cw\""},
    {"target.order", "\"cyclic\" (default) or \"any\""},
    {"mechanism.crank", "its length; coupler, rocker, frame: likewise, all free by default"},
    {"mechanism.pivot_a", "[x, y] of the crank's pivot, pivot_d: of the rocker's"},
    {"mechanism.fixed_pivots", "or: both"},
    {"mechanism.frame_angle_deg", "direction from A to D"},
    {"mechanism.coupler_point", "[u, v]: origin B, first axis from B to C"},
    {"mechanism.assembly", "\"open\" or \"crossed\"; both by default"}};

constexpr Entry kQuickReturn[] = {
    {"target.time_ratio", "time of the advance over that of the return, from 1"},
    {"mechanism.type", "\"four-bar\" (default), \"slider-crank\", \"guide-bar\" or \"shaper\""},
    {"mechanism.rocker", "four-bar: its length"},
    {"mechanism.swing_deg", "four-bar: of the rocker"},
    {"mechanism.crank",
     "its length: at most one of crank, coupler, frame, crank_pivot_line; none: best transmission"},
    {"mechanism.coupler", "likewise"},
    {"mechanism.frame", "likewise; guide-bar and shaper: between the pivots"},
    {"mechanism.crank_pivot_line", "likewise: [a, b, c], a x + b y = c"},
    {"mechanism.stroke", "slider-crank and shaper: of the slider"},
    {"mechanism.offset", "slider-crank: of the slide line; guide-bar: of the guide"},
    {"mechanism.rod", "shaper: from the guide to the ram"},
    {"mechanism.ram_height", "shaper: of the ram's line above the guide's pivot"},
    {"constraints.pressure_angle_deg_max", "slider-crank and shaper"}};

constexpr Entry kStraightLine[] = {
    {"target.length",
     "of the straight stretch: deviation is minimised; with neither a Pareto front is searched"},
    {"target.deviation",
     "greatest distance from the line: length is maximised; both: size minimised"},
    {"target.deviation_relative", "or: that over the length"},
    {"target.direction_deg", "of the line, either way along it"},
    {"target.constant_velocity", "true: constraints.speed_variation_max = 0.1 unless given"},
    {"target.method", "\"exact\": by the theory of contact; by default linkages are searched"},
    {"target.contact", "exact: 3, 4 or 5 coinciding points of path and line (default 5)"},
    {"mechanism.type", "\"four-bar\" (default) or \"slider-crank\""},
    {"mechanism.crank", "its length; coupler, rocker, frame: likewise; contact 5 may find one"},
    {"mechanism.crank_deg", "the position; contact 5 may find it"},
    {"mechanism.cranks", "\"any\" (default), \"parallel\" or \"symmetric\""},
    {"mechanism.sides", "of parallel cranks: \"same\" or \"opposite\""},
    {"mechanism.coupler_angle_deg", "of parallel cranks: direction of the coupler"},
    {"mechanism.pivot_a", "[x, y] of the crank's pivot, pivot_d: of the rocker's"},
    {"mechanism.fixed_pivots", "or: both"},
    {"mechanism.frame_angle_deg", "direction from A to D"},
    {"mechanism.assembly", "\"open\" or \"crossed\"; both by default"},
    {"mechanism.pivot", "slider-crank: [x, y] of the crank's pivot"},
    {"mechanism.offset", "slider-crank: of the slide line (exact: default 0)"},
    {"mechanism.direction_deg", "slider-crank: of the slide line (default 0)"},
    {"constraints.crank_range_deg", "search: [min, max] of the crank's turn over the stretch"},
    {"constraints.size_over_length_max",
     "search: largest dimension of a link, coupler point included, over the length (default 2)"},
    {"constraints.speed_variation_max", "search: (max - min)/mean of the speed along the line"},
    {"constraints.link_ratio_max", "search: 10 by default"}};

constexpr KeyedEntry kSynthesis[] = {
    {"function-generation", "designs by Freudenstein's equation and by least squares", kFunction},
    {"motion-generation", "designs by Burmester's theory and by least squares", kMotion},
    {"path-generation", "designs by homotopy and by least squares", kPath},
    {"quick-return", "designs from the time ratio", kQuickReturn},
    {"straight-line", "designs by minimax search and from the curvature of coupler curves",
     kStraightLine}};

constexpr Entry kBounds[] = {
    {"length", "[min, max] of every link; crank, coupler, rocker, frame: of one"},
    {"pivot_a, pivot_d", "[[xmin, ymin], [xmax, ymax]]"},
    {"coupler_point", "[[umin, vmin], [umax, vmax]]"},
    {"frame_angle_deg, input_start_deg, output_start_deg, output_start", "[min, max]"}};

constexpr Entry kConstraints[] = {
    {"class",
     "\"crank-rocker\", \"double-crank\", \"rocker-crank\", \"double-rocker\", \"triple-rocker\", "
     "\"grashof\" or \"non-grashof\""},
    {"transmission_angle_deg", "[min, max] over the motion"},
    {"link_ratio_max", "longest over shortest link"},
    {"time_ratio", "[min, max] of K; with class = \"crank-rocker\""},
    {"rms_error_max", "paths and motions: the most root mean square of the distances"},
    {"rms_error_deg_max", "functions by least squares: likewise of the angles"},
    {"max_error_deg_max", "functions by minimax: the largest error allowed"},
    {"pivot_region", "[[xmin, ymin], [xmax, ymax]] of the fixed pivots"},
    {"clearance",
     "[[constraints.clearance]], over the full turn: point = \"coupler-point\", \"B\" or \"C\", "
     "inside or outside = [[xmin, "
     "ymin], [xmax, ymax]]"},
    {"peak_acceleration_max",
     "over the full turn, at [drive] speed: of the coupler point, or of a function's rocker"},
    {"torque_ripple_max",
     "greatest less least driving torque over the full turn, with [[link]], [[load]], gravity"},
    {"speed_fluctuation_max",
     "(greatest - least)/mean crank speed of the steady motion, below 2, with [drive] speed, "
     "[[link]], [[load]], gravity, [flywheel] inertia"},
    {"flywheel_inertia_max",
     "the least flywheel on the crank for [flywheel] fluctuation, with [drive] speed, ..."},
    {"motor_power_max",
     "greatest power of the drive at [drive] speed, with [[link]], [[load]], ..."},
    {"no_branch_defect, no_order_defect, no_circuit_defect", "true (default) or false"},
    {"no_extra_loop",
     "true (default) or false: the whole coupler curve keeps to a closed target curve"}};

constexpr Entry kDrive[] = {
    {"speed",
     "of the crank, rad/s: constant (default 1), or the mean of a speed that may fluctuate"}};

constexpr Entry kFlywheel[] = {{"inertia", "on the crank, for speed_fluctuation_max (default 0)"},
                               {"fluctuation", "that it is to leave, for flywheel_inertia_max"}};

constexpr Entry kLink[] = {
    {"name, between",
     "\"crank\", \"coupler\" or \"rocker\"; or two of its joints, as [\"B\", \"C\"]"},
    {"mass_per_length", "of a slender rod as long as the link"},
    {"mass, centre, inertia", "or: given once and for all, [u, v] in the link's axes"}};

constexpr Entry kLoad[] = {
    {"on, at", "\"coupler-point\", \"B\", \"C\", or a link and [u, v] in its axes"},
    {"force, torque", "[fx, fy] and a torque"},
    {"when",
     "\"always\" (default); on the rocker of a crank-rocker \"advance\" (while it turns "
     "counter-clockwise) or \"return\""}};

constexpr KeyedEntry kCommon[] = {
    {"[bounds]", "of what is sought", kBounds},
    {"[constraints]", "on the designs", kConstraints},
    {"[drive]", "for peak accelerations, torques, speeds and powers over the turn", kDrive},
    {"[flywheel]", "for speed_fluctuation_max and flywheel_inertia_max", kFlywheel},
    {"[[link]]", "for torques, speeds and powers over the turn, as is gravity = [x, y]", kLink},
    {"[[load]]", "likewise", kLoad}};

}  // namespace

std::span<const KeyedEntry> synthesis_problems() {
  return kSynthesis;
}

std::span<const KeyedEntry> common_tables() {
  return kCommon;
}

}  // namespace cognate::app
