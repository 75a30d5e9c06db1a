#include "problems/search/robust.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/search/perturbations.hpp"
#include "synthesis/robust/mean_square_model.hpp"
#include "synthesis/robust/quantile_model.hpp"
#include "synthesis/search/multi_start.hpp"

namespace cognate::problems {
namespace {

/// Samples of the search, of a point of the front, and of the figures that are reported.
constexpr std::size_t kSearchSamples = 1024, kFrontSamples = 30'000, kReportedSamples = 1'000'000;
/// Shares of the tolerances under which the mean square is least: in the beginning more than all of
/// them, so that what minds them much is left; and less, for the front.
constexpr std::array kWideThenWhole{3.0, 1.0};
constexpr std::array kPartly{0.25, 0.5};
constexpr int kMeanIterations = 100;
constexpr double kMeanGain = 1e-2;  ///< as kGain
/// Points of the front between nominal optimum and least quantile.
constexpr int kBetween = 5;
/// A search that has gained less than this begins anew no more; so often at most: the solver sees a
/// function with edges and may stop on one.
constexpr double kGain = 1e-4;
constexpr int kRestarts = 4;
constexpr int kIterations = 50;
/// So many of the least mean squares are brought to their least quantile.
constexpr std::size_t kDescended = 4;
/// Variables nearer than this, relative to 1 + |x|, are one design.
constexpr double kSameWithin = 1e-3;
/// Newton steps of a crank that follows: one is enough to see where a sample goes.
constexpr int kSearchFollow = 1, kReportedFollow = 2;
/// Seeds of samples: those of the search are not those of the figures.
constexpr std::uint64_t kSearchSeed = 0x526f62757374, kFrontSeed = 0x46726f6e74,
                        kReportedSeed = 0x546f6c64;

/// Variables on their way, and the quantile of the samples of the search.
struct RobustCandidate {
  const RobustStart* start = nullptr;
  std::vector<double> x;
  double quantile = std::numeric_limits<double>::infinity();
};

/// The models of two starts may be of different assemblies: then their quantiles differ.
bool is_same(const RobustCandidate& a, const RobustCandidate& b) {
  if (std::abs(a.quantile - b.quantile) > kSameWithin * a.quantile) return false;
  const auto globals = static_cast<std::size_t>(a.start->model->global_count());
  for (std::size_t i = 0; i < globals; ++i) {
    if (!(std::abs(a.x[i] - b.x[i]) <= kSameWithin * (1 + std::abs(a.x[i])))) return false;
  }
  return true;
}

/// A design on its way.
struct RobustFound {
  const RobustStart* start = nullptr;
  std::vector<double> x;
  RobustPoint point;
};

class RobustSearch {
 public:
  RobustSearch(const RobustTask& task, const Run& run, const Deadline& deadline)
      : task_(task), run_(run), deadline_(deadline) {}

  RobustAnswer run() {
    const auto nominal = known(task_.starts.front(), task_.starts.front().x);
    if (!nominal) return {};
    std::vector<RobustFound> all{*nominal};
    add_least(all);
    const std::size_t best = least_of(all);
    if (best > 0) add_between(all[0], all[best], all);
    return {front_of(std::move(all))};
  }

 private:
  bool is_over() const { return deadline_.reached(); }

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

  bool place(const RobustStart& start, std::vector<double>& x) const {
    return !task_.place || task_.place(start, x);
  }

  /// The point that `x` is, if it meets the constraints.
  std::optional<RobustFound> known(const RobustStart& start, std::vector<double> x) const {
    if (!place(start, x)) return std::nullopt;
    auto design = task_.design(start, x);
    if (!design) return std::nullopt;
    RobustFound found{&start, std::move(x), {*std::move(design)}};
    found.point.error = task_.error(found.point.design);
    found.point.quantile = quantile(start, found.x, kFrontSeed, kFrontSamples);
    return found;
  }

  /// The least quantile that a descent from `x` finds, the nominal sum of squares within `most`.
  std::vector<double> descend(const RobustStart& start, std::vector<double> x,
                              std::optional<double> most) const {
    const DrawnPerturbation drawn(start, task_.distribution, kSearchSeed, kSearchSamples);
    const synthesis::QuantileModel model(*start.model, drawn, options(kSearchFollow, most));
    const synthesis::RestrictedModel restricted(model, start.lower, start.upper);
    double before = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kRestarts && !is_over(); ++round) {
      const auto solution =
          synthesis::solve(synthesis::Solver::slsqp, restricted, restricted.inwards(x),
                           {.tolerance = 1e-9,
                            .max_iterations = kIterations,
                            .time_limit = deadline_.remaining(),
                            .interrupted = deadline_.flag()});
      const bool is_worse = !(solution.objective < before * (1 - kGain));
      if (solution.x.empty() || solution.stop == synthesis::Stop::no_value) break;
      if (solution.objective < before) x = restricted.outwards(solution.x);
      if (is_worse) break;
      before = solution.objective;
    }
    return x;
  }

  /// Where the mean square is least under one share of the tolerances after another; empty where it
  /// strays from what the file allows.
  std::optional<std::vector<double>> settle(const RobustStart& start, std::vector<double> x,
                                            std::span<const double> shares) const {
    for (const double share : shares) {
      const SpreadPerturbation spread(start, task_.distribution, share);
      const synthesis::MeanSquareModel model(*start.model, spread, kSearchFollow);
      const synthesis::RestrictedModel restricted(model, start.lower, start.upper);
      double before = std::numeric_limits<double>::infinity();
      for (int round = 0; round < kRestarts; ++round) {
        const auto solution = synthesis::solve(
            synthesis::Solver::gauss_newton, restricted, restricted.inwards(x),
            synthesis::until(deadline_, {.tolerance = 1e-9, .max_iterations = kMeanIterations}));
        if (solution.stop == synthesis::Stop::no_value) break;
        x = restricted.outwards(solution.x);
        if (!place(start, x)) return std::nullopt;
        if (!(solution.objective < before * (1 - kMeanGain))) break;
        before = solution.objective;
      }
    }
    return x;
  }

  double quantile_seen(const RobustStart& start, std::span<const double> x) const {
    const DrawnPerturbation drawn(start, task_.distribution, kSearchSeed, kSearchSamples);
    const synthesis::QuantileModel model(*start.model, drawn, options(kSearchFollow, {}));
    double value = 0;
    return model.residuals(x, {&value, 1}, {}, {}) ? value
                                                   : std::numeric_limits<double>::infinity();
  }

  /// From every nominal minimum where the mean square is least, each once, by their quantiles.
  std::vector<RobustCandidate> candidates() const {
    constexpr std::size_t kWays = kWideThenWhole.size();
    std::vector<RobustCandidate> all(task_.starts.size() * kWays);
    parallel_for(static_cast<int>(all.size()), run_.threads, [&](int index, int) {
      if (is_over()) return;
      const auto i = static_cast<std::size_t>(index);
      const RobustStart& start = task_.starts[i / kWays];
      const std::span<const double> shares = std::span(kWideThenWhole).subspan(i % kWays);
      if (auto x = settle(start, start.x, shares)) {
        all[i] = {&start, *std::move(x)};
        all[i].quantile = quantile_seen(start, all[i].x);
      }
    });
    std::erase_if(all, [](const auto& one) { return !std::isfinite(one.quantile); });
    std::ranges::stable_sort(all, {}, &RobustCandidate::quantile);
    std::vector<RobustCandidate> different;
    for (RobustCandidate& one : all) {
      const auto same = [&](const RobustCandidate& known) { return is_same(known, one); };
      if (std::ranges::none_of(different, same)) different.push_back(std::move(one));
    }
    return different;
  }

  /// The least quantiles, and the mean squares from which they come.
  void add_least(std::vector<RobustFound>& all) const {
    const auto from = candidates();
    std::vector<std::optional<RobustFound>> found(2 * std::min(kDescended, from.size()));
    parallel_for(static_cast<int>(found.size()), run_.threads, [&](int index, int) {
      const auto i = static_cast<std::size_t>(index);
      const auto& [start, x, quantile] = from[i / 2];
      if (!is_over()) found[i] = known(*start, i % 2 == 0 ? x : descend(*start, x, {}));
    });
    add(std::move(found), all);
  }

  static void add(std::vector<std::optional<RobustFound>> found, std::vector<RobustFound>& all) {
    for (auto& one : found) {
      if (one) all.push_back(*std::move(one));
    }
  }

  static std::size_t least_of(const std::vector<RobustFound>& all) {
    const auto least = std::ranges::min_element(
        all, {}, [](const RobustFound& found) { return found.point.quantile; });
    return static_cast<std::size_t>(least - all.begin());
  }

  double sum_of_squares(const RobustFound& found) const {
    std::vector<double> r(static_cast<std::size_t>(found.start->model->residual_count()));
    if (!found.start->model->residuals(found.x, r, {}, {})) return 0;
    double sum = 0;
    for (const double value : r) sum += value * value;
    return sum;
  }

  /// Points between the two ends, the nominal error bounded in equal steps.
  void add_between(const RobustFound nominal, const RobustFound best,
                   std::vector<RobustFound>& all) const {
    const double low = std::sqrt(sum_of_squares(nominal)), high = std::sqrt(sum_of_squares(best));
    if (!(high > low)) return;
    std::vector<std::optional<RobustFound>> found(kBetween);
    parallel_for(kBetween, run_.threads, [&](int index, int) {
      if (is_over()) return;
      const double share = double(index + 1) / (kBetween + 1);
      const double most = low + share * (high - low);
      const RobustFound& from = share < 0.5 ? nominal : best;
      found[static_cast<std::size_t>(index)] =
          known(*from.start, descend(*from.start, from.x, most * most));
    });
    add(std::move(found), all);
    for (const double share : kPartly) {
      if (is_over()) return;
      const auto x = settle(*nominal.start, nominal.x, {&share, 1});
      auto one = x ? known(*nominal.start, *x) : std::nullopt;
      if (one) all.push_back(*std::move(one));
    }
  }

  /// Those that no other is better than in both, by their error; the two ends reported by more
  /// samples, the end dropped where these do not find it better.
  std::vector<RobustPoint> front_of(std::vector<RobustFound> all) const {
    std::ranges::stable_sort(all.begin() + 1, all.end(), {},
                             [](const RobustFound& found) { return found.point.error; });
    std::vector<RobustFound*> kept;
    for (RobustFound& found : all) {
      const bool is_less = kept.empty() || found.point.quantile < kept.back()->point.quantile;
      if (is_less) kept.push_back(&found);
    }
    report(*kept.front());
    if (kept.size() > 1) {
      report(*kept.back());
      if (!(kept.back()->point.quantile < kept.front()->point.quantile)) kept.resize(1);
    }
    std::vector<RobustPoint> front;
    for (RobustFound* found : kept) front.push_back(std::move(found->point));
    return front;
  }

  void report(RobustFound& found) const {
    found.point.quantile = quantile(*found.start, found.x, kReportedSeed, kReportedSamples);
  }

  const RobustTask& task_;
  const Run& run_;
  const Deadline& deadline_;
};

}  // namespace

std::optional<Constraints> with_good_transmission(const Constraints& constraints) {
  constexpr Range kGood{40 * kDegree, 140 * kDegree};
  const Range own = constraints.transmission_angle.value_or(Range{0, kPi});
  const Range both{std::max(own.min, kGood.min), std::min(own.max, kGood.max)};
  const bool is_own = both.min == own.min && both.max == own.max;
  if (is_own || !(both.min < both.max)) return std::nullopt;
  Constraints narrowed = constraints;
  narrowed.transmission_angle = both;
  return narrowed;
}

Run part_of(const Run& run, double from, double to) {
  Run part = run;
  if (!run.progress) return part;
  part.progress = [progress = run.progress, from, to](double share, double best) {
    progress(from + (to - from) * share, best);
  };
  return part;
}

RobustAnswer robust_designs(const RobustTask& task, const Run& run, const Deadline& deadline) {
  return task.starts.empty() ? RobustAnswer{} : RobustSearch(task, run, deadline).run();
}

void add_robust(const RobustTask& task, RobustAnswer answer, bool is_angle, Result& result) {
  if (answer.front.empty()) {
    result.notes.emplace_back(
        "There is no robust design: no nominal design meets every constraint.");
    return;
  }
  const std::string unit = is_angle ? "_deg" : "";
  Family family{"Robust front", {{"nominal_error" + unit, {}}, {"quantile" + unit, {}}}};
  for (RobustPoint& point : answer.front) {
    // By these the page finds a design on the front.
    point.design.metrics.quantities.push_back({family.columns[0].name, point.error});
    point.design.metrics.quantities.push_back({family.columns[1].name, point.quantile});
    family.columns[0].values.push_back(point.error);
    family.columns[1].values.push_back(point.quantile);
  }
  const double nominal = answer.front.front().quantile, robust = answer.front.back().quantile;
  result.quantities.push_back({"nominal_quantile" + unit, nominal});
  result.quantities.push_back({"robust_quantile" + unit, robust});
  result.quantities.push_back({"robust_samples", double(kReportedSamples)});
  result.notes.push_back(fmt::format(
      "Of what is made of the robust design {:.4g} % err by no more than {:.4g}, of the nominal "
      "optimum by no more than {:.4g}: by {} samples that the search has not seen.",
      100 * task.share, robust, nominal, kReportedSamples));
  if (answer.front.size() == 1) {
    result.notes.emplace_back("No design was found that is more robust than the nominal optimum.");
  }
  result.designs.clear();
  for (auto point = answer.front.rbegin(); point != answer.front.rend(); ++point) {
    result.designs.push_back(std::move(point->design));
  }
  result.families.push_back(std::move(family));
}

}  // namespace cognate::problems
