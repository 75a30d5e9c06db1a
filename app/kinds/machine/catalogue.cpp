#include "app/kinds/machine/kind.hpp"
#include "problems/machine/keys.hpp"

namespace cognate::app {
namespace {

namespace keys = problems::reading;

constexpr auto kLoad = entries_of(keys::kMachineLoadKeys);
constexpr auto kEquivalent = entries_of(keys::kEquivalentKeys);
constexpr auto kMotor = entries_of(keys::kMotorKeys, keys::kMotorTrainKeys);
constexpr auto kFlywheel = entries_of(keys::kFlywheelKeys);
constexpr auto kBrake = entries_of(keys::kBrakeKeys);
constexpr auto kRun = entries_of(keys::kRunKeys);

constexpr KeyedEntry kMachineTables[] = {
    {"[[load]]", "as of an analysis, and also", kLoad},
    {"[equivalent]", "at the drive, instead of a [mechanism] or added to it", kEquivalent},
    {"[motor]", "what drives the machine", kMotor},
    {"[flywheel]", "on the drive", kFlywheel},
    {"[brake]", "of a stop", kBrake},
    {"[run]", "which motions are computed", kRun}};

constexpr Metric kMetrics[] = {
    {"speed_mean_rad_s", "rad/s", "of the steady motion: half the sum of maximum and minimum"},
    {"speed_max_rad_s", "rad/s", "maximum speed of the drive"},
    {"speed_max_at_deg", "deg", "the drive's angle there, of its period; none of an even speed"},
    {"speed_min_rad_s", "rad/s", "minimum speed of the drive"},
    {"speed_min_at_deg", "deg", "the drive's angle there, of its period; none of an even speed"},
    {"fluctuation", "1", "coefficient of speed fluctuation: (maximum - minimum)/mean"},
    {"fluctuation_without_flywheel", "1", "where a flywheel is to be found: without it"},
    {"flywheel_inertia_kg_m2", "kg m2", "with which the fluctuation is the desired one, exactly"},
    {"flywheel_inertia_approximate_kg_m2", "kg m2",
     "by the textbooks' formula, for comparison: excess work over mean speed squared and "
     "fluctuation, less the equivalent inertia"},
    {"greatest_excess_work_J", "J", "on which that formula stands, of the motion without flywheel"},
    {"period_s", "s", "of the steady motion"},
    {"energy_swing_J", "J", "maximum less minimum kinetic energy in a period"},
    {"multiplier", "1",
     "Floquet multiplier: what is left of a small deviation after a period; stable below 1"},
    {"energy_residual", "1",
     "balance of the works in a period, relative, by a second integration of other equations"},
    {"motor_work_J", "J", "of the motor in a period"},
    {"motor_power_mean_W", "W", "of the motor over a period"},
    {"motor_power_max_W", "W", "its maximum"},
    {"train_ratio", "1", "of motor.train: speed of the motor's shaft over that of the drive"},
    {"train_ratio_exact", "", "the same as a fraction, without rounding"},
    {"train_efficiency", "1", "of power from the motor to the drive"},
    {"train_reverse_efficiency", "1",
     "of power from the drive to the motor; none of a self-locking train"},
    {"train_self_locking", "boolean", "whether a load cannot drive the motor back"},
    {"train_inertia_kg_m2", "kg m2", "of shafts and planets of the train, equivalent at the drive"},
    {"start_time_s", "s",
     "of the start: until speed_end is reached, else until the speed is within 1 % of the steady "
     "one "
     "at the same angle"},
    {"start_turns", "1", "turns of the drive meanwhile"},
    {"start_end_speed_rad_s", "rad/s", "speed at its end"},
    {"stop_time_s", "s", "of the stop"},
    {"stop_turns", "1", "turns of the drive meanwhile"},
    {"stop_end_speed_rad_s", "rad/s", "speed at its end"}};

constexpr Metric kColumns[] = {
    {"task", "", "in the CSV, before the others: which motion the row is of"},
    {"time_s", "s", "since the motion began"},
    {"crank_deg", "deg", "the drive's angle, going on from turn to turn"},
    {"speed_rad_s", "rad/s", "of the drive"},
    {"acceleration_rad_s2", "rad/s2", "of the drive"},
    {"inertia_kg_m2", "kg m2", "equivalent at the drive, flywheel and rotor included"},
    {"inertia_slope_kg_m2", "kg m2", "its derivative by the drive's angle in radians"},
    {"motor_N_m", "N m", "torque of the motor at the drive"},
    {"load_N_m", "N m", "equivalent torque of loads and weights; against the motion negative"},
    {"motor_power_W", "W", "of the motor"},
    {"load_power_W", "W", "of loads and weights"},
    {"motor_work_J", "J", "of the motor since the motion began"},
    {"load_work_J", "J", "of loads and weights since then"},
    {"kinetic_energy_J", "J", "of all that moves"},
    {"excess_work_J", "J", "of all torques since the motion began"}};

}  // namespace

std::vector<ListSection> Kind<problems::MachineProblem>::sections() {
  return {list_section("machine_tables", "tables of a machine", kMachineTables)};
}

std::vector<MetricList> Kind<problems::MachineProblem>::metric_lists() {
  return {{"machine_metrics", "metric of a machine", kMetrics},
          {"machine_columns", "column of a machine", kColumns, false}};
}

}  // namespace cognate::app
