/// @file What the kernel of the pages leaves out of an analysis: tolerances and layers, which take
/// longer than an edit may.
#include "problems/evaluation/layer_figures.hpp"
#include "problems/evaluation/read_tolerances.hpp"
#include "problems/evaluation/tolerance_figures.hpp"
#include "problems/layers/read.hpp"

namespace cognate::problems {

std::optional<Tolerances> reading::read_tolerances(TableReader& /*document*/,
                                                   const NamedMechanism& /*mechanism*/) {
  return std::nullopt;
}

void add_tolerances(const AnalysisProblem& /*problem*/, const Sweep& /*rows*/, const Run& /*run*/,
                    const Deadline& /*deadline*/, AnalysisResult& /*result*/) {}

std::optional<LayerSizes> reading::read_layers(TableReader& /*document*/,
                                               const NamedMechanism& /*mechanism*/) {
  return std::nullopt;
}

void add_layers(const AnalysisProblem& /*problem*/, const AssemblyRanges& /*motion*/,
                const Deadline& /*deadline*/, AnalysisResult& /*result*/) {}

}  // namespace cognate::problems
