/// The search over a model: every minimum of functions whose minima are known otherwise, under
/// constraints and symmetries, the same for any number of threads, ended from outside.
#include "synthesis/search/search.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "tests/support/optimisation_problems.hpp"

namespace cognate::synthesis::testing::search_test {
namespace {

/// Himmelblau's function: four minima of value 0 (Himmelblau 1972).
FunctionModel::Parts himmelblau() {
  return {boxes({{-6, 6}, {-6, 6}}), [](Point x) -> Values {
            return {x[0] * x[0] + x[1] - 11.0, x[0] + x[1] * x[1] - 7.0};
          }};
}

constexpr double kCentres[] = {0.3, -0.5, 0.9};
constexpr double kPull = 0.3;

/// Σ (xᵢ² − 1)² + (0.3 (xᵢ − cᵢ))²: the sum of functions of one variable, each with two minima.
FunctionModel::Parts double_wells() {
  return {boxes({{-3, 3}, {-3, 3}, {-3, 3}}), [](Point x) {
            Values values;
            for (std::size_t i = 0; i < 3; ++i) {
              values.push_back(x[i] * x[i] - 1.0);
              values.push_back(kPull * (x[i] - kCentres[i]));
            }
            return values;
          }};
}

/// The minimum of one such function at `side` of 0, where its slope changes sign: by bisection.
double well(double centre, double side) {
  const auto slope = [&](double x) {
    return 4 * x * (x * x - 1) + 2 * kPull * kPull * (x - centre);
  };
  double low = side > 0 ? 0.8 : -1.2, high = low + 0.4;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (slope(middle) > 0 ? high : low) = middle;
  }
  return low;
}

double well_value(double centre, double x) {
  return std::pow(x * x - 1, 2) + std::pow(kPull * (x - centre), 2);
}

TEST(Search, FindsAllMinimaOfHimmelblausFunction) {
  const SearchResult result = search(FunctionModel(himmelblau()));
  EXPECT_EQ(result.status, SearchStatus::solved);
  ASSERT_EQ(result.minima.size(), 4U);
  const std::vector<std::vector<double>> known = {{3, 2},
                                                  {-2.805118086952745, 3.131312518250573},
                                                  {-3.779310253377747, -3.283185991286170},
                                                  {3.584428340330492, -1.848126526964404}};
  for (const auto& x : known) {
    EXPECT_TRUE(std::ranges::any_of(result.minima, [&](const Minimum& one) {
      return std::hypot(one.solution.x[0] - x[0], one.solution.x[1] - x[1]) < 1e-8;
    })) << x[0];
  }
  int hits = 0;
  for (const Minimum& one : result.minima) hits += one.hits;
  EXPECT_LE(hits, result.statistics.starts);
  EXPECT_GT(hits, 0.9 * result.statistics.starts);
  EXPECT_EQ(result.statistics.best_hits, result.minima.front().hits);
  EXPECT_DOUBLE_EQ(result.statistics.unseen, 1.0 / (result.statistics.starts + 1));
}

TEST(Search, RanksTheMinimaByTheirValues) {
  const SearchResult result = search(FunctionModel(double_wells()), {.seed = 3});
  std::vector<double> values;
  for (int side = 0; side < 8; ++side) {
    double value = 0;
    for (int i = 0; i < 3; ++i) {
      value += well_value(kCentres[i], well(kCentres[i], (side >> i) % 2 ? 1 : -1));
    }
    values.push_back(value);
  }
  std::ranges::sort(values);
  ASSERT_EQ(result.minima.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(result.minima[i].solution.objective, values[i], 1e-12);
  }
}

/// With x ≥ 0 two minima of Himmelblau's function are left inside. On the border x = 0 one more is
/// a minimum where the function has one along it and grows into the inside: (y − 11)² + (y² − 7)²
/// has them where its slope changes sign, and ∂f/∂x = 2 (y² − 7) there.
TEST(Search, KeepsConstraintsInside) {
  FunctionModel::Parts parts = himmelblau();
  parts.constraints = [](Point x) -> Values { return {x[0]}; };
  std::vector<double> borders;
  const auto slope = [](double y) { return 2 * (y - 11) + 4 * y * (y * y - 7); };
  for (double y = -6; y < 6; y += 1e-4) {
    if (slope(y) < 0 && slope(y + 1e-4) >= 0 && y * y > 7) borders.push_back(y);
  }
  const SearchResult result = search(FunctionModel(parts));
  EXPECT_EQ(result.status, SearchStatus::solved);
  ASSERT_EQ(result.minima.size(), 2 + borders.size());
  std::vector<double> found;
  for (const Minimum& one : result.minima) {
    EXPECT_GE(one.solution.x[0], -1e-9);
    if (one.solution.x[0] < 1e-6) found.push_back(one.solution.x[1]);
  }
  std::ranges::sort(found);
  ASSERT_EQ(found.size(), borders.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], borders[i], 2e-4);
}

TEST(Search, SaysThatConstraintsWereNotMet) {
  FunctionModel::Parts parts = himmelblau();
  parts.constraints = [](Point x) -> Values { return {x[0] - 1.0, -x[0]}; };
  const SearchResult result = search(FunctionModel(parts), {.rule = {.starts = 20}});
  EXPECT_EQ(result.status, SearchStatus::infeasible);
  ASSERT_FALSE(result.minima.empty());
  EXPECT_GE(result.minima.front().solution.violation, 0.5 - 1e-9);
  EXPECT_EQ(result.statistics.starts, 20);
}

TEST(Search, SaysThatNoStartHasAValue) {
  FunctionModel::Parts parts = himmelblau();
  parts.has_value = [](auto) { return false; };
  const SearchResult result = search(FunctionModel(parts), {.rule = {.starts = 20}});
  EXPECT_EQ(result.status, SearchStatus::no_solution);
  EXPECT_TRUE(result.minima.empty());
}

/// The signs of all variables make images of the one minimum of Σ (xᵢ² − 1)².
TEST(Search, CountsImagesAsOneMinimum) {
  const FunctionModel model({boxes({{-2, 2}, {-2, 2}, {-2, 2}}), [](Point x) -> Values {
                               return {x[0] * x[0] - 1.0, x[1] * x[1] - 1.0, x[2] * x[2] - 1.0};
                             }});
  SearchOptions options{.rule = {.starts = 100}};
  EXPECT_EQ(search(model, options).minima.size(), 8U);
  options.images = [](const Minimum& one) {
    std::vector<std::vector<double>> images;
    for (int side = 1; side < 8; ++side) {
      std::vector<double> x = one.solution.x;
      for (int i = 0; i < 3; ++i) x[i] *= (side >> i) % 2 ? -1 : 1;
      images.push_back(std::move(x));
    }
    return images;
  };
  const SearchResult result = search(model, options);
  ASSERT_EQ(result.minima.size(), 1U);
  EXPECT_EQ(result.minima.front().hits, 100);
}

TEST(Search, DistinguishesDesignsByTheGivenRule) {
  const FunctionModel model(himmelblau());
  SearchOptions options{.rule = {.starts = 60}};
  options.is_same = [](const Minimum& a, const Minimum& b, double) {
    return a.solution.x[0] * b.solution.x[0] > 0;  // left or right
  };
  EXPECT_EQ(search(model, options).minima.size(), 2U);
}

TEST(Search, IsTheSameForAnyNumberOfThreads) {
  const FunctionModel model(double_wells());
  SearchOptions options{.designs = 5};
  options.threads = 1;
  const SearchResult one = search(model, options);
  for (const int threads : {2, 5}) {
    options.threads = threads;
    const SearchResult other = search(model, options);
    ASSERT_EQ(other.minima.size(), one.minima.size());
    for (std::size_t i = 0; i < one.minima.size(); ++i) {
      EXPECT_EQ(other.minima[i].solution.x, one.minima[i].solution.x);
      EXPECT_EQ(other.minima[i].hits, one.minima[i].hits);
    }
    EXPECT_EQ(other.statistics.starts, one.statistics.starts);
    EXPECT_EQ(other.statistics.unseen, one.statistics.unseen);
    EXPECT_EQ(other.work.evaluations, one.work.evaluations);
  }
  options.seed = 2;
  EXPECT_NE(search(model, options).work.evaluations, one.work.evaluations);
}

TEST(Search, EndsWhenCancelled) {
  const FunctionModel model(himmelblau());
  std::atomic<bool> cancelled{false};
  const StartSource even = uniform_starts(model);
  const StartSource starts = [&](std::uint64_t seed, int index) {
    if (index == 150) cancelled = true;
    return even(seed, index);
  };
  SearchOptions options{.rule = {.starts = 100'000, .round = 100}, .threads = 2};
  options.cancelled = &cancelled;
  const SearchResult result = search(model, starts, options);
  EXPECT_EQ(result.status, SearchStatus::cancelled);
  EXPECT_EQ(result.statistics.starts, 200);
  ASSERT_GE(result.minima.size(), 4U);  // of the first round, and what the second left undone
  EXPECT_LT(result.minima[3].solution.objective, 1e-12);
}

TEST(Search, EndsWithItsTime) {
  FunctionModel::Parts parts = himmelblau();
  parts.has_value = [](auto) {
    std::this_thread::sleep_for(std::chrono::microseconds(50));
    return true;
  };
  SearchOptions options{.rule = {.starts = 1'000'000, .round = 20}, .time_limit = 0.2};
  const auto begin = std::chrono::steady_clock::now();
  const SearchResult result = search(FunctionModel(parts), options);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(result.status, SearchStatus::time_limit);
  EXPECT_FALSE(result.minima.empty());
  EXPECT_LT(spent.count(), 5);
}

TEST(Search, ReportsGrowingShares) {
  const FunctionModel model(double_wells());
  double last = 0, best = kInfinity;
  SearchOptions options{.threads = 3};
  options.progress = [&](double share, double value) {
    EXPECT_GE(share, last);
    EXPECT_LE(value, best);
    last = share;
    best = value;
  };
  const SearchResult result = search(model, options);
  EXPECT_EQ(last, 1);
  EXPECT_NEAR(best, result.minima.front().solution.objective, 1e-6);
}

/// Two models for two kinds of starts, and no model of the search.
TEST(Search, DescendsInTheModelOfEachStart) {
  std::vector<std::shared_ptr<const Model>> models;
  for (const double goal : {2.0, 3.0}) {
    models.push_back(std::make_shared<FunctionModel>(FunctionModel::Parts{
        boxes({{-5, 5}}), [goal](Point x) -> Values { return {x[0] * x[0] - goal * goal}; }}));
  }
  const StartSource starts = [&](std::uint64_t seed, int index) -> std::optional<SearchStart> {
    if (index % 5 == 4) return std::nullopt;
    auto start = uniform_starts(*models[0])(seed, index);
    start->model = models[static_cast<std::size_t>(index % 2)];
    return start;
  };
  const SearchResult result = search(starts, {.rule = {.starts = 60}});
  ASSERT_EQ(result.minima.size(), 4U);
  for (const Minimum& one : result.minima) {
    EXPECT_NEAR(std::abs(one.solution.x[0]), one.model == models[0] ? 2 : 3, 1e-8);
  }
}

TEST(Search, BeginsWithWhatIsKnown) {
  const FunctionModel model(himmelblau());
  SearchOptions options{.rule = {.starts = 0}};
  options.known = {{{2.5, 2.5}}, {{-3, -3}}};
  const SearchResult result = search(model, options);
  ASSERT_EQ(result.minima.size(), 2U);
  EXPECT_EQ(result.statistics.starts, 0);
  EXPECT_EQ(result.statistics.best_hits, 0);
  EXPECT_EQ(result.statistics.unseen, 1);
}

TEST(Search, ScreensStartsByConstraintsAndValue) {
  FunctionModel::Parts parts = himmelblau();
  parts.constraints = [](Point x) -> Values { return {x[0]}; };
  const FunctionModel model(parts);
  const StartSource screened = screened_starts(uniform_starts(model), 20, &model);
  const auto value = [](const std::vector<double>& x) {
    return std::pow(x[0] * x[0] + x[1] - 11, 2) + std::pow(x[0] + x[1] * x[1] - 7, 2);
  };
  for (int index = 0; index < 20; ++index) {
    const auto start = screened(7, index);
    ASSERT_TRUE(start);
    EXPECT_GE(start->x[0], 0);
    int better = 0;
    for (int i = 0; i < 20; ++i) {
      const auto other = uniform_starts(model)(7, 20 * index + i);
      better += other->x[0] >= 0 && value(other->x) < value(start->x);
    }
    EXPECT_EQ(better, 0);
  }
}

/// On [0, 1] the square of the distance from the nearest of some random sites: each site is a
/// minimum, and the starts that lead to it are those of its cell, whose length is known.
class Cells final : public Model {
 public:
  explicit Cells(std::vector<double> sites) : sites_(std::move(sites)) {
    std::ranges::sort(sites_);
  }

  std::span<const Variable> variables() const override { return variables_; }
  int residual_count() const override { return 1; }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double>) const override {
    r[0] = x[0] - *std::ranges::min_element(sites_, {},
                                            [&](double site) { return std::abs(site - x[0]); });
    if (!jacobian.empty()) jacobian[0] = 1;
    return true;
  }

  /// The share of starts that lead to none of the minima.
  double unseen(const std::vector<Minimum>& minima) const {
    double share = 1;
    for (std::size_t i = 0; i < sites_.size(); ++i) {
      const bool seen = std::ranges::any_of(minima, [&](const Minimum& one) {
        return std::abs(one.solution.x[0] - sites_[i]) < 1e-7;
      });
      const double low = i > 0 ? 0.5 * (sites_[i - 1] + sites_[i]) : 0;
      const double high = i + 1 < sites_.size() ? 0.5 * (sites_[i] + sites_[i + 1]) : 1;
      if (seen) share -= high - low;
    }
    return share;
  }

 private:
  std::vector<double> sites_;
  std::vector<Variable> variables_ = boxes({{0, 1}});
};

/// The estimate of what was not seen, on the mean of many random functions, is that truth and a
/// little more, whether there are fewer minima than starts or more.
TEST(Search, EstimatesWhatItHasNotSeen) {
  constexpr int kFunctions = 300;
  for (const int minima : {5, 30, 120}) {
    for (const int starts : {20, 80}) {
      std::mt19937_64 random(static_cast<std::uint64_t>(minima * 1000 + starts));
      std::uniform_real_distribution<double> uniform(0, 1);
      double estimated = 0, truth = 0;
      for (int k = 0; k < kFunctions; ++k) {
        std::vector<double> sites;
        for (int i = 0; i < minima; ++i) sites.push_back(uniform(random));
        const Cells model(sites);
        SearchOptions options{.rule = {.starts = starts}, .designs = 200, .same_fit = 1e-9};
        options.same_minimum = 1e-9;
        options.seed = static_cast<std::uint64_t>(k);
        options.threads = 1;
        const SearchResult result = search(model, options);
        estimated += result.statistics.unseen / kFunctions;
        truth += model.unseen(result.minima) / kFunctions;
      }
      EXPECT_GE(estimated, truth - 0.01) << minima << " minima, " << starts << " starts";
      EXPECT_LE(estimated, truth + 1.0 / starts + 0.02) << minima << ", " << starts;
    }
  }
}

}  // namespace
}  // namespace cognate::synthesis::testing::search_test
