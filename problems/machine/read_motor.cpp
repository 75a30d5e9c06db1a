#include "problems/machine/read_motor.hpp"

#include <fmt/core.h>

#include <utility>
#include <vector>

#include "problems/machine/keys.hpp"
#include "problems/machine/read_function.hpp"
#include "problems/toml/interpolation.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kTorqueKey = "torque";
constexpr std::string_view kLine = "line";
constexpr std::string_view kTable = "table";

bool has_exactly_one(TableReader& motor) {
  std::string_view first;
  for (const std::string_view key : {kTorqueKey, kLine, kTable}) {
    if (!motor.has(key)) continue;
    if (!first.empty()) {
      motor.fault(
          key,
          fmt::format("is given beside motor.{}; expected one of torque, line and table", first));
      return false;
    }
    first = key;
  }
  if (!first.empty()) return true;
  motor.fault(
      kTorqueKey,
      "is missing; expected a torque, a line = {stall_torque, no_load_speed} or a table = [[speed, "
      "torque], ...]");
  return false;
}

void read_line(TableReader& motor, Motor& read) {
  TableReader line = motor.table(kLine);
  MotorLine given{1, 1};
  for (const auto& key : kLineKeys) {
    const bool is_given =
        key.form == KeyForm::speed ? line.has_speed(key.name) : line.has(key.name);
    if (!is_given) line.fault(key.name, fmt::format("is missing; expected {}", key.meaning));
  }
  read_keys(line, kLineKeys, given);
  line.finish();
  read.line = given;
  read.torque.of_speed = true;
  read.torque.value = [given](double, double omega, double) {
    return given.stall_torque * (1 - omega / given.no_load_speed);
  };
}

void read_speed_table(TableReader& motor, Motor& read) {
  const auto rows =
      motor.each_two(kTable, kQuantity, "[speed, torque]", {2, kMostMachineRows, "rows"});
  bool sound = true;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (!rows[i] || !rows[i - 1] || (*rows[i])[0] > (*rows[i - 1])[0]) continue;
    motor.faults().add(
        motor.where(kTable, i),
        fmt::format("row {} of motor.table has the speed {} after {}; expected increasing "
                    "speeds",
                    i + 1, (*rows[i])[0], (*rows[i - 1])[0]));
    sound = false;
  }
  const auto all = all_or_none(rows);
  if (!sound || !all) return;
  for (const auto& [speed, torque] : *all) read.torque.table.emplace_back(speed, torque);
  read.torque.of_speed = true;
  auto through =
      read.torque.smooth ? interpolate(read.torque.table) : straight_lines(read.torque.table);
  read.torque.value = [value = std::move(through)](double, double omega, double) {
    return value(omega);
  };
}

void read_torque(TableReader& motor, Motor& read) {
  if (motor.has_array(kTorqueKey)) {
    motor.fault(kTorqueKey,
                "is an array; expected a number or an expression in phi, w and t, and speeds with "
                "their torques under table = [[speed, torque], ...]");
    return;
  }
  auto torque = read_machine_function(motor, kTorqueKey, {}, false);
  if (torque) read.torque = std::move(torque->function);
}

}  // namespace

Motor read_motor(TableReader& table, const TrainContext& context) {
  Motor motor;
  motor.torque.smooth = read_interpolation(table, {kTable});
  table.know({kTorqueKey, kLine, kTable});
  if (has_exactly_one(table)) {
    if (table.has(kLine)) read_line(table, motor);
    if (table.has(kTable)) read_speed_table(table, motor);
    if (table.has(kTorqueKey)) read_torque(table, motor);
  }
  read_keys(table, kMotorKeys, motor);
  motor.train = read_motor_train(table, context);
  table.finish();
  return motor;
}

}  // namespace cognate::problems::reading
