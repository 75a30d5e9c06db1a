/// Designs on a raster: against the evaluation of every combination, by code of its own.
#include "synthesis/raster/raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "synthesis/raster/model_raster.hpp"

namespace cognate::synthesis::raster_test {
namespace {

/// ‖A x − b‖², within bounds and, on request, with one linear constraint n·x ≥ c.
class LinearModel final : public Model {
 public:
  LinearModel(int unknowns, int rows, std::mt19937& random, bool constrained)
      : unknowns_(unknowns), rows_(rows), constrained_(constrained) {
    std::normal_distribution<double> normal;
    for (int i = 0; i < unknowns; ++i) variables_.push_back({"x", -3, 3, 1});
    for (int i = 0; i < rows * unknowns; ++i) matrix_.push_back(normal(random));
    for (int i = 0; i < rows; ++i) right_.push_back(2 * normal(random));
    for (int i = 0; i < unknowns; ++i) normal_.push_back(normal(random));
  }

  std::span<const Variable> variables() const override { return variables_; }
  int residual_count() const override { return rows_; }
  int constraint_count() const override { return constrained_ ? 1 : 0; }

  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> /*local*/) const override {
    for (int row = 0; row < rows_; ++row) {
      r[row] = -right_[row];
      for (int i = 0; i < unknowns_; ++i) r[row] += matrix_[row * unknowns_ + i] * x[i];
    }
    std::copy_n(matrix_.begin(), jacobian.size(), jacobian.begin());
    return true;
  }

  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override {
    if (!constrained_) return;
    c[0] = -kLeast;
    for (int i = 0; i < unknowns_; ++i) c[0] += normal_[i] * x[i];
    std::copy_n(normal_.begin(), jacobian.size(), jacobian.begin());
  }

  static constexpr double kLeast = 0.4;

  /// The same by its definition, for the brute force.
  double value(const std::vector<double>& x) const {
    double sum = 0, along = 0;
    for (int row = 0; row < rows_; ++row) {
      double r = -right_[row];
      for (int i = 0; i < unknowns_; ++i) r += matrix_[row * unknowns_ + i] * x[i];
      sum += r * r;
    }
    for (int i = 0; i < unknowns_; ++i) along += normal_[i] * x[i];
    return constrained_ && along < kLeast ? std::numeric_limits<double>::infinity() : sum;
  }

 private:
  int unknowns_, rows_;
  bool constrained_;
  std::vector<Variable> variables_;
  std::vector<double> matrix_, right_, normal_;
};

struct Brute {
  double objective = std::numeric_limits<double>::infinity();
  std::vector<double> at;
};

void look(const LinearModel& model, const std::vector<std::vector<double>>& values,
          std::vector<double>& at, Brute& best) {
  if (at.size() == values.size()) {
    const double objective = model.value(at);
    if (objective < best.objective) best = {objective, at};
    return;
  }
  for (const double value : values[at.size()]) {
    at.push_back(value);
    look(model, values, at, best);
    at.pop_back();
  }
}

/// Every third axis a list of uneven values, the others multiples of 0.5 or 1.
std::vector<RasterAxis> random_axes(int count, std::mt19937& random,
                                    std::vector<std::vector<double>>& values) {
  std::vector<RasterAxis> axes;
  std::uniform_real_distribution<double> even(-3, 3);
  for (int i = 0; i < count; ++i) {
    std::vector<double> all;
    if (i % 3 == 2) {
      for (int k = 0; k < 5; ++k) all.push_back(even(random));
      axes.push_back({"list", RasterValues::list(all, -3, 3)});
    } else {
      const double step = i % 3 == 0 ? 0.5 : 1;
      for (int k = 0; k * step <= 6; ++k) all.push_back(-3 + k * step);
      axes.push_back({"step", RasterValues::multiples(step, -3, 3)});
    }
    values.push_back(std::move(all));
  }
  return axes;
}

/// The relaxations are convex: the search is exact, whichever way it takes.
void compare(int seed, bool constrained, double enumerate) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const int unknowns = 2 + seed % 4;
  const auto model =
      std::make_shared<LinearModel>(unknowns, unknowns + seed % 3, random, constrained);
  std::vector<std::vector<double>> values;
  const auto axes = random_axes(unknowns, random, values);
  std::vector<AxisVariable> places;
  for (int i = 0; i < unknowns; ++i) places.push_back({.variable = i});
  const ModelRaster task(axes, places, {model});
  RasterOptions options{.enumerate = enumerate};
  options.most_nodes = 1'000'000;
  const std::vector<RasterPoint> from{task.point(0, std::vector<double>(unknowns, 0.1))};
  const RasterResult found = search_raster(task, from, options);
  Brute best;
  std::vector<double> at;
  look(*model, values, at, best);
  ASSERT_EQ(found.designs.empty(), !std::isfinite(best.objective)) << "seed " << seed;
  EXPECT_TRUE(found.is_complete) << "seed " << seed;
  EXPECT_EQ(found.is_enumerated, found.combinations <= enumerate);
  EXPECT_DOUBLE_EQ(found.covered, found.combinations) << "seed " << seed;
  if (found.designs.empty()) return;
  EXPECT_NEAR(found.designs[0].objective, best.objective, 1e-9 * (1 + best.objective))
      << "seed " << seed;
  EXPECT_NEAR(found.bound, best.objective, 1e-9 * (1 + best.objective));
  for (int i = 0; i < unknowns; ++i) EXPECT_NEAR(found.designs[0].values[i], best.at[i], 1e-12);
  ASSERT_TRUE(found.relaxed);
  EXPECT_LE(found.relaxed->objective, best.objective + 1e-9);
}

TEST(Raster, BranchAndBoundFindsTheBestOfAllCombinations) {
  for (int seed = 0; seed < 200; ++seed) compare(seed, seed % 2 == 1, 0);
}

/// Several designs at each combination, of which some are not accepted.
class SeveralDesigns final : public RasterTask {
 public:
  static constexpr int kValues = 6, kForms = 3;

  explicit SeveralDesigns(std::mt19937& random) {
    std::uniform_real_distribution<double> objective(1, 2);
    for (const char* name : {"a", "b"}) {
      axes_.push_back({name, RasterValues::multiples(1, 0, kValues - 1)});
    }
    for (int i = 0; i < kValues * kValues * kForms; ++i) {
      objectives_.push_back(objective(random));
      accepted_.push_back(random() % 3 == 0);
    }
  }

  std::span<const RasterAxis> axes() const override { return axes_; }

  std::vector<RasterPoint> relax(const RasterBox& box,
                                 std::span<const RasterPoint> /*from*/) const override {
    std::vector<RasterPoint> all;
    for (int form = 0; form < kForms; ++form) {
      const auto a = box.first[0], b = box.first[1];
      all.push_back({{double(a), double(b)}, objectives_[place(a, b, form)], 0, {}, form});
    }
    return all;
  }

  bool accepts(const RasterPoint& point) const override {
    return accepted_[place(std::lround(point.values[0]), std::lround(point.values[1]), point.form)];
  }

  /// The least objective of an accepted design at each combination that has one, in order.
  std::vector<double> best_of_each() const {
    std::vector<double> all;
    for (int a = 0; a < kValues; ++a) {
      for (int b = 0; b < kValues; ++b) {
        double least = std::numeric_limits<double>::infinity();
        for (int form = 0; form < kForms; ++form) {
          const std::size_t at = place(a, b, form);
          if (accepted_[at]) least = std::min(least, objectives_[at]);
        }
        if (std::isfinite(least)) all.push_back(least);
      }
    }
    std::ranges::sort(all);
    return all;
  }

 private:
  static std::size_t place(std::int64_t a, std::int64_t b, int form) {
    return static_cast<std::size_t>((a * kValues + b) * kForms + form);
  }

  std::vector<RasterAxis> axes_;
  std::vector<double> objectives_;
  std::vector<bool> accepted_;
};

TEST(Raster, ARefusedDesignHidesNoOtherOfItsCombination) {
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    const SeveralDesigns task(random);
    const std::vector<double> best = task.best_of_each();
    ASSERT_GT(best.size(), 5U);
    const std::vector<RasterPoint> from = task.relax({{0, 0}, {0, 0}}, {});
    const RasterResult found = search_raster(task, from, {.designs = 5});
    ASSERT_TRUE(found.is_enumerated);
    ASSERT_EQ(found.designs.size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(found.designs[k].objective, best[k]) << i;
  }
}

TEST(Raster, EnumerationFindsTheBestOfAllCombinations) {
  for (int seed = 0; seed < 100; ++seed) compare(seed, seed % 2 == 1, 1e9);
}

TEST(Raster, ResultDoesNotDependOnThreads) {
  std::mt19937 random(5);
  const auto model = std::make_shared<LinearModel>(6, 7, random, true);
  std::vector<std::vector<double>> values;
  const auto axes = random_axes(6, random, values);
  std::vector<AxisVariable> places;
  for (int i = 0; i < 6; ++i) places.push_back({.variable = i});
  const ModelRaster task(axes, places, {model});
  const std::vector<RasterPoint> from{task.point(0, std::vector<double>(6, 0.1))};
  RasterOptions options{.designs = 3, .most_nodes = 200, .enumerate = 0};
  options.threads = 1;
  const RasterResult one = search_raster(task, from, options);
  options.threads = 3;
  const RasterResult three = search_raster(task, from, options);
  ASSERT_EQ(one.designs.size(), three.designs.size());
  for (std::size_t i = 0; i < one.designs.size(); ++i) {
    EXPECT_EQ(one.designs[i].values, three.designs[i].values);
    EXPECT_EQ(one.designs[i].objective, three.designs[i].objective);
  }
  EXPECT_EQ(one.bound, three.bound);
  EXPECT_EQ(one.covered, three.covered);
  EXPECT_EQ(one.evaluated, three.evaluated);
}

/// What a relaxation does not know of is asked of each design that would be kept.
class OddSums final : public ModelRaster {
 public:
  using ModelRaster::ModelRaster;
  bool accepts(const RasterPoint& point) const override {
    double sum = 0;
    for (const double value : point.values) sum += value;
    return std::abs(std::remainder(sum - 1, 2)) < 1e-9;
  }
};

TEST(Raster, KeepsOnlyDesignsThatAreAccepted) {
  for (const double enumerate : {0.0, 1e9}) {
    for (int seed = 0; seed < 30; ++seed) {
      std::mt19937 random(static_cast<unsigned>(seed));
      const auto model = std::make_shared<LinearModel>(3, 4, random, false);
      std::vector<RasterAxis> axes(3, {"whole", RasterValues::multiples(1, -3, 3)});
      const OddSums task(axes, {{.variable = 0}, {.variable = 1}, {.variable = 2}}, {model});
      const std::vector<RasterPoint> from{task.point(0, {0.1, 0.1, 0.1})};
      const RasterResult found =
          search_raster(task, from, {.most_nodes = 100'000, .enumerate = enumerate});
      double best = std::numeric_limits<double>::infinity();
      for (int i = -3; i <= 3; ++i) {
        for (int j = -3; j <= 3; ++j) {
          for (int k = -3; k <= 3; ++k) {
            if ((i + j + k) % 2 == 0) continue;
            best = std::min(best, model->value({double(i), double(j), double(k)}));
          }
        }
      }
      ASSERT_FALSE(found.designs.empty());
      EXPECT_TRUE(found.is_complete);
      EXPECT_NEAR(found.designs[0].objective, best, 1e-9 * (1 + best)) << "seed " << seed;
    }
  }
}

/// One axis, and something free beside it whose minima near what is known are poor, or break a
/// limit that `violation` knows; a search of its own finds the good one.
class HiddenMinima final : public RasterTask {
 public:
  explicit HiddenMinima(bool known_are_sound) : known_are_sound_(known_are_sound) {}

  static double good(double value) { return 1 + (value - 3) * (value - 3); }
  static double poor(double value) { return 100 + (value - 8) * (value - 8); }

  std::span<const RasterAxis> axes() const override { return axes_; }
  std::vector<RasterPoint> relax(const RasterBox& box,
                                 std::span<const RasterPoint> /*from*/) const override {
    const double at = axes_[0].values.at(box.first[0]);
    return {{.values = {at}, .objective = poor(at), .violation = known_are_sound_ ? 0.0 : 1.0}};
  }
  std::vector<RasterPoint> search(const RasterNumbers& at) const {
    const double value = axes_[0].values.at(at[0]);
    return {{.values = {value}, .objective = good(value)}};
  }

 private:
  bool known_are_sound_;
  std::vector<RasterAxis> axes_{{"whole", RasterValues::multiples(1, 0, 9)}};
};

TEST(Raster, SearchesWhatIsFreeBesideItAtTheMostPromisingCombinations) {
  for (const bool known_are_sound : {true, false}) {
    const HiddenMinima task(known_are_sound);
    const RasterPoint from{.values = {0}};
    const auto found = [&](std::size_t searched, int threads) {
      return search_raster(task, std::span(&from, 1),
                           {.search = [&](const RasterNumbers& at) { return task.search(at); },
                            .searched = searched,
                            .threads = threads});
    };
    const RasterResult all = found(10, 1), three = found(3, 1);
    EXPECT_EQ(all.searched, 10u);
    ASSERT_EQ(all.designs.size(), 1u);
    EXPECT_EQ(all.designs.front().objective, HiddenMinima::good(3));
    EXPECT_EQ(all.bound, all.designs.front().objective);
    // The three that look best are 7, 8 and 9.
    EXPECT_EQ(three.searched, 3u);
    ASSERT_EQ(three.designs.size(), 1u);
    EXPECT_EQ(three.designs.front().objective, HiddenMinima::good(7));
    EXPECT_EQ(found(3, 4).designs.front().values, three.designs.front().values);
  }
}

TEST(RasterValues, AreTheDoublesNearestToTheMultiples) {
  const RasterValues tenths = RasterValues::multiples(0.1, 0.05, 0.95);
  ASSERT_EQ(tenths.count(), 9);
  EXPECT_EQ(tenths.at(2), 0.3);
  EXPECT_EQ(tenths.at(8), 0.9);
  EXPECT_EQ(tenths.floor(0.3), 2);
  EXPECT_EQ(tenths.floor(std::nextafter(0.3, 0)), 1);
  EXPECT_EQ(tenths.nearest(0.36), 3);
  EXPECT_EQ(tenths.nearest(-5), 0);
  EXPECT_EQ(tenths.nearest(5), 8);
  EXPECT_EQ(tenths.floor(0.05), -1);
  EXPECT_NEAR(tenths.position(0.35), 2.5, 1e-12);
  EXPECT_EQ(RasterValues::multiples(0.5, 0.7, 0.9).count(), 0);
  const RasterValues thirds = RasterValues::multiples(1.0 / 3, 0, 2);
  EXPECT_EQ(thirds.count(), 7);
  const RasterValues few = RasterValues::list({50, 40, 45, 40, 99}, 0, 60);
  ASSERT_EQ(few.count(), 3);
  EXPECT_EQ(few.at(1), 45);
  EXPECT_EQ(few.nearest(47.6), 2);
}

}  // namespace
}  // namespace cognate::synthesis::raster_test
