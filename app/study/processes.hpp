/// @file The processes that run a study together: one, or those that mpirun started.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "app/study/crew.hpp"

namespace cognate::app {

/// By itself, one process. The first of several stores the rows and talks to the user; the others
/// evaluate what it hands out.
class StudyProcesses {
 public:
  StudyProcesses() = default;
  StudyProcesses(const StudyProcesses&) = delete;
  StudyProcesses& operator=(const StudyProcesses&) = delete;
  virtual ~StudyProcesses() = default;

  virtual bool is_first() const { return true; }

  /// Called once by each process: whether it can begin, and all that its evaluation depends on.
  /// True where all can and have the same input; else the first has said why not, unless it is the
  /// first itself that cannot.
  virtual bool agree(bool ready, std::string_view input);

  /// Of the first process: those who evaluate `work`, which outlives them.
  virtual std::unique_ptr<StudyCrew> crew(const EvaluatorMaker& maker, WorkList& work, int threads);

  /// Of the others: evaluates until the first has no more.
  virtual void serve(const EvaluatorMaker& maker, int threads);
};

/// What this process belongs to, from its beginning to its end. There is one for a program without
/// MPI and one for a program with it; empty, once that has been said, where this one cannot run.
std::unique_ptr<StudyProcesses> begin_processes(int argc, char** argv);

}  // namespace cognate::app
