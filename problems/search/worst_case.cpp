/// The worst case over the tolerances: minimax over the corners of their box, of which only those
/// take part that are among the worst somewhere on the way.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

#include "problems/search/perturbations.hpp"
#include "problems/search/robust_criterion.hpp"
#include "synthesis/optimise/solver.hpp"
#include "synthesis/robust/worst_case_model.hpp"

namespace cognate::problems {
namespace {

using synthesis::SampledError;

/// Newton steps of a crank that follows, in the search and for what is reported.
constexpr int kCornerFollow = 1, kLevelFollow = 3;
/// Values of each dimension: the corners of the box, and with the middles of its edges and faces.
constexpr std::size_t kCorners = 2, kLevels = 3;
/// Exchanges at most, and by how much a corner may exceed those that take part at the end.
constexpr int kExchanges = 16;
constexpr double kExceeds = 1e-9;
/// Corners whose error is less than the worst by no more than this share take part at once.
constexpr double kNearWorst = 0.05;
constexpr int kWorstCaseIterations = 60;
/// Violations of constraints, as models scale them, that are none.
constexpr double kWithinLimits = 1e-8;

class WorstCaseCriterion final : public RobustCriterion {
 public:
  WorstCaseCriterion(const RobustTask& task, const Deadline& deadline)
      : task_(task), deadline_(deadline) {}

  double seen(const RobustStart& start, std::span<const double> x) const override {
    return worst_of(errors(start, x, kCorners, kCornerFollow));
  }

  std::vector<double> descend(const RobustStart& start, std::vector<double> x,
                              std::optional<double> most) const override {
    std::vector<double> best = x;
    std::vector<SampledError> chosen;
    // A bound on the nominal error may exclude where the descent begins.
    double least = seen(start, x);
    if (!std::isfinite(least)) return best;
    if (most) least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kExchanges && !deadline_.reached(); ++round) {
      const auto all = errors(start, x, kCorners, kCornerFollow);
      if (!exchange(all, chosen)) break;
      // Corners that took no part may not be assembled there: with them it begins again.
      if (!std::isfinite(worst_of(all))) x = best;
      const auto [end, value] = least_of_chosen(start, x, most, chosen);
      if (end.empty()) break;
      x = end;
      const double worst = seen(start, x);
      if (worst < least) std::tie(best, least) = std::pair(x, worst);
      if (worst <= value * (1 + kExceeds)) break;
    }
    return best;
  }

  double judged(const RobustStart& start, std::span<const double> x) const override {
    return task_.unit * worst_of(errors(start, x, kLevels, kLevelFollow));
  }
  double reported(const RobustStart& start, std::span<const double> x) const override {
    return judged(start, x);
  }

 private:
  synthesis::WorstCaseOptions options(int follow, std::optional<double> most) const {
    return {.components = task_.components,
            .scale = task_.scale,
            .follow = follow,
            .most_sum_of_squares = most};
  }

  std::vector<SampledError> errors(const RobustStart& start, std::span<const double> x,
                                   std::size_t levels, int follow) const {
    return synthesis::sampled_errors(*start.model, LevelPerturbation(start, levels),
                                     options(follow, {}), x);
  }

  static double worst_of(const std::vector<SampledError>& all) {
    return std::ranges::max(all, {}, &SampledError::error).error;
  }

  /// Adds to `chosen` the worst corner of each station, and those near the worst of all, which are
  /// all that have no value where some have none; false where all of them take part.
  static bool exchange(const std::vector<SampledError>& all, std::vector<SampledError>& chosen) {
    const auto place = [](const SampledError& one) { return std::pair(one.sample, one.station); };
    std::vector<SampledError> of_station;
    for (const SampledError& one : all) {
      if (one.station >= of_station.size()) of_station.push_back(one);
      SampledError& worst = of_station[one.station];
      if (one.error > worst.error) worst = one;
    }
    const double near = (1 - kNearWorst) * worst_of(all);
    std::ranges::copy_if(all, std::back_inserter(of_station),
                         [&](const SampledError& one) { return one.error >= near; });
    const std::size_t before = chosen.size();
    std::ranges::move(of_station, std::back_inserter(chosen));
    std::ranges::sort(chosen, {}, place);
    const auto twice = std::ranges::unique(chosen, {}, place);
    chosen.erase(twice.begin(), twice.end());
    return chosen.size() > before;
  }

  /// Where the largest error of the chosen is least, and what it is there; empty where no solver
  /// comes to a design within its limits. Each goes on from where the one before was better.
  std::pair<std::vector<double>, double> least_of_chosen(
      const RobustStart& start, const std::vector<double>& x, std::optional<double> most,
      const std::vector<SampledError>& chosen) const {
    const LevelPerturbation corners(start, kCorners);
    const synthesis::WorstCaseModel model(*start.model, corners, options(kCornerFollow, most),
                                          chosen);
    const synthesis::RestrictedModel restricted(model, start.lower, start.upper);
    std::vector<double> from = restricted.inwards(x), best;
    double least = std::numeric_limits<double>::infinity();
    for (const auto solver : {synthesis::Solver::gauss_newton, synthesis::Solver::slsqp}) {
      const auto solution = synthesis::solve(solver, restricted, from,
                                             {.tolerance = 1e-10,
                                              .max_iterations = kWorstCaseIterations,
                                              .time_limit = deadline_.remaining(),
                                              .interrupted = deadline_.flag()});
      const bool is_sound = !solution.x.empty() && solution.stop != synthesis::Stop::no_value &&
                            solution.violation <= kWithinLimits;
      if (!is_sound || !(solution.objective < least)) continue;
      least = solution.objective;
      from = solution.x;
      best = restricted.outwards(solution.x);
    }
    return {best, least};
  }

  const RobustTask& task_;
  const Deadline& deadline_;
};

}  // namespace

std::unique_ptr<RobustCriterion> worst_case_criterion(const RobustTask& task,
                                                      const Deadline& deadline) {
  return std::make_unique<WorstCaseCriterion>(task, deadline);
}

}  // namespace cognate::problems
