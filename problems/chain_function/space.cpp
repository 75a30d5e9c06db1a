#include "problems/chain_function/space.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

constexpr int kCoarsePairs = 25;

OutputFrame frame_of(const ChainFunctionProblem& problem, const FunctionSamples& wanted) {
  if (!slides(problem)) return {};
  const auto [least, greatest] =
      std::ranges::minmax(wanted.samples, {}, &synthesis::AnglePair::output);
  const double swing = greatest.output - least.output;
  return {.keeps_size = true, .size = swing > 0 ? swing : 1};
}

void scale_outputs(std::vector<synthesis::AnglePair>& pairs, double factor) {
  for (synthesis::AnglePair& pair : pairs) pair.output *= factor;
}

/// At Chebyshev–Lobatto places of the domain, or of many pairs as many at even distances.
std::vector<synthesis::AnglePair> coarse_pairs(const FunctionSamples& wanted) {
  std::vector<synthesis::AnglePair> pairs;
  const auto most = static_cast<int>(wanted.samples.size());
  if (!wanted.at && most <= kCoarsePairs) return wanted.samples;
  for (int i = 0; i < kCoarsePairs; ++i) {
    const double share = double(i) / (kCoarsePairs - 1);
    const auto index = static_cast<std::size_t>(std::lround(share * (most - 1)));
    pairs.push_back(wanted.at ? wanted.at(0.5 - 0.5 * std::cos(kPi * share))
                              : wanted.samples[index]);
  }
  return pairs;
}

}  // namespace

FunctionSamples function_samples(const ChainFunctionProblem& problem) {
  FunctionProblem same;
  same.target = problem.target;
  same.objective = problem.objective;
  same.sample_at = problem.sample_at;
  return function_samples(same);
}

ChainFunctionSpace::ChainFunctionSpace(const ChainFunctionProblem& of, const Topology& given,
                                       const FunctionSamples& wanted)
    : OutputSpace(given, of.output, of.constraints.transmission_angle, frame_of(of, wanted)),
      coarse(coarse_pairs(wanted)),
      fine(wanted.samples),
      sweep(wanted.sweep),
      is_minimax(of.objective == FunctionObjective::minimax),
      needs_turn(of.constraints.over == LimitSpan::turn) {
  std::ranges::stable_sort(coarse, {}, &synthesis::AnglePair::input);
  if (!slides()) return;
  scale_outputs(coarse, 1 / scale.size);
  scale_outputs(fine, 1 / scale.size);
}

CrankSpan ChainFunctionSpace::span(double start) const {
  if (needs_turn) return {start, start + kTurn};
  return {start + sweep.min, start + sweep.max};
}

double ChainFunctionSpace::output_at(double input) const {
  const auto after = std::ranges::upper_bound(coarse, input, {}, &synthesis::AnglePair::input);
  if (after == coarse.begin()) return coarse.front().output;
  if (after == coarse.end()) return coarse.back().output;
  const auto& [x0, y0] = *std::prev(after);
  return std::lerp(y0, after->output, (input - x0) / (after->input - x0));
}

}  // namespace cognate::problems
