#include "app/documents/problem_catalogue.hpp"

namespace cognate::app {
namespace {

constexpr Entry kBounds[] = {
    {"length", "[min, max] of every link; crank, coupler, rocker, frame: of one"},
    {"pivot_a, pivot_d", "[[xmin, ymin], [xmax, ymax]]"},
    {"coupler_point", "[[umin, vmin], [umax, vmax]]"},
    {"frame_angle_deg, input_start_deg, output_start_deg, output_start", "[min, max]"}};

constexpr Entry kDesignConstraints[] = {
    {"class",
     "\"crank-rocker\", \"double-crank\", \"rocker-crank\", \"double-rocker\", \"triple-rocker\", "
     "\"grashof\" or \"non-grashof\""},
    {"transmission_angle_deg", "[min, max] over the motion"},
    {"link_ratio_max", "longest over shortest link"},
    {"time_ratio", "[min, max] of K; with class = \"crank-rocker\""},
    {"rms_error_max", "paths and motions: the most root mean square of the distances"},
    {"rms_error_deg_max", "functions by least squares: likewise of the angles"},
    {"max_error_deg_max", "functions by minimax: the maximum error allowed"},
    {"pivot_region", "[[xmin, ymin], [xmax, ymax]] of the fixed pivots"},
    {"clearance",
     "[[constraints.clearance]], over the full turn: point = \"coupler-point\", \"B\" or \"C\", "
     "inside or outside = [[xmin, "
     "ymin], [xmax, ymax]]"}};

constexpr Entry kMotionConstraints[] = {
    {"no_branch_defect, no_order_defect, no_circuit_defect", "true (default) or false"},
    {"no_extra_loop",
     "true (default) or false: the whole coupler curve keeps to a closed target curve"}};

constexpr auto kConstraints = with_cycle_quantities(
    kDesignConstraints,
    [](const problems::CycleDeclaration& of) {
      return Entry{of.limit_key, of.limit_meaning};
    },
    kMotionConstraints);

constexpr Entry kDrive[] = {
    {"speed",
     "of the crank, rad/s: constant (default 1), or the mean of a speed that may fluctuate; or "
     "speed_rpm, in turns a minute"}};

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

std::span<const KeyedEntry> common_tables() {
  return kCommon;
}

}  // namespace cognate::app
