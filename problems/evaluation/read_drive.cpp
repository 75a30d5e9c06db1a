#include "problems/evaluation/read_drive.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "problems/mechanism/directions.hpp"
#include "problems/mechanism/quantity_rules.hpp"

namespace cognate::problems::reading {
namespace {

constexpr int kMostSteps = 1'000'000;

// Values of one quantity that a table may hold, so that it fits into memory.
constexpr std::size_t kMostValues = 20'000'000;

void read_angles(TableReader& table, DriveSweep& drive) {
  const double start = read_degrees(table, "start_deg", 0);
  const double end = read_degrees(table, "end_deg", start + 360);
  drive.start = radians(start);
  drive.end = radians(end);
  if (start == end) {
    table.fault("end_deg",
                "is start_deg, so that nothing moves; another angle is wanted (the end "
                "of a whole turn is start_deg + 360)");
  }
  for (const std::string_view key : {"start", "end"}) {
    if (!table.has(key)) continue;
    table.fault(key, fmt::format("is for a driving slider, and an angle drives this mechanism; "
                                 "{}_deg is wanted",
                                 key));
  }
}

void read_displacements(TableReader& table, DriveSweep& drive) {
  drive.start = table.number("start", kQuantity).value_or(0);
  if (!table.has("end")) {
    table.fault("end", "is missing; the displacement of the driving slider at the end is wanted");
  } else if (const auto end = table.number("end", kQuantity)) {
    drive.end = *end;
    if (drive.end == drive.start) {
      table.fault("end", "is start, so that nothing moves; another displacement is wanted");
    }
  }
  for (const std::string_view key : {"start_deg", "end_deg"}) {
    if (!table.has(key)) continue;
    table.fault(key, fmt::format("is for a crank, and a slider drives this mechanism; {} is wanted",
                                 key.substr(0, key.find('_'))));
  }
}

}  // namespace

DriveSweep read_drive(TableReader& table, bool slides, std::size_t parts) {
  constexpr std::string_view kSteps = "steps";
  DriveSweep drive;
  drive.rate.speed = table.number("speed", kQuantity).value_or(1);
  drive.rate.acceleration = table.number("acceleration", kQuantity).value_or(0);
  if (slides) {
    read_displacements(table, drive);
  } else {
    read_angles(table, drive);
  }
  drive.steps = table.integer(kSteps, 1, kMostSteps).value_or(drive.steps);
  const std::size_t most = kMostValues / std::max<std::size_t>(parts, 1);
  if (static_cast<std::size_t>(drive.steps) > most) {
    table.fault(kSteps, fmt::format("is {} for {} bodies and points; at most {} are allowed for "
                                    "so many",
                                    drive.steps, parts, most));
  }
  table.finish();
  return drive;
}

}  // namespace cognate::problems::reading
