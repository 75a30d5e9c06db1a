/// @file What the kernel of the pages leaves out of an analysis: tolerances, whose draws take
/// longer than an edit may. Pages of problems with tolerances have no kernel.
#include "problems/evaluation/tolerance_figures.hpp"
#include "problems/evaluation/tolerance_scope.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {

reading::ToleranceScope tolerance_scope(const NamedMechanism& /*mechanism*/) {
  return {};
}

std::optional<Tolerances> reading::read_tolerances(TableReader& /*document*/,
                                                   const ToleranceScope& /*scope*/) {
  return std::nullopt;
}

void add_tolerances(const AnalysisProblem& /*problem*/, const Sweep& /*rows*/, const Run& /*run*/,
                    const Deadline& /*deadline*/, AnalysisResult& /*result*/) {}

}  // namespace cognate::problems
