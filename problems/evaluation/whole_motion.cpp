#include "problems/evaluation/whole_motion.hpp"

#include <variant>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {

AssemblyRanges follow_until(const AnalysisProblem& problem, double start, double end,
                            const Deadline& deadline) {
  return follow(problem.mechanism.mechanism, start, end, [&] { return deadline.reached(); });
}

AssemblyRanges whole_motion(const AnalysisProblem& problem, const Deadline& deadline) {
  const auto& drive = problem.mechanism.mechanism.drive;
  const double start = problem.drive.start;
  const bool slides = driven_by_length(drive);
  const double end = slides ? problem.drive.end : start + kTurn;
  return follow_until(problem, start, end, deadline);
}

}  // namespace cognate::problems
