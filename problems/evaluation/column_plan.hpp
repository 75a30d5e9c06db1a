/// @file Which columns the table of an analysis has, and what each is computed from.
#pragma once

#include <string>
#include <vector>

#include "analysis/mechanism/sliding_pairs.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::problems {

/// The place of a column in the table; `kNone` where it is not requested.
using ColumnIndex = int;
inline constexpr ColumnIndex kNone = -1;

/// A coordinate (an angle, a displacement) with its velocity and acceleration.
struct CoordinateColumns {
  ColumnIndex position = kNone;
  ColumnIndex velocity = kNone;
  ColumnIndex acceleration = kNone;
};

struct BodyColumns {
  int body = 0;
  CoordinateColumns angle;
};

struct SlideColumns {
  SlidingPair pair;
  CoordinateColumns displacement;
};

/// Of a vector the column of x; that of y is the next.
struct PointColumns {
  Attached<double> at;
  CoordinateColumns coordinates;
  ColumnIndex curvature = kNone;
};

/// The transmission angle of an RRR dyad; of others the pressure angle, its signed complement.
struct TransmissionColumn {
  int dyad = 0;
  bool pressure = false;
  ColumnIndex column = kNone;
};

/// What `instant_geometry_columns` lists, of one body.
struct InstantColumns {
  int body = 0;
  ColumnIndex first = kNone;
};

/// Fx and Fy of a turning joint; normal force and moment of a sliding one.
struct JointColumns {
  int joint = 0;
  bool slides = false;
  ColumnIndex first = kNone;
};

/// The empty table and what fills it. The drive is column 0.
struct ColumnPlan {
  std::vector<Column> columns;
  std::vector<BodyColumns> bodies;
  std::vector<SlideColumns> slides;
  std::vector<PointColumns> points;
  std::vector<TransmissionColumn> transmissions;
  std::vector<InstantColumns> instants;
  std::vector<JointColumns> joints;
  ColumnIndex drive_force = kNone;
  ColumnIndex shaking = kNone;  ///< Fx, Fy, moment
};

/// The columns that `problem.output` requests, without values. What a body cannot do has none: one
/// that does not turn has no angle, and the drive, whose motion is given, only its coordinate.
ColumnPlan plan_columns(const AnalysisProblem& problem);

/// The derivatives that `output` needs: 0 positions alone, 1 velocities, 2 accelerations, 3 the
/// third derivatives.
int needed_order(const AnalysisOutput& output);

/// "crank_deg" or "slide": the name of the first column.
std::string drive_column_name(const Mechanism<double>& mechanism);

}  // namespace cognate::problems
