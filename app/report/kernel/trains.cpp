/// @file Gear trains in a page: a train or gearbox of which all is given is read and evaluated by
/// the program's own reader and evaluator, and comes back as the data that its page is drawn from.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/report/kernel/answer.hpp"
#include "app/report/kernel/document.hpp"
#include "app/report/kernel/numbers.hpp"
#include "app/report/kernel/problem_of.hpp"
#include "app/report/train_report_data.hpp"
#include "problems/train/result.hpp"

namespace cognate::page {

/// Evaluates the train in the text and the block of numbers. The answer is the data of its page
/// with notes and warnings, also those of each state, or `faults`, a list of sentences.
COGNATE_EXPORT(train) int train_text() {
  problems::reading::FaultList faults;
  const auto problem = problem_of<problems::GearTrainProblem>(document_of(question()), faults);
  if (!faults.empty()) return answer_with(faults_json(std::move(faults)));
  const auto result = problems::solve(problem, {.threads = 1});
  auto data = app::train_report_data(result);
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    data["designs"][i]["warnings"] = result.designs[i].warnings;
  }
  data["notes"] = result.notes;
  data["warnings"] = result.warnings;
  return answer_with(data);
}

}  // namespace cognate::page
