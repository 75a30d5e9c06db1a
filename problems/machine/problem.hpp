/// @file What a file about a running machine (`kind = "machine"`) says. Angles are in radians.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/basics/names.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/train/problem.hpp"

namespace cognate::problems {

/// A quantity that a file gives as a number, a table or an expression. `value` may be called from
/// one thread at a time; copies share nothing.
struct MachineFunction {
  std::string text;                              ///< the expression as written; else empty
  std::vector<std::pair<double, double>> table;  ///< as written; else empty
  bool smooth = false;                           ///< of a table: splines, not straight lines
  std::function<double(double phi, double omega, double time)> value;
  std::vector<double> breaks;                              ///< φ at which it may jump or bend
  bool of_phi = false, of_speed = false, of_time = false;  ///< what it depends on
  /// Its derivative by φ; where it depends on φ alone (an inertia always does) or on nothing.
  std::function<double(double phi)> slope{};
};

/// A motor's torque that falls in a straight line from standstill to the speed at which it gives
/// none, and goes on beyond both.
struct MotorLine {
  double stall_torque = 0;
  double no_load_speed = 0;
};

/// `motor.train`: the gears between motor and drive, whose speeds, torques and inputs of its own
/// are not used.
struct MotorTrain {
  GearTrainProblem train;
  std::string file;  ///< as written; empty where the train's tables are those of the machine's file
  /// `motor.input`, `motor.output`, `motor.state`: the member on the motor's shaft, that on the
  /// drive, and of a gearbox the state. Empty: those of the train.
  std::optional<std::string> input{}, output{}, state{};
  bool reversed = false;  ///< the motor is made to turn the other way
};

/// `[motor]`: its torque as a function of its own speed (or an expression in phi, w and t of the
/// drive), through gears onto the drive.
struct Motor {
  MachineFunction torque;             ///< of the motor's speed in place of ω
  std::optional<MotorLine> line{};    ///< as written, where `torque` is one
  double ratio = 1;                   ///< motor speed over drive speed
  double efficiency = 1;              ///< of the gears, in both senses of the power
  double inertia = 0;                 ///< of the rotor, about its own axis
  std::optional<MotorTrain> train{};  ///< instead of ratio and efficiency
};

/// A further load, whose size is a function: force along a direction at a
/// point, or torque.
struct MachineLoad {
  LoadRule rule;          ///< force and torque for a value of 1
  MachineFunction value;  ///< of φ, ω, t
  /// Of the travel of the loaded body (as analysis/mechanism/travel.hpp counts it) and its rate in
  /// time, too: instead of `value.value`, where the expression names s or v. `value.of_phi` is then
  /// true, and with v `value.of_speed`.
  std::function<double(double phi, double omega, double time, double travel, double rate)>
      of_travel{};
};

/// What is requested of the machine.
enum class MachineTask { steady, start, stop };

/// `[run]`
struct MachineRunRequest {
  std::vector<MachineTask> tasks;  ///< at least one
  double start_phi = 0;
  double start_speed = 0;  ///< of a start
  std::optional<double> time_max, turns_max, speed_end;
  int steps = 360;  ///< rows of the table for a period
  double tolerance = 1e-10;
};

/// `kind = "machine"`.
struct MachineProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  /// The mechanism with its masses and loads; its `drive` and `output` are not used. Empty where
  /// the file gives equivalent quantities instead.
  std::optional<AnalysisProblem> mechanism;
  std::vector<MachineLoad> loads;  ///< those that are functions
  /// `[equivalent]`: inertia and torque at the drive, in addition to those of the mechanism.
  std::optional<MachineFunction> inertia, torque;
  std::optional<Motor> motor;
  double flywheel = 0;                ///< inertia at the drive
  std::optional<double> fluctuation;  ///< that the flywheel to be found shall leave
  std::optional<double> brake;        ///< of a stop: torque against the motion, the motor off
  MachineRunRequest run;
};

template <>
struct KindTraits<MachineProblem> {
  static constexpr std::string_view kWord = "machine";
  static MachineProblem read(reading::TableReader& document, const std::filesystem::path& folder);
  static reading::Written written(const MachineProblem& problem);
  static tl::expected<MachineProblem, std::vector<std::string>> checked(
      const MachineProblem& problem);
};

template <>
std::span<const Named<MachineTask>> names<MachineTask>();

}  // namespace cognate::problems
