/// @file Cams in a page: a problem of which all is given is read and evaluated by the program's own
/// reader and evaluator, and comes back as the data that its page is drawn from.
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "analysis/cam/changed_follower.hpp"
#include "app/report/cam_report_data.hpp"
#include "app/report/kernel/answer.hpp"
#include "app/report/kernel/document.hpp"
#include "app/report/kernel/numbers.hpp"
#include "app/report/kernel/problem_of.hpp"
#include "problems/cam/result.hpp"

namespace cognate::page {
namespace {

cam::Cam taken;

}  // namespace

/// Evaluates the cam in the text and the block of numbers. The answer is the data of its page with
/// its notes, or `faults`, a list of sentences.
COGNATE_EXPORT(cam) int cam_text() {
  problems::reading::FaultList faults;
  const auto problem = problem_of<problems::CamProblem>(document_of(question()), faults);
  if (!faults.empty()) return answer_with(faults_json(std::move(faults)));
  const auto result = problems::solve(problem, {.threads = 1});
  auto data = app::cam_report_data(problem, result);
  data["notes"] = result.notes;
  return answer_with(data);
}

/// Takes the cam of the text and the block of numbers for `cam_misplaced`. The answer is `faults`,
/// a list of sentences.
COGNATE_EXPORT(cam_take) int take_cam() {
  problems::reading::FaultList faults;
  const auto problem = problem_of<problems::CamProblem>(document_of(question()), faults);
  if (faults.empty()) taken = problems::solve(problem, {.threads = 1}).designs.front().cam;
  return answer_with(faults_json(std::move(faults)));
}

/// By how much the follower of that cam is off where its dimensions are: the block of numbers has
/// the changes, in the order of CamDimensions, and `count` cam angles in radians; in the place of
/// these it then has the misplacements, NaN where there is none.
COGNATE_EXPORT(cam_misplaced) void misplace_cam(int count) {
  const auto n = numbers();
  const cam::CamDimensions<double> changes{n[0], n[1], n[2], n[3], n[4], n[5]};
  for (double& at : n.subspan(6, static_cast<std::size_t>(count))) {
    const auto off = cam::ChangedFollower(taken, at).misplacement(changes);
    at = off.value_or(std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace cognate::page
