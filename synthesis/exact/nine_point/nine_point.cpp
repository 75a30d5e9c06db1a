#include "synthesis/exact/nine_point/nine_point.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/exact/nine_point/follow.hpp"
#include "synthesis/exact/nine_point/path_system.hpp"
#include "synthesis/exact/nine_point/progress.hpp"
#include "synthesis/exact/nine_point/real_roots.hpp"
#include "synthesis/exact/nine_point/start_cache.hpp"

namespace cognate::synthesis {

using namespace nine_point;

namespace {

PathRoot to_root(const PathSystem& system, const RealRoot& found) {
  const auto z = [&](int i) { return number(found.numbers[i]); };
  PathRoot root{{z(0), z(1), z(2), z(3)}, {z(4), z(5), z(6), z(7)}, system.t};
  for (std::size_t i = kPivots; i < found.numbers.size(); ++i) {
    root.rotations.push_back(number(found.numbers[i]));
  }
  root.residual = found.quality.residual;
  root.condition = found.quality.condition;
  root.real = found.real;
  return root;
}

}  // namespace

ExactPathSolutions solve_exact_path(std::span<const PathPose> positions,
                                    const ExactPathOptions& options) {
  ExactPathSolutions solutions;
  SystemOrStatus made = make_system(positions);
  solutions.status = made.status;
  solutions.coincident = made.coincident;
  solutions.system = std::move(made.system);
  if (solutions.status != ExactPathStatus::solved) return solutions;

  StopToken stop(options.stop);
  TrackingOptions means;
  means.threads = options.threads;
  means.set = options.set;
  means.stop = &stop;
  const auto set = start_set(solutions.system.kind, options.cache, means);
  solutions.status = ExactPathStatus::interrupted;
  if (!set) return solutions;
  solutions.tracked = known_count(solutions.system.kind);

  Progress progress(options.progress, set->count());
  means.done = [&](int) { progress.advance(); };
  const PathParameters data = parameters_of(solutions.system);
  FollowedPaths paths = follow(*set, data, means);
  means.done = nullptr;
  std::vector<RealRoot> roots = find_real_roots(paths, data, means);
  for (const RealRoot& root : roots) solutions.roots.push_back(to_root(solutions.system, root));
  solutions.finite = static_cast<int>(roots.size());
  solutions.at_infinity = paths.at_infinity;
  solutions.singular = paths.singular;
  solutions.lost = paths.lost;
  solutions.duplicates = paths.duplicates;
  solutions.repeated = paths.repeated;
  if (!paths.stopped) solutions.status = ExactPathStatus::solved;
  return solutions;
}

std::array<PathRoot, 3> cognates(const PathSystem& system, const PathRoot& root) {
  const PathParameters data = parameters_of(system);
  RootNumbers numbers;
  for (const auto* dyad : {&root.first, &root.second}) {
    for (const auto& z : {dyad->moving, dyad->moving_bar, dyad->fixed, dyad->fixed_bar}) {
      numbers.push_back(pair(z));
    }
  }
  for (const auto& t : root.rotations) numbers.push_back(pair(t));
  std::array<PathRoot, 3> all{root, root, root};
  for (int i = 1; i < 3; ++i) {
    numbers = next_cognate(data, numbers);
    all[i] = to_root(system, {numbers, {root.condition, 0, root.residual}, root.real});
  }
  return all;
}

}  // namespace cognate::synthesis
