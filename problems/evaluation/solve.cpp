#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "analysis/coupler_curve/curve_features.hpp"
#include "analysis/linkage/cognates.hpp"
#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/gait.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/evaluation/curve_metrics.hpp"
#include "problems/evaluation/drive_rows.hpp"
#include "problems/evaluation/force_extremes.hpp"
#include "problems/evaluation/force_units.hpp"
#include "problems/evaluation/instant_geometry.hpp"
#include "problems/evaluation/layer_figures.hpp"
#include "problems/evaluation/load_breaks.hpp"
#include "problems/evaluation/motion_quantities.hpp"
#include "problems/evaluation/motion_summary.hpp"
#include "problems/evaluation/output_travel.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/evaluation/sweep.hpp"
#include "problems/evaluation/tolerance_figures.hpp"
#include "problems/evaluation/type_quantities.hpp"
#include "problems/evaluation/whole_motion.hpp"
#include "problems/linkage/gait_quantities.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {
namespace {

constexpr int kCoupler = 2;

/// The drive's positions at which a motion takes a position of its linkage.
class LandmarkPassages {
 public:
  explicit LandmarkPassages(const AssemblyRanges& assembly_ranges)
      : assembly_ranges_(assembly_ranges) {}

  std::vector<double> of(const CrankPosition& position) const {
    const auto [low, high] = std::minmax(assembly_ranges_.start, assembly_ranges_.end);
    std::vector<double> drives;
    const double first = std::ceil((low - kSlack - position.crank_angle) / kTurn);
    for (double turn = first;; ++turn) {
      const double drive = position.crank_angle + turn * kTurn;
      if (!(drive <= high + kSlack)) return drives;
      if (takes(drive, position.side)) drives.push_back(std::clamp(drive, low, high));
    }
  }

 private:
  /// Positions at the ends of ranges are known to rounding, and belong to both assemblies there.
  static constexpr double kSlack = 1e-9;

  bool takes(double drive, Assembly side) const {
    return std::ranges::any_of(assembly_ranges_.runs, [&](const AssemblyRange& run) {
      if (drive < run.from - kSlack || drive > run.to + kSlack) return false;
      const bool dead = (run.from_dyad >= 0 && drive < run.from + kSlack) ||
                        (run.to_dyad >= 0 && drive > run.to - kSlack);
      return dead || sides_at(run, drive).front() == sign(side);
    });
  }

  const AssemblyRanges& assembly_ranges_;
};

class CurveLandmarks {
 public:
  CurveLandmarks(const AnalysisProblem& problem, const AssemblyRanges& assembly_ranges)
      : passages_(assembly_ranges),
        travel_(output_travel(problem.mechanism)),
        motion_(problem.mechanism.mechanism, assembly_ranges) {}

  void add(const CurveFeatures& features, const std::string& point) {
    for (const CurvePoint& cusp : features.cusps) add_all("cusp", point, cusp);
    for (const CurvePoint& place : features.inflections) add_all("inflection", point, place);
    for (const DoublePoint& place : features.double_points) add_double(point, place);
  }

  std::vector<Landmark> take() { return std::move(all_); }

 private:
  void add_all(const char* kind, const std::string& of, const CurvePoint& place) {
    for (const double drive : passages_.of(place.position)) {
      all_.push_back({kind, of, drive, output(drive)});
    }
  }

  /// Each passage names the nearest of the other kind; none is a double point alone.
  void add_double(const std::string& of, const DoublePoint& place) {
    const auto first = passages_.of(place.first.position);
    const auto second = passages_.of(place.second.position);
    add_passages(of, first, second);
    add_passages(of, second, first);
  }

  void add_passages(const std::string& of, const std::vector<double>& here,
                    const std::vector<double>& there) {
    if (there.empty()) return;
    for (const double drive : here) {
      const auto distance = [&](double other) { return std::abs(other - drive); };
      const double again = *std::ranges::min_element(there, {}, distance);
      all_.push_back({"double point", of, drive, output(drive), again});
    }
  }

  double output(double drive) {
    return motion_.move_to(drive) ? travelled<0>(travel_, motion_.bodies())
                                  : std::numeric_limits<double>::quiet_NaN();
  }

  LandmarkPassages passages_;
  Travel travel_;
  FollowedMotion<0> motion_;
  std::vector<Landmark> all_;
};

bool is_reported(const AnalysisOutput& output, int point) {
  return output.points.empty() || std::ranges::find(output.points, point) != output.points.end();
}

/// Landmarks of the reported points on the coupler of a four-bar: "cusp", "inflection", and "double
/// point" for each of its two passages, each naming the other; those that the motion along
/// `assembly_ranges` really reaches, in its assemblies. Nothing where curvature is not requested,
/// and for other mechanisms. Points that are not reached before `deadline` have none.
std::vector<Landmark> curve_landmarks(const AnalysisProblem& problem,
                                      const AssemblyRanges& assembly_ranges,
                                      const Deadline& deadline) {
  const auto& mechanism = problem.mechanism;
  if (!problem.output.curvature || !mechanism.four_bar() || assembly_ranges.runs.empty()) return {};
  CurveLandmarks landmarks(problem, assembly_ranges);
  for (std::size_t i = 0; i < mechanism.points.size() && !deadline.reached(); ++i) {
    const auto& [name, at] = mechanism.points[i];
    if (at.body != kCoupler || !is_reported(problem.output, static_cast<int>(i))) continue;
    FourBar tracing = *mechanism.four_bar();
    tracing.coupler_point = at.at;
    if (const auto features = curve_features(tracing)) landmarks.add(*features, name);
  }
  return landmarks.take();
}

/// That the drive crosses several ranges, and which quantities belong to which; that a stroke has
/// no end.
std::vector<std::string> motion_notes(const AnalysisProblem& problem,
                                      const MotionSummary& summary) {
  std::vector<std::string> notes;
  if (summary.ranges > 1) {
    const auto& drive = problem.mechanism.mechanism.drive;
    const bool slides = driven_by_length(drive);
    const double unit = slides ? 1 : 180 / kPi;
    notes.push_back(fmt::format(
        "the drive crosses {} separate ranges of the mechanism; its stroke or swing is that of the "
        "first, from {:.6g} to {:.6g}{}",
        summary.ranges, unit * summary.from + 0.0, unit * summary.to + 0.0,
        summary.transmission ? ", its transmission and pressure angles are the extremes of all"
                             : ""));
  }
  if (!summary.endless.empty()) {
    notes.push_back(fmt::format(
        "the stroke of {} has no end: it grows without bound where guides become parallel",
        summary.endless));
  }
  return notes;
}

int closed_rows(const Sweep& sweep) {
  return static_cast<int>(std::ranges::count(sweep.rows, kNone, &RowState::open_dyad));
}

Status status_of(const Sweep& sweep, const Deadline& deadline, bool whole) {
  if (!whole) return deadline.interrupted() ? Status::interrupted : Status::time_limit;
  return closed_rows(sweep) > 0 ? Status::solved : Status::no_solution;
}

/// Where the table was ended early; nothing where it is whole.
std::optional<std::string> ended_note(const AnalysisProblem& problem, const Sweep& sweep,
                                      const Deadline& deadline) {
  const int wanted = row_count(problem.drive);
  if (sweep.rows.size() >= static_cast<std::size_t>(wanted)) return std::nullopt;
  const char* what = deadline.interrupted() ? "the interruption ended the table"
                                            : "the time limit ended the table";
  return fmt::format("{} after {} of {} positions", what, sweep.rows.size(), wanted);
}

std::vector<std::string> skipped(const AnalysisOutput& wanted) {
  std::vector<std::string> names;
  const auto unless = [&](bool asked, const char* name) {
    if (!asked) names.emplace_back(name);
  };
  const int order = needed_order(wanted);
  unless(order >= 1, "velocities");
  unless(order >= 2, "accelerations");
  unless(order >= 3, "third derivatives");
  unless(wanted.curvature, "curvature");
  unless(wanted.transmission, "transmission");
  unless(wanted.torque, "torque");
  unless(wanted.reactions, "reactions");
  return names;
}

Work work_of(const AnalysisProblem& problem, const Sweep& sweep, const Run& run,
             const Deadline& deadline) {
  const int order = needed_order(problem.output);
  const std::uint64_t rows = sweep.rows.size();
  Work work;
  work.seconds = deadline.spent();
  work.threads = thread_count(run.threads);
  work.positions = rows;
  work.velocities = order >= 1 ? rows : 0;
  work.accelerations = order >= 2 ? rows : 0;
  work.reactions = problem.output.reactions ? rows : 0;
  work.skipped = skipped(problem.output);
  return work;
}

/// Where the motion is just after its start, in its own sense: a start on a change point is on the
/// motion that has the assembly there.
double after_start(const DriveSweep& drive) {
  constexpr double kStep = 2e-7;  // as the assembly ranges of the motion have it
  return drive.end < drive.start ? drive.start - kStep : drive.start;
}

/// The course of the rows, or of its first two turns, after which every motion repeats itself (an
/// antiparallelogram takes two).
AssemblyRanges summarised_assembly_ranges(const AnalysisProblem& problem, const Sweep& sweep,
                                          const Deadline& deadline) {
  const double most = 4 * kPi;
  const double length = problem.drive.end - problem.drive.start;
  const auto& drive = problem.mechanism.mechanism.drive;
  const bool slides = driven_by_length(drive);
  if (slides || std::abs(length) <= most) return sweep.assembly_ranges;
  const double start = problem.drive.start;
  return follow_until(problem, start, start + std::copysign(most, length), deadline);
}

/// Adds whole turns to the output's angles at landmarks, so that they are those of the rows.
void count_with_rows(std::vector<Landmark>& landmarks, const AnalysisProblem& problem,
                     const Sweep& sweep) {
  const auto is_output = [&](const BodyColumns& body) {
    return body.body == problem.mechanism.output && body.angle.position != kNone;
  };
  const auto found = std::ranges::find_if(sweep.plan.bodies, is_output);
  if (found == sweep.plan.bodies.end()) return;
  const auto& angles = sweep.plan.columns[static_cast<std::size_t>(found->angle.position)].values;
  const auto& [start, end, steps, rate] = problem.drive;
  for (Landmark& landmark : landmarks) {
    const double row = std::round((landmark.drive - start) / (end - start) * steps);
    if (!(row >= 0 && row < static_cast<double>(angles.size()))) continue;
    const double there = angles[static_cast<std::size_t>(row)] * kPi / 180;
    if (std::isfinite(there)) {
      landmark.value = there + std::remainder(landmark.value - there, kTurn);
    }
  }
}

void append(std::vector<Quantity>& quantities, std::vector<Quantity> more) {
  std::ranges::move(more, std::back_inserter(quantities));
}

/// In the order of the motion.
void append(std::vector<Landmark>& landmarks, std::vector<Landmark> more,
            const AssemblyRanges& assembly_ranges) {
  std::ranges::move(more, std::back_inserter(landmarks));
  std::ranges::stable_sort(landmarks, [&](const Landmark& a, const Landmark& b) {
    return assembly_ranges.start <= assembly_ranges.end ? a.drive < b.drive : a.drive > b.drive;
  });
}

/// Those that exist, of the mechanism where its drive starts.
std::vector<Cognate> cognates(const AnalysisProblem& problem) {
  const FourBar* four_bar = problem.mechanism.four_bar();
  if (!problem.output.cognates || !four_bar) return {};
  const double start = problem.drive.start;
  std::vector<Cognate> all;
  if (const auto timed = timed_cognate(*four_bar)) {
    all.push_back({true, *timed, start - frame_angle(*four_bar) + frame_angle(*timed)});
  }
  if (const auto by_coupler = coupler_cognate(*four_bar, start)) {
    all.push_back({false, by_coupler->linkage, by_coupler->crank_angle});
  }
  return all;
}

/// A crank that turns clockwise runs through the stance from its greater angle to the smaller.
Gait as_driven(Gait gait, const DriveSweep& drive) {
  if (drive.rate.speed >= 0) return gait;
  const double span = gait.to - gait.from;
  gait.from = in_one_turn(gait.to);
  gait.to = gait.from - span;
  gait.sense = -gait.sense;
  return gait;
}

/// Adds the gait of the foot, where one is named, or why it has none.
void add_gait(AnalysisResult& result, const AnalysisProblem& problem) {
  if (!problem.output.foot) return;
  const auto& mechanism = problem.mechanism.mechanism;
  const auto& [name, foot] =
      problem.mechanism.points[static_cast<std::size_t>(*problem.output.foot)];
  const double start = problem.drive.start;
  const AssemblyRanges turn = follow(mechanism, start, start + kTurn);
  const bool whole = turn.runs.size() == 1 && turn.points.empty();
  const auto found = whole ? gait(mechanism, foot, problem.output.duty) : std::nullopt;
  if (found) {
    return append(result.quantities, gait_quantities(as_driven(*found, problem.drive)));
  }
  const char* reason = whole ? "its path has no height or no stride"
                             : "the crank cannot make a whole turn without dead points";
  result.notes.push_back(fmt::format("The point {} has no gait: {}.", name, reason));
}

/// Adds the extremes of forces: over the whole motion, or of the rows alone where the time does not
/// suffice.
void add_forces(AnalysisResult& result, const AnalysisProblem& problem, const Sweep& rows,
                const Deadline& deadline) {
  std::optional<ForceExtremes> refined;
  const bool asked = problem.output.torque || problem.output.reactions;
  if (asked && !deadline.reached()) {
    const AssemblyRanges assembly_ranges = summarised_assembly_ranges(problem, rows, deadline);
    refined = force_extremes(problem, assembly_ranges, load_strokes(problem, deadline), deadline);
  }
  auto [quantities, notes] = force_quantities(problem, rows, refined);
  append(result.quantities, std::move(quantities));
  std::ranges::move(notes, std::back_inserter(result.notes));
}

/// Adds what holds of the motion as a whole; nothing, and false, if the time does not suffice.
bool summarise_into(AnalysisResult& result, const AnalysisProblem& problem, const Sweep& rows,
                    const Deadline& deadline) {
  if (rows.rows.size() < static_cast<std::size_t>(row_count(problem.drive))) return false;
  const AssemblyRanges assembly_ranges = summarised_assembly_ranges(problem, rows, deadline);
  MotionSummary summary = summarise(problem, assembly_ranges, deadline);
  std::vector<Landmark>& landmarks = summary.landmarks;
  append(landmarks, curve_landmarks(problem, assembly_ranges, deadline), assembly_ranges);
  if (deadline.reached()) return false;
  count_with_rows(landmarks, problem, rows);
  append(result.quantities, quantities_of(summary));
  std::ranges::move(motion_notes(problem, summary), std::back_inserter(result.notes));
  append(result.quantities, curve_quantities(problem));
  add_gait(result, problem);
  result.landmarks = std::move(landmarks);
  result.cognates = cognates(problem);
  return true;
}

}  // namespace

AnalysisResult analyse(const AnalysisProblem& given, const Run& run) {
  const double unit = metres(given.length_unit);
  AnalysisProblem problem = in_newtons(given, unit);
  problem.inertias.resize(problem.mechanism.bodies.size());
  const Deadline deadline(run);
  run.enter(Phase::positions);
  Sweep rows = sweep(problem, run, deadline);
  AnalysisResult result;
  result.closed_rows = closed_rows(rows);
  result.notes = open_row_notes(problem, rows);
  if (const auto note = ended_note(problem, rows, deadline)) result.notes.push_back(*note);
  append(result.quantities, type_quantities(problem.mechanism, after_start(problem.drive)));
  const bool whole = summarise_into(result, problem, rows, deadline);
  result.status = status_of(rows, deadline, whole);
  add_forces(result, problem, rows, deadline);
  append(result.quantities, check_quantities(rows));
  add_tolerances(problem, rows, run, deadline, result);
  if (problem.layers && !deadline.reached()) {
    run.enter(Phase::layers, kUnknownEnd);
    add_layers(problem, summarised_assembly_ranges(problem, rows, deadline), deadline, result);
  }
  result.work = work_of(problem, rows, run, deadline);
  result.columns = std::move(rows.plan.columns);
  std::erase_if(result.columns, [](const Column& column) {
    return is_inflection_line(column) &&
           std::ranges::all_of(column.values, [](double value) { return std::isnan(value); });
  });
  to_newton_metres(result, unit);
  std::ranges::move(unit_notes(given, given.length_unit), std::back_inserter(result.notes));
  return result;
}

}  // namespace cognate::problems
