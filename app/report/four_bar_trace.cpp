/// The structural error of a four-bar; apart from that of chains, which the pages compile too.
#include <cmath>
#include <variant>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/report/function_trace.hpp"

namespace cognate::app {

FunctionTrace function_trace(const problems::FunctionProblem& problem,
                             const problems::FunctionSamples& wanted,
                             const problems::Design& design) {
  const auto &input_start = design.metrics.input_start, &output_start = design.metrics.output_start;
  if (!input_start || !output_start || !design.mechanism.four_bar()) return {};
  const double frame = frame_angle(four_bar(design)), start = frame + *input_start;
  const Motion motion(four_bar(design));
  const auto error_at = [&](const synthesis::AnglePair& pair) -> std::optional<double> {
    const auto pose = motion.at(start + pair.input);
    if (!pose) return std::nullopt;
    return std::remainder(pose->rocker_angle - (frame + *output_start + pair.output), kTurn);
  };
  return function_trace(std::get_if<problems::FunctionOfX>(&problem.target), wanted, start,
                        error_at);
}

}  // namespace cognate::app
