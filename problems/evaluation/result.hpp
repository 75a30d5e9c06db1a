/// @file What analysing a mechanism gives: a table with a row for each step of the drive, and what
/// holds for the motion as a whole.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/evaluation/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// A column of the table. `name` carries the unit, as in the CSV's header: "crank_deg", "C_x",
/// "coupler_omega_rad_s", "torque_N_m". Values are in that unit; one for each row, NaN where the
/// mechanism cannot be assembled (an empty cell in files).
struct Column {
  std::string name;
  std::string quantity;  ///< "drive", "position", "velocity", "acceleration", "transmission",
                         ///< "curvature", "instant-geometry", "reactions" or "torque"
  std::string of;        ///< the name of the body, point or joint
  std::string unit;      ///< "deg", "length", "rad/s", "N"… ; empty for pure numbers
  std::vector<double> values;
};

/// A place in the motion worth a name: a "limit position" of the output, a "dead point", "change
/// point" or "undetermined change point" of a dyad, its "least transmission angle" or "greatest
/// transmission angle", an "end of range" where its guides are parallel; a "cusp", "inflection" or
/// "double point" of a point's path.
struct Landmark {
  std::string kind;
  std::string of;    ///< the name of the body, dyad or point
  double drive = 0;  ///< radians or length
  double value = 0;  ///< of the output there: radians, counted as in the table, or length; NaN
                     ///< where its position is not determined
  std::optional<double> again{};  ///< of a double point: where the drive is at the other passage
};

/// A four-bar whose coupler point traces the same curve as that of the mechanism analysed.
struct Cognate {
  bool timed = true;  ///< its crank turns with the mechanism's; else with the mechanism's coupler
  FourBar linkage;
  double crank_angle = 0;  ///< from the x axis, where the drive is at its start
};

/// What an analysis found, row by row and as a whole.
struct AnalysisResult {
  Status status = Status::no_solution;  ///< `solved` where a row closes
  std::vector<Column> columns;          ///< the drive first
  int closed_rows = 0;                  ///< where the mechanism can be assembled
  std::vector<Landmark> landmarks;
  std::vector<Quantity> quantities;  ///< of the motion as a whole
  std::vector<Cognate> cognates;
  std::optional<ToleranceResult> tolerance{};  ///< where the file has tolerances
  std::optional<LayerResult> layers{};         ///< where the file has layers
  Work work;
  std::vector<std::string> notes;
};

/// Evaluates the mechanism over its drive.
AnalysisResult analyse(const AnalysisProblem& problem, const Run& run);

}  // namespace cognate::problems
