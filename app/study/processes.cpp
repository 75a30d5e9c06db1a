#include "app/study/processes.hpp"

namespace cognate::app {

bool StudyProcesses::agree(bool ready, std::string_view /*input*/) {
  return ready;
}

std::unique_ptr<StudyCrew> StudyProcesses::crew(const EvaluatorMaker& maker, WorkList& work,
                                                int threads) {
  return std::make_unique<ThreadCrew>(
      maker, [&work] { return work.next(); }, threads);
}

void StudyProcesses::serve(const EvaluatorMaker& /*maker*/, int /*threads*/) {}

}  // namespace cognate::app
