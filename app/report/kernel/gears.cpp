/// @file Gears in a page: a gear, or a pair of which all is given, is read and evaluated by the
/// program's own reader and evaluator, and comes back as the data that its page is drawn from.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/report/gear_report_data.hpp"
#include "app/report/kernel/answer.hpp"
#include "app/report/kernel/document.hpp"
#include "app/report/kernel/numbers.hpp"
#include "app/report/kernel/problem_of.hpp"
#include "problems/gear/result.hpp"

namespace cognate::page {

/// Evaluates the gear in the text and the block of numbers. The answer is the data of its page with
/// its notes, or `faults`, a list of sentences.
COGNATE_EXPORT(gear) int gear_text() {
  problems::reading::FaultList faults;
  const auto problem = problem_of<problems::GearProblem>(document_of(question()), faults);
  if (!faults.empty()) return answer_with(faults_json(std::move(faults)));
  const auto result = problems::analyse(problem, {.threads = 1});
  auto data = app::gear_report_data(problem, result);
  data["notes"] = result.notes;
  return answer_with(data);
}

/// The same of a pair.
COGNATE_EXPORT(gear_pair) int gear_pair_text() {
  problems::reading::FaultList faults;
  const auto problem = problem_of<problems::GearPairProblem>(document_of(question()), faults);
  if (!faults.empty()) return answer_with(faults_json(std::move(faults)));
  const auto result = problems::solve(problem, {.threads = 1});
  auto data = app::gear_pair_report_data(problem, result);
  data["notes"] = result.notes;
  return answer_with(data);
}

}  // namespace cognate::page
