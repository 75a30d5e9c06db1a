#include "app/report/function_trace.hpp"

#include <cmath>
#include <variant>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::app {

FunctionTrace function_trace(const problems::FunctionProblem& problem,
                             const problems::FunctionSamples& wanted,
                             const problems::Design& design) {
  FunctionTrace trace;
  const auto &input_start = design.metrics.input_start, &output_start = design.metrics.output_start;
  if (!input_start || !output_start || !design.mechanism.four_bar()) return trace;
  const auto* function = std::get_if<problems::FunctionOfX>(&problem.target);
  const auto& pairs = function ? wanted.range : wanted.samples;
  const double frame = frame_angle(four_bar(design));
  const Motion motion(four_bar(design));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double crank = frame + *input_start + pairs[i].input;
    const auto pose = motion.at(crank);
    if (!pose) continue;
    const double output = frame + *output_start + pairs[i].output;
    if (function) {
      const double share = static_cast<double>(i) / static_cast<double>(pairs.size() - 1);
      trace.x.push_back(std::lerp(function->domain.min, function->domain.max, share));
    }
    trace.crank.push_back(crank);
    trace.error.push_back(std::remainder(pose->rocker_angle - output, kTurn));
  }
  return trace;
}

}  // namespace cognate::app
