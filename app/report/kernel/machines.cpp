/// @file Machines in a page: a problem as its result holds it is read and run by the program's own
/// reader and evaluator, and comes back as the data that its page is drawn from.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/report/kernel/answer.hpp"
#include "app/report/kernel/document.hpp"
#include "app/report/kernel/numbers.hpp"
#include "app/report/kernel/problem_of.hpp"
#include "app/report/machine_report_data.hpp"
#include "problems/machine/result.hpp"

namespace cognate::page {

/// Runs the machine in the text and the block of numbers. The answer is the data of its page with
/// its notes, or `faults`, a list of sentences.
COGNATE_EXPORT(machine) int machine_text() {
  problems::reading::FaultList faults;
  const auto problem = problem_of<problems::MachineProblem>(document_of(question()), faults);
  if (!faults.empty()) return answer_with(faults_json(std::move(faults)));
  const auto result = problems::run_machine(problem, {.threads = 1});
  auto data = app::machine_report_data(problem, result);
  data["notes"] = result.notes;
  return answer_with(data);
}

}  // namespace cognate::page
