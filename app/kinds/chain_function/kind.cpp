#include "app/kinds/chain_function/kind.hpp"

#include <fmt/core.h>

#include "app/console/messages.hpp"
#include "app/report/function_trace.hpp"
#include "problems/chain_function/space.hpp"

namespace cognate::app {
namespace {

using problems::ChainFunctionProblem;

constexpr Entry kChainFunctionKeys[] = {
    {"target.function", "an expression in x, as \"log10(x)\""},
    {"target.domain", "[x0, x1] of the function"},
    {"target.table", "or: [[x, y], ...]"},
    {"target.pairs_deg", "or: [[input, output], ...]"},
    {"target.input_range_deg", "the crank's sweep for the domain (negative: clockwise)"},
    {"target.output_range_deg", "the output's sweep for the values"},
    {"target.relation", "\"angles\": x and y are the angles themselves, in radians"},
    {"target.samples", "how many samples the error is taken at (default 61)"},
    {"target.sample_at", "or: their x"},
    {"target.objective", "\"least-squares\" (default) or \"minimax\""},
    {"target.pairs", "or, of a slider: [[input_deg, displacement], ...]"},
    {"target.output_range", "of a slider: its travel for the values"},
    {"target.output",
     "[\"G\", \"F\"] (default): the output's angle is that from G to F; of a chain also the name "
     "of a slider"},
    {"mechanism.type",
     "\"six-bar\", \"stephenson-3\", \"watt-2\", \"three-pin\", or \"chain\"; with a slider as "
     "output \"slider-crank\", \"six-bar-slider\", \"stephenson-3-slider\", \"watt-2-slider\"; "
     "parts and bounds as of path-generation (chains)"},
    {"constraints.transmission_angle_deg", "[min, max] of every dyad over the motion"},
    {"constraints.over",
     "\"range\" (default): the motion is that of the function; or \"turn\", of the whole crank"},
    {"constraints.rms_error_deg_max", "of the output's angle; with minimax max_error_deg_max"},
    {"constraints.rms_error_max", "of a slider's displacement; with minimax max_error_max"},
    {"solve.objectives",
     "[\"error\", and one of \"transmission_angle\", of a slider \"size\"]: a Pareto front"}};

constexpr QuantityColumn kChainFunctionQuantities[] = {{"longest_link", "longest link [length]"},
                                                       {"topology", "topology"},
                                                       {"output_start", "output start [length]"}};

}  // namespace

std::span<const Entry> Kind<ChainFunctionProblem>::keys() {
  return kChainFunctionKeys;
}

std::string Kind<ChainFunctionProblem>::describe(const ChainFunctionProblem& problem) {
  const auto wanted = [&] {
    if (const auto* pairs = std::get_if<problems::AnglePairs>(&problem.target)) {
      return fmt::format("{} pairs", pairs->size());
    }
    const auto& function = std::get<problems::FunctionOfX>(problem.target);
    return function.text.empty() ? fmt::format("a table of {} points", function.table.size())
                                 : "y = " + function.text;
  };
  return titled(problem.title,
                fmt::format("function generation ({}), {}", problem.mechanism, wanted()));
}

ColumnChoice Kind<ChainFunctionProblem>::columns(const ChainFunctionProblem& problem) {
  const bool slides = problems::slides(problem);
  return {.error_unit = slides ? "length" : "deg",
          .angular_output = !slides,
          .quantities = kChainFunctionQuantities};
}

nlohmann::ordered_json Kind<ChainFunctionProblem>::target_json(
    const ChainFunctionProblem& /*problem*/) {
  return {{"kind", "function"}};
}

nlohmann::ordered_json Kind<ChainFunctionProblem>::reached_json(const ChainFunctionProblem& problem,
                                                                const problems::Design& design) {
  return {{"trace", trace_json(function_trace(problem, design), problems::slides(problem))}};
}

}  // namespace cognate::app
