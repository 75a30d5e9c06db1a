/// @file Analyses in a page: a problem as its result holds it is read and evaluated by the
/// program's own reader and evaluator, and comes back as the data that its page is drawn from.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/report/analysis_report_data.hpp"
#include "app/report/kernel/answer.hpp"
#include "app/report/kernel/document.hpp"
#include "app/report/kernel/numbers.hpp"
#include "app/report/kernel/problem_of.hpp"
#include "app/report/mechanism_json.hpp"
#include "app/report/quantity_json.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/evaluation/motion_summary.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/evaluation/type_quantities.hpp"
#include "problems/evaluation/whole_motion.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::page {
namespace {

using nlohmann::ordered_json;
using problems::AnalysisProblem;

/// Samples of a motion that is drawn while a joint is dragged.
constexpr int kDraggedSamples = 181;

/// Whether a slider runs to infinity towards `drive`.
bool runs_away(const AssemblyRanges& ranges, double drive) {
  return std::ranges::any_of(ranges.points, [&](const SpecialPosition& point) {
    return point.kind == SpecialPositionKind::parallel_guides && point.drive == drive;
  });
}

/// Where the mechanism can be assembled, in degrees or, of a driving slider, its own unit; without
/// a part where a slider runs to infinity.
ordered_json ranges_of(const AssemblyRanges& ranges, bool slides) {
  constexpr double kFarAway = 0.05;
  ordered_json all = ordered_json::array();
  for (AssemblyRange run : ranges.runs) {
    const double part = kFarAway * (run.to - run.from);
    if (runs_away(ranges, run.from)) run.from += part;
    if (runs_away(ranges, run.to)) run.to -= part;
    if (slides) {
      all.push_back({run.from, run.to});
    } else {
      all.push_back({problems::degrees(run.from), problems::degrees(run.to)});
    }
  }
  return all;
}

/// The motion alone.
ordered_json motion_of(const AnalysisProblem& problem, const AssemblyRanges& ranges) {
  const auto& drive = problem.drive;
  return {{"mechanism", app::mechanism_motion_json(problem.mechanism, {drive.start, drive.end},
                                                   kDraggedSamples)},
          {"ranges", ranges_of(ranges, problems::drive_slides(problem))}};
}

/// The motion, and what follows from it.
ordered_json motion_with_facts(const AnalysisProblem& problem, const AssemblyRanges& ranges) {
  const problems::Deadline none{problems::Run{}};
  auto quantities = problems::type_quantities(problem.mechanism, problem.drive.start);
  const auto of_motion = problems::quantities_of(problems::summarise(problem, ranges, none));
  quantities.insert(quantities.end(), of_motion.begin(), of_motion.end());
  auto data = motion_of(problem, ranges);
  data["facts"] = app::quantities_json(quantities);
  return data;
}

/// Everything: also the table, its extremes and the notes.
ordered_json whole_of(const AnalysisProblem& problem) {
  const auto result = problems::analyse(problem, {.threads = 1});
  auto data = app::analysis_report_data(problem, result);
  data["notes"] = result.notes;
  data["closed_rows"] = result.closed_rows;
  return data;
}

/// How much of an analysis a page asks for.
enum Depth : int { motion_and_facts, everything, motion_alone };

ordered_json answer_of(const AnalysisProblem& problem, int depth) {
  if (depth == everything) return whole_of(problem);
  const problems::Deadline none{problems::Run{}};
  const auto& drive = problem.drive;
  const auto ranges = problems::follow_until(problem, drive.start, drive.end, none);
  return depth == motion_alone ? motion_of(problem, ranges) : motion_with_facts(problem, ranges);
}

}  // namespace

/// Evaluates the problem in the text and the block of numbers to a depth: 0 its motion and what
/// follows from it, 1 all of it, 2 its motion alone. The answer is the data of the page, or
/// `faults`, a list of sentences.
COGNATE_EXPORT(analysis) int analyse_text(int depth) {
  problems::reading::FaultList faults;
  const auto document = document_of(question());
  const auto problem = problem_of<AnalysisProblem>(document, faults);
  if (!faults.empty()) return answer_with(faults_json(std::move(faults)));
  return answer_with(answer_of(problem, depth));
}

}  // namespace cognate::page
