#include "problems/path/exact/starts.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/exact/designs.hpp"
#include "synthesis/exact/nine_point/nine_point.hpp"

namespace cognate::problems {
namespace {

constexpr std::size_t kExact = 9;

/// Indices of the points that differ from all before them.
std::vector<std::size_t> different(const std::vector<Vec2d>& points) {
  std::vector<std::size_t> indices;
  for (std::size_t j = 0; j < points.size(); ++j) {
    const auto earlier = points.begin() + static_cast<std::ptrdiff_t>(j);
    if (std::find(points.begin(), earlier, points[j]) == earlier) indices.push_back(j);
  }
  return indices;
}

/// Nine of the indices, spread over them.
std::vector<std::size_t> nine_of(const std::vector<std::size_t>& indices) {
  std::vector<std::size_t> nine;
  for (std::size_t k = 0; k < kExact; ++k) nine.push_back(indices[k * indices.size() / kExact]);
  return nine;
}

/// Crank angles at all `count` points from those at `kept`, which begin with 0, each step between
/// neighbours being less than half a turn.
std::vector<double> interpolated(const std::vector<double>& angles,
                                 const std::vector<std::size_t>& kept, std::size_t count) {
  std::vector<double> all(count);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const bool last = k + 1 == kept.size();
    const std::size_t to = last ? count : kept[k + 1];
    const double next = angles[last ? 0 : k + 1];
    const double step = std::remainder(next - angles[k], kTurn);
    for (std::size_t j = kept[k]; j < to; ++j) {
      all[j] = angles[k] + step * double(j - kept[k]) / double(to - kept[k]);
    }
  }
  return all;
}

}  // namespace

bool has_exact_starts(const PathProblem& problem) {
  const Given& g = problem.given;
  const Bounds& b = problem.bounds;
  const bool all_free = !g.crank && !g.coupler && !g.rocker && !g.frame && !g.frame_angle &&
                        !g.pivot_a && !g.pivot_d && !g.coupler_point;
  const auto limited = [](const std::optional<Range>& range) {
    return range && std::isfinite(range->max);
  };
  // Nine of many samples of a closed curve say little of it, and all of a circle have no finite set
  // of solutions.
  return !problem.constraints.full_turn && problem.timing == Timing::free && all_free &&
         !limited(b.crank) && !limited(b.coupler) && !limited(b.rocker) && !limited(b.frame) &&
         different(problem.points).size() >= kExact;
}

std::vector<PathStart> exact_starts(const PathProblem& problem, const Run& run,
                                    const Deadline& deadline) {
  const auto kept = nine_of(different(problem.points));
  PathProblem nine = problem;
  nine.points.clear();
  nine.weights.clear();
  for (const std::size_t j : kept) nine.points.push_back(problem.points[j]);
  const auto found = synthesis::solve_exact_path(
      positions_of(nine), {.threads = run.threads, .cache = run.cache, .stop = [&deadline] {
                             return deadline.reached();
                           }});
  if (found.status != synthesis::ExactPathStatus::solved) return {};
  const ExactRoots roots{found.system, found.roots, {}, synthesis::RootSymmetry::cognates, {}};
  std::vector<PathStart> starts;
  for (const TracedDesign& traced : designs_of(roots, nine, 0)) {
    if (!all_satisfied(traced.design.constraints)) continue;
    starts.push_back({four_bar(traced.design),
                      interpolated(traced.design.crank_angles, kept, problem.points.size()), false,
                      0});
  }
  return starts;
}

}  // namespace cognate::problems
