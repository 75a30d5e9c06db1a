#include "synthesis/exact/nine_point/constrained_path.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "analysis/numbers/parallel.hpp"
#include "synthesis/exact/nine_point/generic_set.hpp"
#include "synthesis/exact/nine_point/path_system.hpp"

namespace cognate::synthesis {
namespace {

using namespace constrained;

/// Rounding of the data moves a root of such condition by its own size.
constexpr double kSingular = 1e15;
/// Beyond, a linkage is not distinguished from one that misses its points.
constexpr double kMissed = 1e-9;

Data data_of(const PathSystem& system, std::vector<SideCondition> conditions) {
  Data data;
  data.d = system.d;
  data.t = system.t;
  for (const Complex& d : system.d) data.d_bar.push_back(std::conj(d));
  data.conditions = std::move(conditions);
  return data;
}

/// The same solution of the conjugate problem, with plain and barred unknowns exchanged.
State conjugate(const State& state) {
  State image = state;
  for (std::size_t i = 0; i < image.pivots.size(); ++i) {
    image.pivots[i] = std::conj(state.pivots[i ^ 1]);
  }
  for (Complex& z : image.log_t) z = -std::conj(z);  // t → 1/t̄
  return image;
}

/// The mean of a state and its conjugate: a linkage of the real plane.
State made_real(State state) {
  for (std::size_t i = 0; i < state.pivots.size(); i += 2) {
    state.pivots[i] = 0.5 * (state.pivots[i] + std::conj(state.pivots[i + 1]));
    state.pivots[i + 1] = std::conj(state.pivots[i]);
  }
  for (Complex& z : state.log_t) z = Complex(0, z.imag());
  return state;
}

PathRoot root_of(const State& state, const Data& data) {
  const auto& u = state.pivots;
  PathRoot root{{u[0], u[1], u[2], u[3]}, {u[4], u[5], u[6], u[7]}, data.t};
  for (const Complex& z : state.log_t) root.rotations.push_back(std::exp(z));
  const Quality known = quality(state, data);
  root.residual = known.residual;
  root.condition = known.condition;
  return root;
}

/// All paths, followed; those without a finite end, and those that ended where another did, a
/// second time with more digits and shorter steps: large pivots, as of short arcs, look like
/// infinite ones. `stopped`: there was no time for one.
std::vector<TrackedPath> follow_all(const GenericSet& set, const Data& data,
                                    const ConstrainedPathOptions& options,
                                    std::atomic<bool>& stopped) {
  std::vector<TrackedPath> paths(set.states.size());
  std::atomic<int> done{0};
  const auto run = [&](std::size_t i, const TrackingTolerances& care) {
    if (stopped || (options.stop && options.stop())) {
      stopped = true;
      return;
    }
    paths[i] = follow(set.states[i], set.data, data, care);
  };
  parallel_for(int(paths.size()), options.threads, [&](int i, int thread) {
    run(std::size_t(i), {});
    const int now = ++done;
    if (thread == 0 && options.progress) options.progress(double(now) / double(paths.size()));
  });
  std::vector<std::size_t> again;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    bool repeat = paths[i].end != PathEnd::finite;
    for (std::size_t k = 0; k < paths.size() && !repeat; ++k) {
      repeat = k != i && paths[i].end == PathEnd::finite && paths[k].end == PathEnd::finite &&
               are_same(paths[i].state, paths[k].state);
    }
    if (repeat) again.push_back(i);
  }
  parallel_for(int(again.size()), options.threads, [&](int i, int) {
    run(again[std::size_t(i)], {0.01, 1e-6, true});
  });
  return paths;
}

/// Whether a state is its own conjugate as far as its digits show: within the tolerance of
/// are_same(), and no other state is. (Ill-conditioned roots, as those of short arcs, have few
/// digits; certificates decide.)
std::vector<bool> find_real(const std::vector<State>& states) {
  std::vector<bool> real;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const State image = conjugate(states[i]);
    const auto is_other = [&](const State& other) {
      return &other != &states[i] && are_same(image, other);
    };
    real.push_back(are_same(image, states[i]) && std::ranges::none_of(states, is_other));
  }
  return real;
}

/// The distinct states at the ends of paths; the other ends are counted.
std::vector<State> distinct_ends(const std::vector<TrackedPath>& paths, ExactPathSolutions& into) {
  std::vector<State> known;
  for (const TrackedPath& path : paths) {
    into.at_infinity += path.end == PathEnd::infinite;
    into.lost += path.end == PathEnd::lost;
    if (path.end != PathEnd::finite) continue;
    if (std::ranges::any_of(known, [&](const State& s) { return are_same(s, path.state); })) {
      ++into.duplicates;
    } else {
      known.push_back(path.state);
    }
  }
  return known;
}

void collect(const std::vector<TrackedPath>& paths, const Data& data, ExactPathSolutions& into) {
  const std::vector<State> states = distinct_ends(paths, into);
  const std::vector<bool> real = find_real(states);
  for (std::size_t i = 0; i < states.size(); ++i) {
    PathRoot root = root_of(real[i] ? made_real(states[i]) : states[i], data);
    if (!(root.condition < kSingular && root.residual < kMissed)) {
      ++into.singular;
      continue;
    }
    root.real = real[i];
    into.roots.push_back(std::move(root));
  }
  into.finite = int(into.roots.size());
  std::ranges::stable_partition(into.roots, [](const PathRoot& root) { return root.real; });
}

}  // namespace

bool are_independent(const PathClass& kind, const FixedParts& given) {
  const int count = 2 * (kind.poses - 1) + kind.points + condition_count(given);
  return count <= kPivotUnknowns && generic_rank(kind, given) == count;
}

ConstrainedPathSolutions solve_constrained_path(std::span<const PathPose> positions,
                                                const FixedParts& given,
                                                const ConstrainedPathOptions& options) {
  ConstrainedPathSolutions result;
  ExactPathSolutions& solutions = result.solutions;
  const PathClass kind = class_of(positions);
  solutions.status = ExactPathStatus::wrong_count;
  if (2 * (kind.poses - 1) + kind.points + condition_count(given) != 8) return result;
  auto made = nine_point::make_system(positions, nine_point::Count::any);
  solutions.status = made.status;
  solutions.coincident = made.coincident;
  solutions.system = std::move(made.system);
  if (solutions.status != ExactPathStatus::solved) return result;
  solutions.status = ExactPathStatus::dependent;
  if (!are_independent(kind, given)) return result;
  result.conditions = side_conditions(given, solutions.system);

  const auto part_of_progress = [&](double from, double to) -> std::function<void(double)> {
    if (!options.progress) return {};
    return [&options, from, to](double share) { options.progress(from + share * (to - from)); };
  };
  constexpr double kGenericShare = 0.9;
  const auto set = generic_set(
      kind, given,
      {options.threads, options.stop, part_of_progress(0, kGenericShare), options.cache});
  solutions.status = ExactPathStatus::interrupted;
  if (!set) return result;
  result.settled = set->settled;
  solutions.tracked = int(set->states.size());
  const Data data = data_of(solutions.system, result.conditions);
  ConstrainedPathOptions to_data = options;
  to_data.progress = part_of_progress(kGenericShare, 1);
  std::atomic<bool> stopped{false};
  collect(follow_all(*set, data, to_data, stopped), data, solutions);
  if (!stopped) solutions.status = ExactPathStatus::solved;
  return result;
}

}  // namespace cognate::synthesis
