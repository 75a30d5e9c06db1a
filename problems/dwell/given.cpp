#include "problems/dwell/given.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "problems/chain/given.hpp"
#include "problems/dwell/verify.hpp"

namespace cognate::problems {
namespace {

constexpr int kSteps = 360;  ///< of the crank, at which dwells are tried
constexpr double kStep = kTurn / kSteps;
constexpr int kBeginningSteps = 30;

double angle(int step) {
  return kStep * step;
}

/// Of a dwell the band of the output from each step on, and its middle.
struct Bands {
  std::vector<double> width, middle;

  Bands(const std::vector<double>& output, double over) {
    const int steps = static_cast<int>(std::lround(over / kStep));
    const double turn = output[kSteps] - output[0];
    for (int from = 0; from < kSteps; ++from) {
      double least = std::numeric_limits<double>::infinity(), greatest = -least;
      for (int step = from; step <= from + steps; ++step) {
        const double here =
            output[static_cast<std::size_t>(step % kSteps)] + (step >= kSteps ? turn : 0);
        least = std::min(least, here);
        greatest = std::max(greatest, here);
      }
      width.push_back(greatest - least);
      middle.push_back(0.5 * (least + greatest));
    }
  }
};

/// The steps at which a dwell may begin.
std::vector<int> beginnings(const Dwell& dwell) {
  if (dwell.from) return {static_cast<int>(std::lround(*dwell.from / kStep) % kSteps)};
  std::vector<int> all(kSteps);
  for (int i = 0; i < kSteps; ++i) all[static_cast<std::size_t>(i)] = i;
  return all;
}

/// Whether the second dwell follows the first and ends before that begins anew.
bool follows(const DwellProblem& problem, int first, int second) {
  const double between = angle((second - first + kSteps) % kSteps);
  return between >= problem.dwells[0].over && between + problem.dwells[1].over <= kTurn;
}

/// The steps at which the dwells begin of which the widest band is narrowest; levels that are not
/// as far apart as they must be are as bad as what they lack.
std::vector<int> narrowest(const DwellProblem& problem, const std::vector<Bands>& bands) {
  double least = std::numeric_limits<double>::infinity();
  std::vector<int> best;
  const auto take = [&](double band, std::vector<int> steps) {
    if (!(band < least)) return;
    least = band;
    best = std::move(steps);
  };
  for (const int i : beginnings(problem.dwells[0])) {
    const auto first = static_cast<std::size_t>(i);
    if (bands.size() == 1) {
      take(bands[0].width[first], {i});
      continue;
    }
    for (const int j : beginnings(problem.dwells[1])) {
      const auto second = static_cast<std::size_t>(j);
      if (!follows(problem, i, j)) continue;
      const double apart = std::abs(bands[1].middle[second] - bands[0].middle[first]);
      const double lacking = std::max(0.0, problem.apart.value_or(0) - apart);
      take(std::max(bands[0].width[first], bands[1].width[second]) + lacking, {i, j});
    }
  }
  return best;
}

}  // namespace

bool is_given(const DwellProblem& problem) {
  return problem.topologies.size() == 1 && is_given(problem.topologies.front()) && !problem.raster;
}

std::optional<Design> given_design(const DwellProblem& problem) {
  const Topology& topology = problem.topologies.front();
  const NamedMechanism mechanism = given_mechanism(topology);
  const auto output = output_over_turn(problem, mechanism, kSteps);
  if (output.empty()) return std::nullopt;
  std::vector<Bands> bands;
  for (const Dwell& dwell : problem.dwells) bands.emplace_back(output, dwell.over);
  std::vector<double> starts;
  for (const int step : narrowest(problem, bands)) {
    const Dwell& dwell = problem.dwells[starts.size()];
    const auto band = [&](double start) { return half_band(problem, mechanism, dwell, start); };
    const auto found = golden_section(band, angle(step - 1), angle(step + 1), kBeginningSteps);
    starts.push_back(dwell.from.value_or(found.middle()));
  }
  if (starts.empty()) return std::nullopt;
  Design design = verified(problem, topology, mechanism, starts);
  if (!std::isfinite(design.error.sum_of_squares)) return std::nullopt;
  design.origin = "given";
  return design;
}

}  // namespace cognate::problems
