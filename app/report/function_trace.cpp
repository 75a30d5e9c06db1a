#include "app/report/function_trace.hpp"

#include <cmath>
#include <variant>

#include "analysis/numbers/constants.hpp"
#include "app/report/report_data.hpp"
#include "problems/chain_function/space.hpp"
#include "problems/chain_function/verify.hpp"

namespace cognate::app {
namespace {

nlohmann::ordered_json rounded(const std::vector<double>& values, double unit = 1) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const double value : values) list.push_back(round_to_digits(unit * value, kDrawnDigits));
  return list;
}

nlohmann::ordered_json rounded_degrees(const std::vector<double>& angles) {
  return rounded(angles, kDegreesInRadian);
}

}  // namespace

FunctionTrace function_trace(
    const problems::FunctionOfX* function, const problems::FunctionSamples& wanted, double start,
    const std::function<std::optional<double>(const synthesis::AnglePair&)>& error_at) {
  FunctionTrace trace;
  const auto& pairs = function ? wanted.range : wanted.samples;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto error = error_at(pairs[i]);
    if (!error) continue;
    if (function) {
      const double share = static_cast<double>(i) / static_cast<double>(pairs.size() - 1);
      trace.x.push_back(std::lerp(function->domain.min, function->domain.max, share));
    }
    trace.crank.push_back(start + pairs[i].input);
    trace.error.push_back(*error);
  }
  return trace;
}

FunctionTrace function_trace(const problems::ChainFunctionProblem& problem,
                             const problems::Design& design) {
  const auto wanted = problems::function_samples(problem);
  const double start = *design.metrics.input_start;
  const problems::ChainFunctionError error(problem, wanted, design.mechanism, start);
  const auto error_at = [&](const synthesis::AnglePair& pair) {
    const double here = error.at(pair);
    return std::isfinite(here) ? std::optional(here) : std::nullopt;
  };
  return function_trace(std::get_if<problems::FunctionOfX>(&problem.target), wanted, start,
                        error_at);
}

nlohmann::ordered_json trace_json(const FunctionTrace& trace, bool slides) {
  using nlohmann::ordered_json;
  ordered_json table{{"x", trace.x.empty() ? ordered_json(nullptr) : rounded(trace.x)},
                     {"crank_deg", rounded_degrees(trace.crank)}};
  table[slides ? "error" : "error_deg"] =
      slides ? rounded(trace.error) : rounded_degrees(trace.error);
  return table;
}

}  // namespace cognate::app
