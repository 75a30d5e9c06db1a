#include "problems/function_starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include "analysis/parallel.hpp"
#include "problems/dead_centre.hpp"
#include "problems/length_ranges.hpp"
#include "problems/link_ratios.hpp"
#include "synthesis/exact/chebyshev.hpp"
#include "synthesis/exact/function/four_bar_function.hpp"
#include "synthesis/search/function_fit.hpp"

namespace cognate::problems {
namespace {

using synthesis::AnglePair;

constexpr double kPi = std::numbers::pi;
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kScreened = 21;  ///< samples looked at, at most
constexpr int kGrid = 48;              ///< steps of each start angle over [0, π)
constexpr int kReweightings = 2;       ///< fits weighted by the slopes of the fit before
constexpr int kDrawsPerStart = 400;    ///< random proportions of which the best is kept

/// At most `kScreened` of the samples, in even steps, both ends among them.
std::vector<AnglePair> thinned(const std::vector<AnglePair>& samples) {
  if (samples.size() <= kScreened) return samples;
  std::vector<AnglePair> result;
  for (std::size_t i = 0; i < kScreened; ++i) {
    result.push_back(samples[i * (samples.size() - 1) / (kScreened - 1)]);
  }
  return result;
}

/// What all workers look up.
struct Screen {
  const FunctionProblem& problem;
  std::vector<AnglePair> wanted;
  std::array<Range, 4> ranges;

  std::vector<Assembly> assemblies() const {
    if (problem.given.assembly) return {*problem.given.assembly};
    return {Assembly::open, Assembly::crossed};
  }

  Lengths<double> within(const Lengths<double>& l) const {
    const auto clamp = [&](double value, int i) {
      return std::clamp(value, ranges[i].min, ranges[i].max);
    };
    return {clamp(l.crank, 0), clamp(l.coupler, 1), clamp(l.rocker, 2), clamp(l.frame, 3)};
  }

  bool fixed(int i) const { return ranges[i].min == ranges[i].max; }

  /// `links` in the unit of the lengths that are fixed, or of the bounds' middle.
  Lengths<double> scaled(const Lengths<double>& l) const {
    const std::array values{l.crank, l.coupler, l.rocker, l.frame};
    double factor = std::sqrt(ranges[0].min * ranges[0].max) / l.crank;
    for (const int i : {2, 1, 3, 0}) {
      if (fixed(i)) factor = ranges[i].min / values[i];
    }
    return within({factor * l.crank, factor * l.coupler, factor * l.rocker, factor * l.frame});
  }

  double clamped_start(double angle, const std::optional<Range>& bounds) const {
    if (!bounds) return angle;
    const double middle = 0.5 * (bounds->min + bounds->max);
    return std::clamp(middle + wrapped(angle - middle), bounds->min, bounds->max);
  }

  /// Completes the start angles that follow from the rest, and scores the generator.
  FunctionStartPoint scored(FunctionGenerator g) const {
    const FunctionStartPoint nothing{g, kInfinite};
    if (problem.start != FunctionStart::free) {
      const auto dead = dead_centre(g.links, g.assembly, problem.start);
      if (!dead) return nothing;
      g.input_start = dead->crank_angle;
      g.output_start = dead->rocker_angle;
    } else {
      g.input_start = clamped_start(g.input_start, problem.input_start_bounds);
      if (problem.output_start) {
        g.output_start = *problem.output_start;
      } else {
        const auto start = best_output_start(g, wanted);
        if (!start) return nothing;
        g.output_start = clamped_start(*start, problem.output_start_bounds);
      }
    }
    const double sum = StructuralError(g).sum_of_squares(wanted);
    return {g, sum / static_cast<double>(wanted.size())};
  }

  /// The assembly in which the linkage is the better one of two that were screened.
  void take_better(const synthesis::FunctionCandidates& candidates, std::size_t i,
                   const FunctionGenerator& generator, FunctionStartPoint& best) const {
    for (const Assembly assembly : assemblies()) {
      const double error = assembly == Assembly::open ? candidates.open[i] : candidates.crossed[i];
      if (!(error < best.error)) continue;
      best.error = error;
      best.generator = generator;
      best.generator.assembly = assembly;
    }
  }

  /// The better assembly of a linkage.
  FunctionStartPoint best_assembly(FunctionGenerator g) const {
    FunctionStartPoint best{g, kInfinite};
    for (const Assembly assembly : assemblies()) {
      g.assembly = assembly;
      const FunctionStartPoint point = scored(g);
      if (point.error < best.error) best = point;
    }
    return best;
  }
};

void set_candidate(synthesis::FunctionCandidates& candidates, std::size_t i,
                   const FunctionGenerator& g) {
  candidates.crank[i] = g.links.crank;
  candidates.coupler[i] = g.links.coupler;
  candidates.rocker[i] = g.links.rocker;
  candidates.frame[i] = g.links.frame;
  candidates.half_start_x[i] = std::cos(0.5 * g.input_start);
  candidates.half_start_y[i] = std::sin(0.5 * g.input_start);
}

/// The generator that some ratios of Freudenstein's equation stand for.
std::optional<FunctionGenerator> generator_of(const Screen& screen, const std::array<double, 3>& p,
                                              double input_start) {
  const auto linkage = synthesis::freudenstein_linkage(p);
  if (linkage.outcome != synthesis::FreudensteinOutcome::linkage) return std::nullopt;
  if (screen.problem.input_start && linkage.input_turn != 0) return std::nullopt;
  FunctionGenerator g;
  g.links = screen.scaled(linkage.links);
  g.input_start =
      screen.clamped_start(input_start + linkage.input_turn, screen.problem.input_start_bounds);
  return g;
}

/// For one start angle of the input and each of the output the linkage whose structural error is
/// about least; its output start angle is not yet set.
std::vector<FunctionStartPoint> fitted(const Screen& screen, double input_start,
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
  synthesis::fit_freudenstein(screen.wanted, kReweightings, starts);

  synthesis::FunctionCandidates candidates(padded);
  std::vector<std::optional<FunctionGenerator>> generators;
  for (std::size_t i = 0; i < padded; ++i) {
    const auto& [p0, p1, p2] = starts.ratios;
    generators.push_back(generator_of(screen, {p0[i], p1[i], p2[i]}, input_start));
    set_candidate(candidates, i, generators[i].value_or(FunctionGenerator{{1, 1, 1, 1}}));
  }
  synthesis::screen(screen.wanted, screen.problem.output_start, candidates);
  std::vector<FunctionStartPoint> points(count, {{}, kInfinite, StartOrigin::overlay});
  for (std::size_t i = 0; i < count; ++i) {
    if (generators[i]) screen.take_better(candidates, i, *generators[i], points[i]);
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
bool ratios_are_free(const Screen& screen) {
  return screen.problem.start == FunctionStart::free && !screen.fixed(1) && !screen.fixed(2) &&
         !(screen.fixed(0) && screen.fixed(3));
}

std::vector<FunctionStartPoint> freudenstein_starts(const Screen& screen, const StartSearch& search,
                                                    std::uint64_t& candidates) {
  if (!ratios_are_free(screen)) return {};
  std::mt19937_64 random(search.seed);
  std::uniform_real_distribution<double> shift(0, 1);
  const double first_shift = shift(random), second_shift = shift(random);
  const auto inputs = angles(screen.problem.input_start, first_shift);
  const auto outputs = angles(screen.problem.output_start, second_shift);
  const int rows = static_cast<int>(inputs.size()), columns = static_cast<int>(outputs.size());
  std::vector<FunctionStartPoint> grid(inputs.size() * outputs.size(),
                                       FunctionStartPoint{{}, kInfinite});
  parallel_for(rows, search.threads, [&](int i, int) {
    if (search.deadline && search.deadline->reached()) return;
    std::ranges::move(fitted(screen, inputs[i], outputs), grid.begin() + i * columns);
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
std::vector<FunctionStartPoint> five_point_starts(const Screen& screen) {
  const FunctionProblem& problem = screen.problem;
  const auto count = static_cast<double>(screen.wanted.size());
  if (!ratios_are_free(screen) || problem.input_start || problem.output_start || count < 5) {
    return {};
  }
  std::vector<synthesis::PrecisionPoint> points;
  for (const double place : synthesis::chebyshev_spacing(0, count - 1, 5)) {
    const AnglePair& pair = screen.wanted[static_cast<std::size_t>(std::lround(place))];
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
  Draws(const Screen& screen, std::uint64_t seed) : screen_(screen), random_(seed) {
    for (const Range& a : screen.ranges) {
      for (const Range& b : screen.ranges) largest_ = std::max(largest_, a.max / b.min);
    }
    largest_ = std::min(largest_, screen.problem.constraints.link_ratio_max.value_or(30));
  }

  FunctionGenerator next() {
    const FunctionProblem& problem = screen_.problem;
    FunctionGenerator g;
    g.links = screen_.scaled(random_ratios(random_, problem.constraints.required_class, largest_));
    g.input_start = problem.input_start.value_or(angle_(random_));
    return g;
  }

 private:
  const Screen& screen_;
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> angle_{-kPi, kPi};
  double largest_ = 1;
};

/// The best of some random linkages; in SIMD lanes, where the start angles do not follow from the
/// lengths.
FunctionStartPoint drawn(const Screen& screen, std::uint64_t seed) {
  Draws draws(screen, seed);
  FunctionStartPoint best{{}, kInfinite};
  if (screen.problem.start != FunctionStart::free) {
    for (int i = 0; i < kDrawsPerStart; ++i) {
      const FunctionStartPoint point = screen.best_assembly(draws.next());
      if (point.error < best.error) best = point;
    }
    return best;
  }
  static_assert(kDrawsPerStart % synthesis::FunctionCandidates::lanes == 0);
  synthesis::FunctionCandidates candidates(kDrawsPerStart);
  std::vector<FunctionGenerator> generators;
  for (std::size_t i = 0; i < kDrawsPerStart; ++i) {
    FunctionGenerator g = draws.next();
    g.input_start = screen.clamped_start(g.input_start, screen.problem.input_start_bounds);
    set_candidate(candidates, i, g);
    generators.push_back(g);
  }
  synthesis::screen(screen.wanted, screen.problem.output_start, candidates);
  for (std::size_t i = 0; i < kDrawsPerStart; ++i) {
    screen.take_better(candidates, i, generators[i], best);
  }
  return std::isfinite(best.error) ? screen.scored(best.generator) : best;
}

std::vector<FunctionStartPoint> random_starts(const Screen& screen, const StartSearch& search,
                                              std::uint64_t& candidates) {
  std::vector<FunctionStartPoint> starts(search.count, FunctionStartPoint{{}, kInfinite});
  parallel_for(search.count, search.threads, [&](int i, int) {
    if (search.deadline && search.deadline->reached()) return;
    starts[i] = drawn(screen, mixed(search.seed, i));
  });
  candidates += static_cast<std::uint64_t>(search.count) * kDrawsPerStart;
  std::erase_if(starts, [](const auto& start) { return !std::isfinite(start.error); });
  return starts;
}

}  // namespace

FoundStarts find_starts(const FunctionProblem& problem, const FunctionSamples& wanted,
                        const StartSearch& search) {
  const Screen screen{problem, thinned(wanted.samples), length_ranges(problem)};
  FoundStarts found;
  auto fits = freudenstein_starts(screen, search, found.candidates);
  auto exact = five_point_starts(screen);
  found.candidates += exact.size();
  fits.insert(fits.end(), exact.begin(), exact.end());
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
