/// @file What the terminal shows of a machine.
#pragma once

#include <string>

#include "app/console/screen.hpp"
#include "problems/machine/result.hpp"

namespace cognate::app {

/// The problem in one line: what moves, what drives it, which motions are wanted.
std::string describe(const problems::MachineProblem& problem);

/// The status, the facts and the notes of a run.
std::string machine_table(const problems::MachineProblem& problem,
                          const problems::MachineResult& result, const Screen& screen);

/// The table of all motions, whose columns are the same, as CSV, as `csv_text` does, with the task
/// before the other columns.
std::string machine_csv(const problems::MachineResult& result);

}  // namespace cognate::app
