#include "problems/function/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/function/screen.hpp"
#include "problems/linkage/link_ratios.hpp"
#include "synthesis/exact/chebyshev.hpp"
#include "synthesis/exact/function/four_bar_function.hpp"
#include "synthesis/lanes/function_fit.hpp"

namespace cognate::problems {
namespace {

using synthesis::AnglePair;

constexpr std::size_t kScreened = 21;  ///< samples looked at, at most
constexpr int kGrid = 48;              ///< steps of each start angle over [0, π)
constexpr int kReweightings = 2;       ///< fits weighted by the slopes of the fit before
constexpr int kDrawsPerStart = 400;    ///< random proportions of which the best is kept

/// At most `kScreened` of the samples, in even steps, both ends among them.
std::vector<AnglePair> coarsened(const std::vector<AnglePair>& samples) {
  if (samples.size() <= kScreened) return samples;
  std::vector<AnglePair> result;
  for (std::size_t i = 0; i < kScreened; ++i) {
    result.push_back(samples[i * (samples.size() - 1) / (kScreened - 1)]);
  }
  return result;
}

/// The generator that some ratios of Freudenstein's equation stand for.
std::optional<FunctionGenerator> generator_of(const FunctionScreen& screen,
                                              const std::array<double, 3>& p, double input_start) {
  const auto linkage = synthesis::freudenstein_linkage(p);
  if (linkage.outcome != synthesis::FreudensteinOutcome::linkage) return std::nullopt;
  if (screen.problem().input_start && linkage.input_turn != 0) return std::nullopt;
  FunctionGenerator g;
  g.links = screen.scaled(linkage.links);
  g.input_start = input_start + linkage.input_turn;
  return screen.started(g).front();
}

/// For one start angle of the input and each of the output the linkage whose structural error is
/// about least; its output start angle is not yet set.
std::vector<FunctionStartPoint> fitted(const FunctionScreen& screen, double input_start,
                                       const std::vector<double>& output_starts) {
  const std::size_t count = output_starts.size(), lanes = synthesis::StartAngles::lanes;
  const std::size_t padded = (count + lanes - 1) / lanes * lanes;
  synthesis::StartAngles starts(padded);
  for (std::size_t i = 0; i < padded; ++i) {
    const double output_start = output_starts[std::min(i, count - 1)];
    starts.input_x[i] = std::cos(input_start);
    starts.input_y[i] = std::sin(input_start);
    starts.output_x[i] = std::cos(output_start);
    starts.output_y[i] = std::sin(output_start);
  }
  synthesis::fit_freudenstein(screen.wanted(), kReweightings, starts);

  const auto& [p0, p1, p2] = starts.ratios;
  std::vector<std::size_t> cells;
  std::vector<FunctionGenerator> generators;
  for (std::size_t i = 0; i < count; ++i) {
    const auto generator = generator_of(screen, {p0[i], p1[i], p2[i]}, input_start);
    if (!generator) continue;
    cells.push_back(i);
    generators.push_back(*generator);
  }
  std::vector<FunctionStartPoint> points(count, {{}, kInfinity, StartOrigin::overlay});
  const std::vector<FunctionStartPoint> screened = screen.screened(generators);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    points[cells[k]].generator = screened[k].generator;
    points[cells[k]].error = screened[k].error;
  }
  return points;
}

/// The angles at which a start angle is looked at: one where the file gives it, else steps over
/// half a turn (the other half gives the same linkages turned), shifted at random.
std::vector<double> angles(const std::optional<double>& given, double shift) {
  if (given) return {*given};
  std::vector<double> result;
  for (int i = 0; i < kGrid; ++i) result.push_back(kPi * (i + shift) / kGrid);
  return result;
}

/// Local minima over the grid of start angles, neighbours across its edges included.
std::vector<FunctionStartPoint> grid_minima(const std::vector<FunctionStartPoint>& grid, int rows,
                                            int columns) {
  const auto at = [&](int i, int j) -> const FunctionStartPoint& {
    return grid[((i + rows) % rows) * columns + (j + columns) % columns];
  };
  std::vector<FunctionStartPoint> minima;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const double error = at(i, j).error;
      bool least = std::isfinite(error);
      for (int k = 0; least && k < 9; ++k) {
        least = at(i + k / 3 - 1, j + k % 3 - 1).error >= error;
      }
      if (least) minima.push_back(at(i, j));
    }
  }
  return minima;
}

/// Whether the equation's three ratios are all free: then lengths follow from start angles.
bool ratios_are_free(const FunctionScreen& screen) {
  return screen.problem().start == FunctionStart::free && !screen.fixed(1) && !screen.fixed(2) &&
         !(screen.fixed(0) && screen.fixed(3));
}

std::vector<FunctionStartPoint> freudenstein_starts(const FunctionScreen& screen,
                                                    const StartSearch& search,
                                                    std::uint64_t& candidates) {
  if (!ratios_are_free(screen)) return {};
  std::mt19937_64 random(search.seed);
  std::uniform_real_distribution<double> shift(0, 1);
  const double first_shift = shift(random), second_shift = shift(random);
  const auto inputs = angles(screen.problem().input_start, first_shift);
  const auto outputs = angles(screen.problem().output_start, second_shift);
  const int rows = static_cast<int>(inputs.size()), columns = static_cast<int>(outputs.size());
  std::vector<FunctionStartPoint> grid(inputs.size() * outputs.size(),
                                       FunctionStartPoint{{}, kInfinity});
  parallel_for(rows, search.threads, [&](int i, int) {
    if (search.deadline && search.deadline->reached()) return;
    std::ranges::move(fitted(screen, inputs[i], outputs),
                      grid.begin() + static_cast<std::ptrdiff_t>(i) * columns);
  });
  candidates += grid.size();
  std::vector<FunctionStartPoint> starts;
  for (const FunctionStartPoint& minimum : grid_minima(grid, rows, columns)) {
    starts.push_back(screen.scored(minimum.generator));
    starts.back().origin = minimum.origin;
  }
  std::erase_if(starts, [](const auto& start) { return !std::isfinite(start.error); });
  return starts;
}

/// The linkages through five samples about where Chebyshev's points lie, where no start is given.
std::vector<FunctionStartPoint> five_point_starts(const FunctionScreen& screen) {
  const FunctionProblem& problem = screen.problem();
  const auto count = static_cast<double>(screen.wanted().size());
  if (!ratios_are_free(screen) || problem.input_start || problem.output_start || count < 5) {
    return {};
  }
  std::vector<synthesis::PrecisionPoint> points;
  for (const double place : synthesis::chebyshev_spacing(0, count - 1, 5)) {
    const AnglePair& pair = screen.wanted()[static_cast<std::size_t>(std::lround(place))];
    points.push_back({.input = pair.input, .output = {pair.output}});
  }
  std::vector<FunctionStartPoint> starts;
  for (const auto& solution : synthesis::four_bar_functions(points, {}).solutions) {
    if (solution.outcome != synthesis::FourBarOutcome::linkage) continue;
    FunctionGenerator g;
    g.links = screen.scaled(solution.links);
    g.input_start = solution.input_start;
    g.output_start = solution.output_start;
    FunctionStartPoint point = screen.best_assembly(g);
    point.origin = StartOrigin::five_points;
    if (std::isfinite(point.error)) starts.push_back(point);
  }
  return starts;
}

std::uint64_t mixed(std::uint64_t seed, std::uint64_t index) {
  return (seed + 1) * 0x9E3779B97F4A7C15u ^ (index + 1) * 0xD1B54A32D192ED03u;
}

/// Random linkages, with the start angle of their input.
class Draws {
 public:
  Draws(const FunctionScreen& screen, std::uint64_t seed) : screen_(screen), random_(seed) {
    for (const Range& a : screen.ranges()) {
      for (const Range& b : screen.ranges()) largest_ = std::max(largest_, a.max / b.min);
    }
    largest_ = std::min(largest_, screen.problem().constraints.link_ratio_max.value_or(30));
  }

  FunctionGenerator next() {
    const FunctionProblem& problem = screen_.problem();
    FunctionGenerator g;
    g.links = screen_.scaled(random_ratios(random_, problem.constraints.required_class, largest_));
    g.input_start = problem.input_start.value_or(angle_(random_));
    return g;
  }

 private:
  const FunctionScreen& screen_;
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> angle_{-kPi, kPi};
  double largest_ = 1;
};

/// The best of some random linkages.
FunctionStartPoint drawn(const FunctionScreen& screen, std::uint64_t seed) {
  Draws draws(screen, seed);
  std::vector<FunctionGenerator> generators;
  for (int i = 0; i < kDrawsPerStart; ++i) {
    for (const FunctionGenerator& g : screen.started(draws.next())) generators.push_back(g);
  }
  const auto points = screen.screened(generators);
  const auto best = std::ranges::min_element(points, {}, &FunctionStartPoint::error);
  const bool any = best != points.end() && std::isfinite(best->error);
  return any ? screen.scored(best->generator) : FunctionStartPoint{{}, kInfinity};
}

std::vector<FunctionStartPoint> random_starts(const FunctionScreen& screen,
                                              const StartSearch& search,
                                              std::uint64_t& candidates) {
  std::vector<FunctionStartPoint> starts(search.count, FunctionStartPoint{{}, kInfinity});
  parallel_for(search.count, search.threads, [&](int i, int) {
    if (search.deadline && search.deadline->reached()) return;
    starts[i] = drawn(screen, mixed(search.seed, search.first + i));
  });
  candidates += static_cast<std::uint64_t>(search.count) * kDrawsPerStart;
  std::erase_if(starts, [](const auto& start) { return !std::isfinite(start.error); });
  return starts;
}

}  // namespace

FunctionStarts find_starts(const FunctionProblem& problem, const FunctionSamples& wanted,
                           const StartSearch& search) {
  const FunctionScreen screen(problem, coarsened(wanted.samples));
  FunctionStarts found;
  std::vector<FunctionStartPoint> fits;
  if (search.first == 0) {
    fits = freudenstein_starts(screen, search, found.candidates);
    const auto exact = five_point_starts(screen);
    found.candidates += exact.size();
    fits.insert(fits.end(), exact.begin(), exact.end());
  }
  auto draws = random_starts(screen, search, found.candidates);
  for (auto* kind : {&fits, &draws}) {
    std::ranges::stable_sort(*kind, {}, &FunctionStartPoint::error);
  }
  for (std::size_t i = 0; i < std::max(fits.size(), draws.size()); ++i) {
    for (const auto* kind : {&fits, &draws}) {
      const bool room = found.starts.size() < static_cast<std::size_t>(search.count);
      if (i < kind->size() && room) found.starts.push_back((*kind)[i]);
    }
  }
  return found;
}

}  // namespace cognate::problems
