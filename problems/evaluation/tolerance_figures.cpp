#include "problems/evaluation/tolerance_figures.hpp"

#include <algorithm>
#include <iterator>
#include <variant>
#include <vector>

#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "problems/evaluation/active_loads.hpp"
#include "problems/evaluation/drive_rows.hpp"
#include "problems/evaluation/load_breaks.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/tolerance/figures.hpp"

namespace cognate::problems {
namespace {

constexpr int kMostStations = 720;

/// A point that is no joint: what a designer made the mechanism for.
bool is_point_of_interest(const NamedMechanism& mechanism, const std::string& name) {
  const bool extra = std::ranges::find(mechanism.extra_points, name, &PointDescription::name) !=
                     mechanism.extra_points.end();
  return extra || name == "P";
}

void add_points(const AnalysisProblem& problem, ToleranceQuestion& question) {
  const NamedMechanism& mechanism = problem.mechanism;
  const std::string& judged = problem.tolerances->of;
  for (std::size_t i = 0; i < mechanism.points.size(); ++i) {
    const auto& [name, at] = mechanism.points[i];
    if (at.body == 0 || (name != judged && !is_point_of_interest(mechanism, name))) continue;
    ToleranceQuantity point{.name = name, .judged = name == judged};
    point.response.type = ResponseType::point;
    point.response.index = i;
    question.quantities.push_back(std::move(point));
  }
}

bool weighs_or_bears(const AnalysisProblem& problem) {
  return !problem.loads.empty() ||
         std::ranges::any_of(problem.inertias, [](const Inertia& inertia) {
           return inertia.mass > 0 || inertia.moment > 0;
         });
}

/// The forces in the joints at each station; none where a pin has no clearance or nothing is
/// loaded.
void add_reactions(const AnalysisProblem& problem, const Deadline& deadline,
                   ToleranceQuestion& question) {
  if (problem.tolerances->clearances.empty() || !weighs_or_bears(problem)) return;
  const Mechanism<double>& mechanism = problem.mechanism.mechanism;
  const auto strokes = load_strokes(problem, deadline);
  ActiveLoads loads(mechanism, problem.loads, strokes);
  InverseDynamics dynamics(mechanism, problem.inertias, problem.gravity);
  MechanismMotion<2> motion(mechanism);
  for (std::size_t s = 0; s < question.stations.size(); ++s) {
    std::ranges::copy(question.stations[s].sides, motion.sides().begin());
    motion.move_to(question.stations[s].drive);
    const DriveRate& rate = problem.drive.rate;
    const auto active = loads.at<2>(question.drive[s], rate.speed, motion.bodies());
    question.reactions.push_back(dynamics.forces());
    if (!dynamics.solve<2>(motion.bodies(), rate, active, question.reactions.back())) {
      question.reactions.back() = dynamics.forces();
    }
  }
}

}  // namespace

void add_tolerances(const AnalysisProblem& problem, const Sweep& rows, const Run& run,
                    const Deadline& deadline, AnalysisResult& result) {
  if (!problem.tolerances || deadline.reached()) return;
  run.enter(Phase::tolerances, kUnknownEnd);
  const NamedMechanism& mechanism = problem.mechanism;
  ToleranceQuestion question;
  const int count = static_cast<int>(rows.rows.size());
  const int step = std::max(1, (count + kMostStations - 1) / (kMostStations + 1));
  std::vector<double> drives;
  for (int row = 0; row < count; row += step) drives.push_back(drive_at(problem.drive, row));
  add_stations(mechanism.mechanism, rows.assembly_ranges, drives, question.drive,
               question.stations);
  question.motion = question.stations;
  question.motion_drive = question.drive;
  question.quantities.push_back(
      {.name = mechanism.bodies[static_cast<std::size_t>(mechanism.output)],
       .response = travel_response(mechanism.mechanism, mechanism.output),
       .judged = problem.tolerances->of.empty()});
  add_points(problem, question);
  if (problem.output.transmission) add_transmissions(mechanism, question);
  add_reactions(problem, deadline, question);
  ToleranceRun own{.seed = run.seed, .threads = run.threads};
  own.stop = [&] { return deadline.reached(); };
  result.tolerance =
      tolerance_figures(mechanism, *problem.tolerances, problem.length_unit, question, own);
  std::ranges::move(tolerance_quantities(*result.tolerance), std::back_inserter(result.quantities));
}

}  // namespace cognate::problems
