#include "problems/layers/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/basics/degrees.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/evaluation/read_output.hpp"
#include "problems/evaluation/read_tolerances.hpp"
#include "problems/mechanism/directions.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/mechanism/read_links.hpp"
#include "problems/mechanism/read_whole_mechanism.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {
namespace {

constexpr int kMostSteps = 1'000'000;

// Values of one quantity that a table may hold, so that it fits into memory.
constexpr std::size_t kMostValues = 20'000'000;

/// The angle in degrees to 14 digits, so that a result that holds it is read as the same number.
double short_degrees(double angle) {
  const double exact = degrees(angle);
  if (exact == 0) return 0;
  const double unit = std::pow(10.0, 13 - std::floor(std::log10(std::abs(exact))));
  return std::round(exact * unit) / unit;
}

void read_angles(TableReader& table, double drawn, DriveSweep& drive) {
  const double start = read_degrees(table, "start_deg", short_degrees(drawn));
  const double end = read_degrees(table, "end_deg", start + 360);
  drive.start = radians(start);
  drive.end = radians(end);
  if (start == end) {
    table.fault("end_deg",
                "is start_deg, so that nothing moves; expected another angle (the end "
                "of a whole turn is start_deg + 360)");
  }
  for (const std::string_view key : {"start", "end"}) {
    if (!table.has(key)) continue;
    table.fault(key, fmt::format("is for a driving slider, and an angle drives this mechanism; "
                                 "expected {}_deg",
                                 key));
  }
}

void read_displacements(TableReader& table, DriveSweep& drive) {
  drive.start = table.number("start", kQuantity).value_or(0);
  if (!table.has("end")) {
    table.fault("end", "is missing; expected the displacement of the driving slider at the end");
  } else if (const auto end = table.number("end", kQuantity)) {
    drive.end = *end;
    if (drive.end == drive.start) {
      table.fault("end", "is start, so that nothing moves; expected another displacement");
    }
  }
  for (const std::string_view key : {"start_deg", "end_deg"}) {
    if (!table.has(key)) continue;
    table.fault(key, fmt::format("is for a crank, and a slider drives this mechanism; expected {}",
                                 key.substr(0, key.find('_'))));
  }
}

/// The sweep in `table`; with a driving slider (`slides`) its ends are lengths, else angles.
/// It begins at `drawn` where it does not say so. `parts`: how many bodies and points each step
/// evaluates, which limits the steps.
DriveSweep read_drive(TableReader& table, bool slides, double drawn, std::size_t parts) {
  constexpr std::string_view kSteps = "steps";
  DriveSweep drive;
  drive.rate.speed =
      (slides ? table.number("speed", kQuantity) : table.turning_speed("speed", kQuantity))
          .value_or(1);
  drive.rate.acceleration = table.number("acceleration", kQuantity).value_or(0);
  if (slides) {
    read_displacements(table, drive);
  } else {
    read_angles(table, drawn, drive);
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

/// A cylinder has no length of 0 or less.
void check_cylinder(TableReader& table, const NamedMechanism& mechanism, const DriveSweep& drive) {
  if (!std::holds_alternative<DrivingRod<double>>(mechanism.mechanism.drive)) return;
  if (!table.contains("start")) {
    table.fault("start", "is missing; expected the length of the cylinder at the beginning");
  }
  const auto check = [&](std::string_view key, double length) {
    if (length > 0 || !table.contains(key)) return;
    table.fault(key,
                fmt::format("is {}, as the length of the cylinder; expected one above 0", length));
  };
  check("start", drive.start);
  check("end", drive.end);
}

/// Where no mechanism can be read, the parts that the other tables name are not known, but their
/// numbers and keys are checked all the same.
void check_without_mechanism(TableReader& document, TableReader& mechanism, TableReader& drive,
                             TableReader& output) {
  const PartNames unknown = unknown_parts(document);
  const bool slides = document.has("slider") || mechanism.has("slider") ||
                      document.has("cylinder") || mechanism.has("cylinder");
  read_links(holder("link", document, mechanism), unknown);
  read_loads(holder("load", document, mechanism), unknown, slides);
  read_gravity(holder("gravity", document, mechanism));
  read_drive(drive, slides, 0, 0);
  read_output(output, unknown, false, slides);
}

/// What can be asked of four-bars with a coupler point alone.
void check_coupler_curve(TableReader& output, TableReader& mechanism,
                         const AnalysisProblem& problem) {
  if (problem.mechanism.type() == MechanismType::four_bar && mechanism.has("coupler_point")) return;
  if (problem.output.cognates) {
    output.fault(kCognates,
                 "is true; expected a four-bar with a coupler_point, no other has cognates");
  }
  if (problem.output.curve) {
    output.fault(kCurve,
                 "is true; expected a four-bar with a coupler_point, whose curve is measured");
  }
}

/// What is computed of drives and dyads alone.
void check_groups(TableReader& document, const AnalysisProblem& problem) {
  if (!has_groups(problem.mechanism.mechanism)) return;
  constexpr std::string_view kRefusal =
      "is not computed of mechanisms with a group of more than two links; expected dyads alone";
  for (const std::string_view key : {"tolerance", "layers"}) {
    if (document.contains(key)) document.fault(key, kRefusal);
  }
}

}  // namespace

}  // namespace cognate::problems::reading

namespace cognate::problems {

AnalysisProblem KindTraits<AnalysisProblem>::read(reading::TableReader& document,
                                                  const std::filesystem::path& /*folder*/) {
  using namespace reading;
  AnalysisProblem problem;
  TableReader mechanism = document.table("mechanism");
  TableReader drive = document.table("drive");
  TableReader output = document.table("output");
  auto whole = read_whole_mechanism(document, mechanism);
  if (!whole) {
    check_without_mechanism(document, mechanism, drive, output);
    return problem;
  }
  WholeMechanism& read = *whole;
  const bool slides = is_slider_driven(read.mechanism);
  const std::size_t parts = read.mechanism.bodies.size() + read.mechanism.points.size();
  problem.inertias = read_links(holder("link", document, mechanism), read.names);
  problem.loads = read_loads(holder("load", document, mechanism), read.names, slides);
  problem.gravity = read_gravity(holder("gravity", document, mechanism));
  problem.drive = read_drive(drive, slides, read.drawn.value_or(0), parts);
  check_cylinder(drive, read.mechanism, problem.drive);
  problem.output = read_output(output, read.names, has_forces(problem), slides);
  problem.mechanism = std::move(read.mechanism);
  check_coupler_curve(output, mechanism, problem);
  check_groups(document, problem);
  if (document.faults().size() == 0) {
    problem.tolerances = read_tolerances(document, problem.mechanism);
    problem.layers = read_layers(document, problem.mechanism);
  } else {
    document.know({"tolerance", "layers"});  // their names are those of a sound mechanism
  }
  mechanism.finish();
  return problem;
}

}  // namespace cognate::problems
