#include "problems/evaluation/load_strokes.hpp"

#include <algorithm>
#include <cstddef>

#include "analysis/mechanism/output_limits.hpp"
#include "analysis/mechanism/travel.hpp"
#include "problems/evaluation/whole_motion.hpp"

namespace cognate::problems {
std::vector<Stroke> load_strokes(const AnalysisProblem& problem, const Deadline& deadline) {
  const auto needs = [](const LoadRule& rule) { return rule.within_stroke.has_value(); };
  if (std::ranges::none_of(problem.loads, needs)) return {};
  const auto& mechanism = problem.mechanism.mechanism;
  const AssemblyRanges assembly_ranges = whole_motion(problem, deadline);
  const auto all = travels(mechanism);
  std::vector<Stroke> strokes(problem.loads.size());
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (!needs(problem.loads[i])) continue;
    const auto body = static_cast<std::size_t>(problem.loads[i].at.body);
    const auto range = output_range(mechanism, assembly_ranges, all[body]);
    if (range) strokes[i] = {range->least.value, range->greatest.value};
  }
  return strokes;
}

}  // namespace cognate::problems
