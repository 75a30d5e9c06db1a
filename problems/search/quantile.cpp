/// The quantile over samples, the same at every step.
#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/search/perturbations.hpp"
#include "problems/search/robust_criterion.hpp"
#include "synthesis/optimise/solver.hpp"
#include "synthesis/robust/quantile_model.hpp"

namespace cognate::problems {
namespace {

/// Samples of the search.
constexpr std::size_t kSearchSamples = 1024;
/// A descent that has gained less than this begins anew no more; so often at most: the solver sees
/// a function with edges and may stop on one.
constexpr double kDescentGain = 1e-4;
constexpr int kDescentRestarts = 4;
constexpr int kDescentIterations = 50;
/// Newton steps of a crank that follows: one is enough to see where a sample goes.
constexpr int kSampleFollow = 1, kReportedFollow = 2;
/// Seeds of samples: those of the search are not those of the figures.
constexpr std::uint64_t kSearchSeed = 0x526f62757374, kFrontSeed = 0x46726f6e74,
                        kReportedSeed = 0x546f6c64;

class QuantileCriterion final : public RobustCriterion {
 public:
  QuantileCriterion(const RobustTask& task, const Run& run, const Deadline& deadline)
      : task_(task), run_(run), deadline_(deadline) {}

  double seen(const RobustStart& start, std::span<const double> x) const override {
    const DrawnPerturbation drawn(start, task_.distribution, kSearchSeed, kSearchSamples);
    const synthesis::QuantileModel model(*start.model, drawn, options(kSampleFollow, {}));
    double value = 0;
    return model.residuals(x, {&value, 1}, {}, {}) ? value
                                                   : std::numeric_limits<double>::infinity();
  }

  std::vector<double> descend(const RobustStart& start, std::vector<double> x,
                              std::optional<double> most) const override {
    const DrawnPerturbation drawn(start, task_.distribution, kSearchSeed, kSearchSamples);
    const synthesis::QuantileModel model(*start.model, drawn, options(kSampleFollow, most));
    const synthesis::RestrictedModel restricted(model, start.lower, start.upper);
    double before = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kDescentRestarts && !deadline_.reached(); ++round) {
      const auto solution =
          synthesis::solve(synthesis::Solver::slsqp, restricted, restricted.inwards(x),
                           {.tolerance = 1e-9,
                            .max_iterations = kDescentIterations,
                            .time_limit = deadline_.remaining(),
                            .interrupted = deadline_.flag()});
      const bool is_worse = !(solution.objective < before * (1 - kDescentGain));
      if (solution.x.empty() || solution.stop == synthesis::Stop::no_value) break;
      if (solution.objective < before) x = restricted.outwards(solution.x);
      if (is_worse) break;
      before = solution.objective;
    }
    return x;
  }

  double judged(const RobustStart& start, std::span<const double> x) const override {
    return quantile(start, x, kFrontSeed, kJudgedSamples);
  }
  double reported(const RobustStart& start, std::span<const double> x) const override {
    return quantile(start, x, kReportedSeed, kReportedSamples);
  }

 private:
  synthesis::QuantileOptions options(int follow, std::optional<double> most) const {
    return {.share = task_.share,
            .components = task_.components,
            .scale = task_.scale,
            .follow = follow,
            .most_sum_of_squares = most};
  }

  /// The share of `count` samples drawn afresh that err by no more.
  double quantile(const RobustStart& start, std::span<const double> x, std::uint64_t seed,
                  std::size_t count) const {
    const DrawnPerturbation drawn(start, task_.distribution, seed + run_.seed, count);
    const synthesis::QuantileModel model(*start.model, drawn, options(kReportedFollow, {}));
    const auto errors = model.errors(x, run_.threads);
    const double place = std::ceil(task_.share * static_cast<double>(count));
    return task_.unit * errors[std::min(count, static_cast<std::size_t>(place)) - 1];
  }

  const RobustTask& task_;
  const Run& run_;
  const Deadline& deadline_;
};

}  // namespace

std::unique_ptr<RobustCriterion> quantile_criterion(const RobustTask& task, const Run& run,
                                                    const Deadline& deadline) {
  return std::make_unique<QuantileCriterion>(task, run, deadline);
}

std::unique_ptr<RobustCriterion> robust_criterion(const RobustTask& task, const Run& run,
                                                  const Deadline& deadline) {
  return is_worst_case(task) ? worst_case_criterion(task, deadline)
                             : quantile_criterion(task, run, deadline);
}

}  // namespace cognate::problems
