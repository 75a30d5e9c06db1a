/// The structural error of four-bars and slider-cranks; apart from that of chains, which the pages
/// compile too.
#include <cmath>
#include <variant>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/report/function_trace.hpp"
#include "problems/function/slider_generator.hpp"

namespace cognate::app {
namespace {

using ErrorAt = std::function<std::optional<double>(const synthesis::AnglePair&)>;

/// Of the rocker's angle; starts count from the frame, at the angle `frame`.
ErrorAt rocker_error(const problems::Design& design, double frame) {
  const double start = frame + *design.metrics.input_start;
  return [motion = Motion(problems::four_bar(design)), start,
          output_start = frame + *design.metrics.output_start](
             const synthesis::AnglePair& pair) -> std::optional<double> {
    const auto pose = motion.at(start + pair.input);
    if (!pose) return std::nullopt;
    return std::remainder(pose->rocker_angle - (output_start + pair.output), kTurn);
  };
}

/// Of the displacement of the slider; nothing of a design without a start of it.
ErrorAt slider_error(const problems::Design& design, const SliderCrank& mechanism) {
  const auto output_start =
      problems::find_quantity(design.metrics.quantities, problems::kSliderStartKey);
  if (!output_start) return nullptr;
  return [generator = problems::SliderGenerator{mechanism, *design.metrics.input_start,
                                                *output_start}](const synthesis::AnglePair& pair) {
    return problems::displacement_error(generator, pair);
  };
}

}  // namespace

FunctionTrace function_trace(const problems::FunctionProblem& problem,
                             const problems::FunctionSamples& wanted,
                             const problems::Design& design) {
  if (!design.metrics.input_start) return {};
  const auto* slider = std::get_if<SliderCrank>(&design.mechanism.description);
  const bool has_rocker = design.mechanism.four_bar() && design.metrics.output_start;
  const double frame = has_rocker ? frame_angle(four_bar(design)) : 0;
  ErrorAt error_at;
  if (slider != nullptr) error_at = slider_error(design, *slider);
  if (has_rocker) error_at = rocker_error(design, frame);
  if (!error_at) return {};
  return function_trace(std::get_if<problems::FunctionOfX>(&problem.target), wanted,
                        frame + *design.metrics.input_start, error_at);
}

}  // namespace cognate::app
