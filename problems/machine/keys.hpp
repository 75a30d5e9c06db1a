/// @file The keys of a machine's tables.
#pragma once

#include "problems/machine/problem.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/toml/keys.hpp"

namespace cognate::problems::reading {

inline constexpr NumberRule kRunTime{is_positive_quantity, "a time from 1e-30 to 1e30 seconds"};
inline constexpr NumberRule kRunTurns{[](double x) { return x >= 1e-6 && x <= 1e6; },
                                      "a number of turns from 1e-6 to 1e6"};
inline constexpr NumberRule kRunSpeed{[](double x) { return x >= 0 && is_quantity(x); },
                                      "a speed in rad/s, 0 or from 1e-30 to 1e30,"};
inline constexpr NumberRule kRunTolerance{[](double x) { return x >= 1e-13 && x <= 1e-3; },
                                          "a relative tolerance from 1e-13 to 1e-3"};
inline constexpr NumberRule kPositiveTorque{is_positive_quantity, "a torque from 1e-30 to 1e30"};
inline constexpr NumberRule kUnevenness{[](double x) { return x >= 1e-6 && x <= 1; },
                                        "(greatest - least speed)/mean from 1e-6 to 1"};
inline constexpr NumberRule kMotorNumber{is_positive_quantity, "a number from 1e-30 to 1e30"};
inline constexpr NumberRule kMotorRatio{[](double x) { return x >= 1e-6 && x <= 1e6; },
                                        "motor speed over drive speed, from 1e-6 to 1e6,"};
inline constexpr NumberRule kMotorEfficiency{[](double x) { return x >= 1e-6 && x <= 1; },
                                             "a fraction above 0, up to 1,"};

/// `[run]`.
inline constexpr Key<MachineRunRequest> kRunKeys[] = {
    own_key<MachineRunRequest>("tasks",
                               "which of \"steady\", \"start\", \"stop\" (default [\"steady\"])"),
    key<&MachineRunRequest::start_phi>(
        "start_deg", "the drive's angle where a start begins (default 0)", kAngle),
    speed_key<&MachineRunRequest::start_speed>(
        "start_speed", "rad/s, of the drive where it begins (default 0); or start_speed_rpm",
        kRunSpeed),
    key<&MachineRunRequest::time_max>(
        "time_max", "s, after which a start or a stop ends; until then a machine at rest waits",
        kRunTime),
    key<&MachineRunRequest::turns_max>(
        "turns_max", "of the drive, after which a start or a stop ends", kRunTurns),
    speed_key<&MachineRunRequest::speed_end>(
        "speed_end", "rad/s, at which it ends; or speed_end_rpm", kRunSpeed),
    key<&MachineRunRequest::steps>(
        "steps",
        "rows of the table for a turn of the steady motion, or for a whole start or stop, 12 to "
        "100000 "
        "(default 360)",
        IntegerRule{12, 100'000}),
    key<&MachineRunRequest::tolerance>(
        "tolerance", "relative, of the integration, 1e-13 to 1e-3 (default 1e-10)", kRunTolerance)};

/// `[motor]`.
inline constexpr Key<Motor> kMotorKeys[] = {
    own_key<Motor>("torque",
                   "N m: a number, or an expression in its speed w, the drive's phi, and t"),
    own_key<Motor>("line",
                   "or: {stall_torque, no_load_speed (or no_load_speed_rpm)}, straight between and "
                   "beyond them"),
    own_key<Motor>("table", "or: [[speed, torque], ...], constant beyond its ends"),
    own_key<Motor>("interpolation", "of the table: \"linear\" (default) or \"smooth\""),
    key<&Motor::ratio>("ratio", "motor speed over drive speed (default 1)", kMotorRatio),
    key<&Motor::efficiency>("efficiency",
                            "of the gears between them, whichever way the power flows (default 1)",
                            kMotorEfficiency),
    key<&Motor::inertia>("inertia", "kg m2, of the rotor about its own axis (default 0)", kMass),
    own_key<Motor>("train",
                   "instead of ratio and efficiency: \"FILE.toml\" of kind = \"gear-train\", or "
                   "[motor.train] with the tables of one")};

/// `[motor]` with a train.
inline constexpr Key<MotorTrain> kMotorTrainKeys[] = {
    key<&MotorTrain::input>(
        "input", "of the train: its member on the motor's shaft (default: its [[input]])"),
    key<&MotorTrain::output>("output",
                             "of the train: its member on the drive (default: its [output])"),
    key<&MotorTrain::state>("state", "of a gearbox as the train: the name of its [[state]]"),
    key<&MotorTrain::reversed>("reversed",
                               "whether the motor turns the other way, as for a train of negative "
                               "ratio (default false)")};

/// `motor.line`, both of which it needs.
inline constexpr Key<MotorLine> kLineKeys[] = {
    key<&MotorLine::stall_torque>("stall_torque", "the torque at standstill", kMotorNumber),
    speed_key<&MotorLine::no_load_speed>("no_load_speed", "the speed at which it gives no torque",
                                         kMotorNumber)};

/// `[flywheel]`.
inline constexpr Key<MachineProblem> kFlywheelKeys[] = {
    key<&MachineProblem::flywheel>("inertia", "kg m2 at the drive", kMass),
    key<&MachineProblem::fluctuation>(
        "fluctuation",
        "or: (maximum - minimum)/mean speed that the flywheel to be found shall leave",
        kUnevenness)};

/// `[brake]`.
inline constexpr Key<MachineProblem> kBrakeKeys[] = {key<&MachineProblem::brake>(
    "torque", "N m at the drive, against the motion, the motor off", kPositiveTorque)};

/// `[equivalent]`.
inline constexpr Key<MachineProblem> kEquivalentKeys[] = {
    own_key<MachineProblem>(
        "inertia", "kg m2 at the drive: a number, an expression in phi, or [[deg, inertia], ...]"),
    own_key<MachineProblem>(
        "torque",
        "N m at the drive: a number, an expression in phi, w and t, or [[deg, torque], ...]"),
    own_key<MachineProblem>("interpolation",
                            "of these tables: \"linear\" (default) or \"smooth\"")};

/// `[[load]]`, in addition to the keys of an analysis.
inline constexpr Key<MachineLoad> kMachineLoadKeys[] = {
    own_key<MachineLoad>("value",
                         "what force and torque are multiplied by: an expression in phi, w, t, s, "
                         "v (s: travel of the "
                         "body, along its slide, or rad from the end of its swing, or its angle "
                         "where it turns fully; "
                         "v: "
                         "its rate), or [[crank_deg, value], ...]"),
    own_key<MachineLoad>("interpolation", "of such a table: \"linear\" (default) or \"smooth\"")};

}  // namespace cognate::problems::reading
