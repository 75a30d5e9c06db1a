#include "problems/evaluation/layer_figures.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "problems/layers/assign.hpp"
#include "problems/layers/notes.hpp"

namespace cognate::problems {

void add_layers(const AnalysisProblem& problem, const AssemblyRanges& motion,
                const Deadline& deadline, AnalysisResult& result) {
  if (!problem.layers) return;
  if (motion.runs.empty()) {
    result.notes.emplace_back("the links have no layers: the mechanism can be assembled nowhere");
    return;
  }
  auto layers =
      assign_layers(problem.mechanism, motion, *problem.layers, [&] { return deadline.reached(); });
  if (!layers) {
    result.notes.push_back(layers.error());
    return;
  }
  std::ranges::move(layer_quantities(*layers), std::back_inserter(result.quantities));
  if (!layers->count) {
    result.notes.push_back(blocked_note(*layers, drive_slides(problem)));
  }
  if (auto note = unresolved_note(*layers, drive_slides(problem)); !note.empty()) {
    result.notes.push_back(std::move(note));
  }
  result.layers = *std::move(layers);
}

}  // namespace cognate::problems
