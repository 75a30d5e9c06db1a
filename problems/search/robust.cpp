#include "problems/search/robust.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/search/perturbations.hpp"
#include "problems/search/robust_criterion.hpp"
#include "synthesis/robust/mean_square_model.hpp"
#include "synthesis/search/multi_start.hpp"

namespace cognate::problems {
namespace {

/// Shares of the tolerances under which the mean square is least: in the beginning more than all of
/// them, so that what minds them much is left; and less, for the front.
constexpr std::array kWideThenWhole{3.0, 1.0};
constexpr std::array kPartly{0.25, 0.5};
constexpr int kMeanIterations = 100;
/// A search for it that gains less than this begins anew no more; so often at most.
constexpr double kMeanGain = 1e-2;
constexpr int kMeanRestarts = 4;
/// Points of the front between nominal optimum and least figure.
constexpr int kBetween = 5;
/// By how much a point of the front must be better than the one before.
constexpr double kFrontGain = 1e-4;
/// So many of the least mean squares are brought to their least figure.
constexpr std::size_t kDescended = 4;
/// Variables nearer than this, relative to 1 + |x|, are one design.
constexpr double kSameWithin = 1e-3;
/// Newton steps of a crank that follows.
constexpr int kMeanFollow = 1;
/// Shares of the time after the least mean squares, the least figures, and the points between.
constexpr double kMeansDone = 0.4, kLeastDone = 0.75, kBetweenDone = 0.95;

/// Variables on their way, and the figure that the search makes least.
struct RobustCandidate {
  const RobustStart* start = nullptr;
  std::vector<double> x;
  double figure = std::numeric_limits<double>::infinity();
};

/// The models of two starts may be of different assemblies: then their figures differ.
bool is_same(const RobustCandidate& a, const RobustCandidate& b) {
  if (std::abs(a.figure - b.figure) > kSameWithin * a.figure) return false;
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
      : task_(task),
        run_(run),
        deadline_(deadline),
        criterion_(robust_criterion(task, run, deadline)) {}

  RobustAnswer run() {
    const auto nominal = known(task_.starts.front(), task_.starts.front().x);
    if (!nominal) return {};
    std::vector<RobustFound> all{*nominal};
    add_least(all);
    show_done(kLeastDone);
    const std::size_t best = least_of(all);
    if (best > 0) add_between(all[0], all[best], all);
    run_.enter(Phase::robustness, kUnknownEnd);
    show_done(kBetweenDone);
    const bool in_time = !is_over();
    return {front_of(std::move(all), in_time), in_time ? kReportedSamples : kJudgedSamples};
  }

 private:
  bool is_over() const { return deadline_.reached(); }

  void show_done(double share) const {
    if (run_.progress) run_.progress(share, std::numeric_limits<double>::infinity());
  }

  /// Calls `task` for each index, and shows how the share done goes from `from` to `to`.
  void for_each(std::size_t count, double from, double to,
                const std::function<void(std::size_t)>& task) const {
    run_.enter(Phase::robustness, to);
    std::atomic<std::size_t> done = 0;
    parallel_for(static_cast<int>(count), run_.threads, [&](int index, int thread) {
      if (is_over()) return;
      task(static_cast<std::size_t>(index));
      const double share = static_cast<double>(++done) / static_cast<double>(count);
      if (thread == 0) show_done(from + (to - from) * share);
    });
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
    found.point.figure = criterion_->judged(start, found.x);
    return found;
  }

  /// Where the mean square is least under one share of the tolerances after another; empty where it
  /// strays from what the file allows.
  std::optional<std::vector<double>> settle(const RobustStart& start, std::vector<double> x,
                                            std::span<const double> shares) const {
    for (const double share : shares) {
      const SpreadPerturbation spread(start, task_.distribution, share);
      const synthesis::MeanSquareModel model(*start.model, spread, kMeanFollow);
      const synthesis::RestrictedModel restricted(model, start.lower, start.upper);
      double before = std::numeric_limits<double>::infinity();
      for (int round = 0; round < kMeanRestarts; ++round) {
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

  /// From every nominal minimum where the mean square is least, each once, by their figures.
  std::vector<RobustCandidate> candidates() const {
    constexpr std::size_t kWays = kWideThenWhole.size();
    std::vector<RobustCandidate> all(task_.starts.size() * kWays);
    for_each(all.size(), 0, kMeansDone, [&](std::size_t i) {
      const RobustStart& start = task_.starts[i / kWays];
      const std::span<const double> shares = std::span(kWideThenWhole).subspan(i % kWays);
      if (auto x = settle(start, start.x, shares)) {
        all[i] = {&start, *std::move(x)};
        all[i].figure = criterion_->seen(start, all[i].x);
      }
      if (std::isfinite(all[i].figure)) return;
      // What is least in the mean may have parts that cannot be assembled.
      all[i] = {&start, start.x};
      all[i].figure = criterion_->seen(start, start.x);
    });
    std::erase_if(all, [](const auto& one) { return !std::isfinite(one.figure); });
    std::ranges::stable_sort(all, {}, &RobustCandidate::figure);
    std::vector<RobustCandidate> different;
    for (RobustCandidate& one : all) {
      const auto same = [&](const RobustCandidate& known) { return is_same(known, one); };
      if (std::ranges::none_of(different, same)) different.push_back(std::move(one));
    }
    return different;
  }

  /// The least figures, and what they come from: mean squares, and the nominal optimum.
  void add_least(std::vector<RobustFound>& all) const {
    auto from = candidates();
    if (from.size() > kDescended) from.resize(kDescended);
    const RobustStart& nominal = task_.starts.front();
    from.push_back({&nominal, nominal.x});
    std::vector<std::optional<RobustFound>> found(2 * from.size());
    for_each(found.size(), kMeansDone, kLeastDone, [&](std::size_t i) {
      const auto& [start, x, figure] = from[i / 2];
      found[i] = known(*start, i % 2 == 0 ? x : criterion_->descend(*start, x, {}));
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
        all, {}, [](const RobustFound& found) { return found.point.figure; });
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
    for_each(kBetween, kLeastDone, kBetweenDone, [&](std::size_t i) {
      const double share = double(i + 1) / (kBetween + 1);
      const double most = low + share * (high - low);
      const RobustFound& from = share < 0.5 ? nominal : best;
      found[i] = known(*from.start, criterion_->descend(*from.start, from.x, most * most));
    });
    add(std::move(found), all);
    for (const double share : kPartly) {
      if (is_over()) return;
      const auto x = settle(*nominal.start, nominal.x, {&share, 1});
      auto one = x ? known(*nominal.start, *x) : std::nullopt;
      if (one) all.push_back(*std::move(one));
    }
  }

  /// Those that no other is better than in both, by their error; in time the two ends reported by
  /// more samples, the end dropped where these do not find it better.
  std::vector<RobustPoint> front_of(std::vector<RobustFound> all, bool in_time) const {
    std::ranges::stable_sort(all.begin() + 1, all.end(), {},
                             [](const RobustFound& found) { return found.point.error; });
    std::vector<RobustFound*> kept;
    for (RobustFound& found : all) {
      const bool is_less =
          kept.empty() || found.point.figure < kept.back()->point.figure * (1 - kFrontGain);
      if (is_less) kept.push_back(&found);
    }
    if (in_time) report(*kept.front());
    if (in_time && kept.size() > 1) {
      report(*kept.back());
      if (!(kept.back()->point.figure < kept.front()->point.figure)) kept.resize(1);
    }
    // The ends have moved by the noise of fewer samples: those between stay between.
    const double most = kept.front()->point.figure, least = kept.back()->point.figure;
    std::erase_if(kept, [&](const RobustFound* found) {
      const bool is_end = found == kept.front() || found == kept.back();
      return !is_end && !(found->point.figure > least && found->point.figure < most);
    });
    std::vector<RobustPoint> front;
    for (RobustFound* found : kept) front.push_back(std::move(found->point));
    return front;
  }

  void report(RobustFound& found) const {
    found.point.figure = criterion_->reported(*found.start, found.x);
  }

  const RobustTask& task_;
  const Run& run_;
  const Deadline& deadline_;
  std::unique_ptr<RobustCriterion> criterion_;
};

std::string quantile_note(const RobustTask& task, double robust, double nominal,
                          std::size_t samples) {
  const double share = 100 * task.share;
  if (!std::isfinite(robust)) {
    return fmt::format(
        "Of what is made of the nominal optimum not even {:.4g} % can be assembled, nor of any "
        "design that was found.",
        share);
  }
  if (!std::isfinite(nominal)) {
    return fmt::format(
        "Of what is made of the robust design {:.4g} % err by no more than {:.4g}; of the nominal "
        "optimum not even as many can be assembled: by {} samples that the search has not seen.",
        share, robust, samples);
  }
  return fmt::format(
      "Of what is made of the robust design {:.4g} % err by no more than {:.4g}, of the nominal "
      "optimum by no more than {:.4g}: by {} samples that the search has not seen.",
      share, robust, nominal, samples);
}

std::string worst_case_note(double robust, double nominal) {
  if (!std::isfinite(robust)) {
    return "Within the tolerances the nominal optimum cannot always be assembled, nor can any "
           "design that was found.";
  }
  const std::string of_nominal = std::isfinite(nominal)
                                     ? fmt::format("errs by no more than {:.4g}", nominal)
                                     : std::string("cannot always be assembled");
  return fmt::format(
      "At the corners of the box of tolerances, the middles of its edges and of its faces the "
      "robust design errs by no more than {:.4g}, the nominal optimum {}.",
      robust, of_nominal);
}

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

RobustAnswer robust_designs(const RobustTask& task, const Run& run, const Deadline& deadline) {
  return task.starts.empty() ? RobustAnswer{} : RobustSearch(task, run, deadline).run();
}

void add_robust(const RobustTask& task, RobustAnswer answer, bool is_angle, Result& result) {
  if (answer.front.empty()) {
    result.notes.emplace_back(
        task.starts.empty() && task.lacks_tolerances
            ? "There is no robust design: no nominal design can have the tolerances of the file: "
              "they leave nothing of a length, or grades of a standard do not reach it."
            : "There is no robust design: no nominal design meets every constraint.");
    return;
  }
  const bool is_worst = is_worst_case(task);
  const std::string unit = is_angle ? "_deg" : "";
  const std::string figure = is_worst ? "worst_case" : "quantile";
  Family family{"Robust front", {{"nominal_error" + unit, {}}, {figure + unit, {}}}};
  for (RobustPoint& point : answer.front) {
    // By these the page finds a design on the front.
    point.design.metrics.quantities.push_back({family.columns[0].name, point.error});
    point.design.metrics.quantities.push_back({family.columns[1].name, point.figure});
    family.columns[0].values.push_back(point.error);
    family.columns[1].values.push_back(point.figure);
  }
  const double nominal = answer.front.front().figure, robust = answer.front.back().figure;
  result.quantities.push_back({fmt::format("nominal_{}{}", figure, unit), nominal});
  result.quantities.push_back({fmt::format("robust_{}{}", figure, unit), robust});
  if (!is_worst) result.quantities.push_back({"robust_samples", double(answer.samples)});
  result.notes.push_back(is_worst ? worst_case_note(robust, nominal)
                                  : quantile_note(task, robust, nominal, answer.samples));
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
