/// @file The quantities over a full turn of the crank that a file can limit or make least. Each is
/// declared here, measured on a finished design in cycle_metrics.cpp and limited in the search in
/// cycle_limits.cpp; everything else (reader, echo, checks, objectives, tables, `cognate list`)
/// runs over the declarations.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "problems/mechanism/quantity_rules.hpp"

namespace cognate::problems {

/// In the order of `kCycleQuantities`.
enum class CycleQuantity {
  peak_speed,
  peak_acceleration,
  torque_ripple,
  peak_torque,
  rms_torque,
  speed_fluctuation,
  flywheel_inertia,
  motor_power
};

/// How much of the motion is evaluated to know a quantity.
enum class MotionLevel { positions, velocities, accelerations, forces };

/// What is said once of a quantity over the cycle.
struct CycleDeclaration {
  CycleQuantity id;
  std::string_view limit_key;      ///< of `[constraints]`: the quantity's own key and "_max"
  std::string_view words;          ///< in a sentence: "the peak acceleration"
  std::string_view heading;        ///< of a column of designs, without the unit
  std::string_view unit;           ///< "length/s2 or rad/s2": of a point, or of a rocker; "1": none
  std::string_view meaning;        ///< of the metric
  std::string_view limit_meaning;  ///< of the limit
  MotionLevel level;
  /// The power of the lengths' unit in it, where masses and times keep theirs.
  int length_power = 0;
  bool by_forces = false;       ///< depends on masses and loads
  bool needs_speed = false;     ///< `drive.speed` must be given
  bool by_flywheel = false;     ///< depends on `flywheel.inertia`
  bool by_fluctuation = false;  ///< needs `flywheel.fluctuation`
  reading::NumberRule limit_rule{reading::is_positive_quantity, "a number from 1e-30 to 1e30"};

  /// Of the metric and of the objective: "peak_acceleration".
  constexpr std::string_view key() const {
    return limit_key.substr(0, limit_key.size() - std::string_view("_max").size());
  }
  /// The unit for a rocker's angle (`angular`) or for lengths; empty for pure numbers.
  constexpr std::string_view unit_of(bool angular) const {
    constexpr std::string_view kOr = " or ";
    const auto at = unit.find(kOr);
    if (at == std::string_view::npos) return unit == "1" ? std::string_view{} : unit;
    return angular ? unit.substr(at + kOr.size()) : unit.substr(0, at);
  }
  /// Whether its unit is N m, W, …, so that lengths are in metres.
  constexpr bool is_in_metres() const { return length_power == 2; }
};

inline constexpr std::array kCycleQuantities{
    CycleDeclaration{
        .id = CycleQuantity::peak_speed,
        .limit_key = "peak_speed_max",
        .words = "the peak speed",
        .heading = "peak speed",
        .unit = "length/s or rad/s",
        .meaning = "maximum over the turn, of the coupler point or of a function's rocker, where "
                   "requested",
        .limit_meaning =
            "over the full turn, at [drive] speed: of the coupler point, or of a function's rocker",
        .level = MotionLevel::velocities,
        .length_power = 1},
    CycleDeclaration{
        .id = CycleQuantity::peak_acceleration,
        .limit_key = "peak_acceleration_max",
        .words = "the peak acceleration",
        .heading = "peak acceleration",
        .unit = "length/s2 or rad/s2",
        .meaning = "maximum over the turn, of the coupler point or of a function's rocker, where "
                   "requested",
        .limit_meaning =
            "over the full turn, at [drive] speed: of the coupler point, or of a function's rocker",
        .level = MotionLevel::accelerations,
        .length_power = 1},
    CycleDeclaration{.id = CycleQuantity::torque_ripple,
                     .limit_key = "torque_ripple_max",
                     .words = "the ripple of the driving torque",
                     .heading = "torque ripple",
                     .unit = "N m",
                     .meaning = "maximum minus minimum driving torque, where requested",
                     .limit_meaning = "maximum minus minimum driving torque over the full turn, "
                                      "with [[link]], [[load]], gravity",
                     .level = MotionLevel::forces,
                     .length_power = 2,
                     .by_forces = true},
    CycleDeclaration{.id = CycleQuantity::peak_torque,
                     .limit_key = "peak_torque_max",
                     .words = "the greatest driving torque",
                     .heading = "peak torque",
                     .unit = "N m",
                     .meaning = "maximum magnitude of the driving torque, where requested",
                     .limit_meaning = "maximum magnitude of the driving torque over the full turn, "
                                      "with [[link]], [[load]], gravity",
                     .level = MotionLevel::forces,
                     .length_power = 2,
                     .by_forces = true},
    CycleDeclaration{.id = CycleQuantity::rms_torque,
                     .limit_key = "rms_torque_max",
                     .words = "the root mean square of the driving torque",
                     .heading = "rms torque",
                     .unit = "N m",
                     .meaning = "root mean square of the driving torque over the turn, where "
                                "requested",
                     .limit_meaning = "root mean square of the driving torque over the full turn, "
                                      "with [[link]], [[load]], gravity",
                     .level = MotionLevel::forces,
                     .length_power = 2,
                     .by_forces = true},
    CycleDeclaration{.id = CycleQuantity::speed_fluctuation,
                     .limit_key = "speed_fluctuation_max",
                     .words = "the coefficient of speed fluctuation",
                     .heading = "speed fluctuation",
                     .unit = "1",
                     .meaning = "(maximum - minimum)/mean speed, where requested; from 2 on the "
                                "machine does not come round",
                     .limit_meaning =
                         "(greatest - least)/mean crank speed of the steady motion, below 2, with "
                         "[drive] speed, [[link]], [[load]], gravity, [flywheel] inertia",
                     .level = MotionLevel::velocities,
                     .by_forces = true,
                     .needs_speed = true,
                     .by_flywheel = true,
                     .limit_rule = reading::kSpeedFluctuation},
    CycleDeclaration{
        .id = CycleQuantity::flywheel_inertia,
        .limit_key = "flywheel_inertia_max",
        .words = "the inertia of the flywheel",
        .heading = "flywheel",
        .unit = "kg m2",
        .meaning = "minimum flywheel for a given fluctuation, where requested",
        .limit_meaning =
            "the minimum flywheel on the crank for [flywheel] fluctuation, with [drive] speed, ...",
        .level = MotionLevel::velocities,
        .length_power = 2,
        .by_forces = true,
        .needs_speed = true,
        .by_fluctuation = true},
    CycleDeclaration{
        .id = CycleQuantity::motor_power,
        .limit_key = "motor_power_max",
        .words = "the greatest power of the drive",
        .heading = "motor power",
        .unit = "W",
        .meaning = "maximum power of the drive over the turn, where requested",
        .limit_meaning =
            "maximum power of the drive at [drive] speed, with [[link]], [[load]], ...",
        .level = MotionLevel::forces,
        .length_power = 2,
        .by_forces = true,
        .needs_speed = true}};

constexpr std::size_t index_of(CycleQuantity quantity) {
  return static_cast<std::size_t>(quantity);
}

static_assert([] {
  for (std::size_t i = 0; i < kCycleQuantities.size(); ++i) {
    if (index_of(kCycleQuantities.at(i).id) != i) return false;
  }
  return true;
}());

/// A number for each quantity, or none.
struct CycleValues {
  std::array<std::optional<double>, kCycleQuantities.size()> values;

  constexpr std::optional<double>& operator[](CycleQuantity quantity) {
    return values.at(index_of(quantity));
  }
  constexpr const std::optional<double>& operator[](CycleQuantity quantity) const {
    return values.at(index_of(quantity));
  }

  /// Whether a quantity of which `has` holds has a number.
  template <class Has>
  bool any(const Has& has) const {
    for (const CycleDeclaration& quantity : kCycleQuantities) {
      if ((*this)[quantity.id] && has(quantity)) return true;
    }
    return false;
  }
  bool any(bool CycleDeclaration::*has) const {
    return any([has](const CycleDeclaration& quantity) { return quantity.*has; });
  }
  bool any() const {
    return any([](const CycleDeclaration&) { return true; });
  }
};

/// "a, b or c": what `part` gives of each quantity with `has`, of all without it.
std::string list_of(std::string (*part)(const CycleDeclaration&), std::string_view last = " or ",
                    bool CycleDeclaration::*has = nullptr);

/// "constraints.torque_ripple_max, speed_fluctuation_max or motor_power_max": the limits of the
/// quantities with `has`, or of all.
std::string limit_keys(bool CycleDeclaration::*has = nullptr);

}  // namespace cognate::problems
