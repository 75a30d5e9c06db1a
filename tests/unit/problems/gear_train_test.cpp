/// Gear trains of files: published gearboxes, found trains against every choice of teeth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "problems/read.hpp"
#include "problems/train/result.hpp"
#include "problems/train/tooth_products.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::gear_train_test {
namespace {

GearTrainProblem library(const std::string& name) {
  const auto read =
      read_task<GearTrainProblem>(std::string(kLibraryFolder) + "/gear-train/" + name + ".toml");
  if (!read) throw std::runtime_error(read.error().front().message);
  return *read;
}

double number(const GearTrainDesign& design, std::string_view name) {
  const auto found = std::ranges::find(design.metrics, name, &Quantity::name);
  return found == design.metrics.end() ? NAN : std::get<double>(found->value);
}

TEST(GearTrainTest, SimpsonsTable) {
  // Published for this gearset with 28 and 62 teeth: 2.45, 1.45, 1 and −2.21 (TorqueFlite).
  const auto result = solve(library("simpson"), {});
  ASSERT_EQ(result.status, Status::solved);
  ASSERT_EQ(result.designs.size(), 4U);
  const double k = 62.0 / 28;
  const double expected[] = {(1 + 2 * k) / k, (1 + k) / k, 1, -k};
  const double published[] = {2.45, 1.45, 1, -2.21};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(number(result.designs[i], "ratio"), expected[i], 1e-14);
    EXPECT_NEAR(number(result.designs[i], "ratio"), published[i], 0.005);
    EXPECT_EQ(result.designs[i].constraints.size(), 4U);
  }
  // No gear rolls in direct drive, so nothing is lost; elsewhere a few per cent.
  EXPECT_NEAR(number(result.designs[2], "efficiency"), 1, 1e-12);
  for (const std::size_t i : {0U, 1U, 3U}) {
    EXPECT_GT(number(result.designs[i], "efficiency"), 0.95);
    EXPECT_LT(number(result.designs[i], "efficiency"), 0.995);
  }
}

TEST(GearTrainTest, AGreatReductionCannotBeDrivenBack) {
  const auto result = solve(library("ten-thousand-to-one"), {});
  const auto& design = result.designs.front();
  EXPECT_EQ(number(design, "ratio"), 10000);
  const double eta = 0.99 * 0.99, standing = 0.9999;
  EXPECT_NEAR(number(design, "efficiency"), (1 - standing) / (1 - standing * eta), 1e-12);
  const auto found = std::ranges::find(design.metrics, "reverse_self_locking", &Quantity::name);
  EXPECT_TRUE(std::get<bool>(found->value));
}

TEST(GearTrainTest, ADifferentialSharesTorqueEqually) {
  const auto design = solve(library("differential"), {}).designs.front();
  for (const auto& member : design.members) {
    if (member.name == "cage") {
      EXPECT_DOUBLE_EQ(member.speed, 50);
    }
    if (member.name == "left" || member.name == "right") {
      EXPECT_NEAR(*member.torque, 150, 1e-10);
    }
  }
}

TEST(GearTrainTest, ClockCountsSeconds) {
  const auto design = solve(library("clock"), {}).designs.front();
  EXPECT_NEAR(number(design, "ratio"), -1.0 / 720, 1e-18);
  EXPECT_NEAR(number(design, "efficiency"), 0.95 * 0.95 * 0.95, 1e-14);
  // 2e-7·720² + 3e-6·12²
  EXPECT_NEAR(number(design, "equivalent_inertia_kg_m2"), 0.104112, 1e-12);
}

// 16 · 19/(43 · 49): the least square of the error in 1/6.931, 2.70086e-12, of the many searches
// that were tried on it (Deb and Goyal, Computer Science and Informatics 26 (1996) 30-45).
TEST(GearTrainTest, TheBestTrainOfSandgren) {
  const auto result = solve(library("two-pairs"), {});
  ASSERT_EQ(result.status, Status::solved);
  const double ratio = number(result.designs.front(), "ratio");
  EXPECT_NEAR(ratio, 43.0 * 49 / (16 * 19), 1e-14);
  EXPECT_NEAR(std::pow(1 / 6.931 - 1 / ratio, 2), 2.700857e-12, 1e-17);
}

TEST(GearTrainTest, ProductsAreAllAndOnce) {
  for (const int count : {1, 2, 3}) {
    std::map<std::uint64_t, int> expected;
    const int lo = 12, hi = 26;
    const auto put = [&](std::uint64_t product, int sum) {
      const auto [place, is_new] = expected.emplace(product, sum);
      if (!is_new) place->second = std::min(place->second, sum);
    };
    for (int a = lo; a <= hi; ++a) {
      if (count == 1) put(std::uint64_t(a), a);
      for (int b = lo; b <= hi && count > 1; ++b) {
        if (count == 2) put(std::uint64_t(a * b), a + b);
        for (int c = lo; c <= hi && count > 2; ++c) put(std::uint64_t(a * b * c), a + b + c);
      }
    }
    const auto products = tooth_products({lo, hi}, count);
    ASSERT_EQ(products.size(), expected.size());
    auto next = expected.begin();
    for (const auto& product : products) {
      EXPECT_EQ(product.product, next->first);
      EXPECT_EQ(product.sum, next->second);
      const auto teeth = teeth_of(product, {lo, hi}, count);
      EXPECT_EQ(std::accumulate(teeth.begin(), teeth.end(), 0), product.sum);
      ++next;
    }
  }
}

/// The least error, and the least sum of teeth within `tolerance`, of all choices of two pairs.
struct Brute {
  double error = HUGE_VAL;
  int size = 1 << 30;
};

Brute by_trial(double ratio, int lo, int hi, double tolerance, bool coaxial) {
  Brute best;
  for (int a = lo; a <= hi; ++a)
    for (int b = lo; b <= hi; ++b)
      for (int c = lo; c <= hi; ++c)
        for (int d = lo; d <= hi; ++d) {
          if (coaxial && a + b != c + d) continue;
          const double error = std::abs(double(b) * d / (double(a) * c) / ratio - 1);
          best.error = std::min(best.error, error);
          if (error <= tolerance + 1e-15) best.size = std::min(best.size, a + b + c + d);
        }
  return best;
}

class FoundTrains : public ::testing::TestWithParam<double> {};

TEST_P(FoundTrains, AreThoseOfEveryChoice) {
  const int lo = 17, hi = 44;
  for (const bool coaxial : {false, true}) {
    for (const double tolerance : {1e-3, 0.02}) {
      const Brute brute = by_trial(GetParam(), lo, hi, tolerance, coaxial);
      GearTrainProblem problem;
      problem.target = TrainTarget{.ratio = GetParam(),
                                   .ratio_tolerance = tolerance,
                                   .teeth = {lo, hi},
                                   .pairs = {2, 2},
                                   .coaxial = coaxial,
                                   .designs = 1};
      const auto by_error = solve(problem, {});
      ASSERT_EQ(by_error.designs.size(), 1U);
      EXPECT_EQ(by_error.status == Status::solved, brute.error <= tolerance + 1e-15);
      EXPECT_NEAR(number(by_error.designs[0], "ratio_error"), brute.error, 1e-15);
      problem.target->objective = TrainObjective::size;
      const auto by_size = solve(problem, {});
      if (by_size.status == Status::solved) {
        EXPECT_EQ(number(by_size.designs[0], "teeth_sum"), brute.size);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Ratios, FoundTrains,
                         ::testing::Values(1.0, 3.14159265358979, 355.0 / 113, 4.0, 0.37, 5.9,
                                           2.718281828, 127.0 / 50));

TEST(GearTrainTest, TheBestFewAreTheBestFewOfAll) {
  const int lo = 15, hi = 32;
  const double ratio = 2.3456;
  std::set<std::pair<double, std::uint64_t>> all;
  for (int a = lo; a <= hi; ++a)
    for (int b = a; b <= hi; ++b)
      for (int c = lo; c <= hi; ++c)
        for (int d = c; d <= hi; ++d) {
          const std::uint64_t key = std::uint64_t(a * b) * 1000000 + std::uint64_t(c * d);
          all.emplace(std::abs(double(c * d) / (ratio * (a * b)) - 1), key);
        }
  std::vector<ToothQuotient> best;
  add_quotients(tooth_products({lo, hi}, 2), 2,
                {.ratio = ratio, .tolerance = 0.01, .by_size = false, .count = 20, .is_over = {}},
                best);
  ASSERT_EQ(best.size(), 20U);
  auto next = all.begin();
  for (const auto& quotient : best) EXPECT_NEAR(quotient.error, (next++)->first, 1e-15);
}

/// A train of one or two pairs, its error as a fraction.
struct ExactTrain {
  std::int64_t off = 0, of = 1;
  int size = 0;
  std::int64_t driver = 0, driven = 0;
  std::size_t pairs = 1;

  bool operator<(const ExactTrain& other) const {
    const std::int64_t own = off * other.of, its = other.off * of;
    return own != its ? own < its : std::tie(size, pairs) < std::tie(other.size, other.pairs);
  }
};

/// All trains for the ratio p/q by every choice of teeth, best first; of each quotient of products
/// the smallest.
std::vector<ExactTrain> every_train(std::int64_t p, std::int64_t q, int lo, int hi,
                                    std::size_t fewest) {
  std::map<std::tuple<std::size_t, std::int64_t, std::int64_t>, ExactTrain> all;
  const auto take = [&](std::size_t pairs, std::int64_t driver, std::int64_t driven, int size) {
    const ExactTrain own{
        std::abs(driven * q - driver * p), driver * p, size, driver, driven, pairs};
    const auto [at, added] = all.try_emplace({pairs, driver, driven}, own);
    if (!added && own < at->second) at->second = own;
  };
  for (int a = lo; a <= hi; ++a)
    for (int b = lo; b <= hi; ++b) {
      if (fewest == 1) take(1, a, b, a + b);
      for (int c = a; c <= hi; ++c)
        for (int d = b; d <= hi; ++d) take(2, a * c, b * d, a + b + c + d);
    }
  std::vector<ExactTrain> trains;
  for (const auto& [key, train] : all) trains.push_back(train);
  std::ranges::sort(trains, std::less<ExactTrain>{});
  return trains;
}

TEST(GearTrainTest, TrainsOfOneRatioGoBySize) {
  // 23/17 is missed by 1/1001 of 23023/17000, whichever teeth make it; 10/9 of 1001/900 likewise.
  for (const auto& [p, q, lo, hi, fewest] :
       {std::tuple(23023, 17000, 17, 23, 2), std::tuple(1001, 900, 25, 31, 1),
        std::tuple(7001, 5000, 12, 30, 1), std::tuple(999, 1000, 20, 27, 2)}) {
    GearTrainProblem problem;
    problem.target = TrainTarget{.ratio = double(p) / q,
                                 .ratio_tolerance = 0.05,
                                 .teeth = {lo, hi},
                                 .pairs = {fewest, 2},
                                 .designs = 12};
    const auto found = solve(problem, {});
    const auto brute = every_train(p, q, lo, hi, static_cast<std::size_t>(fewest));
    ASSERT_EQ(found.designs.size(), 12U);
    for (std::size_t i = 0; i < found.designs.size(); ++i) {
      EXPECT_EQ(number(found.designs[i], "teeth_sum"), brute[i].size) << p << " " << i;
      EXPECT_NEAR(number(found.designs[i], "ratio_error"),
                  double(brute[i].off) / double(brute[i].of), 1e-15);
    }
  }
}

TEST(GearTrainTest, OneRatioHasOneErrorBeyondTheDigitsOfADouble) {
  const std::uint64_t rest = 9998ULL * 9997 * 9996;
  for (const double wanted : {1.0001, 1.00010001, 0.9, 1.2345}) {
    EXPECT_EQ(ratio_error(10000 * rest, 9999 * rest, wanted), ratio_error(10000, 9999, wanted));
  }
}

TEST(GearTrainTest, TorquesThatLockATrainAreNoSolution) {
  // Two inputs, the torque of the output between them given: no sense of the power agrees.
  const auto train = parse_task<GearTrainProblem>(R"(kind = "gear-train"
mesh = [{gears = ["m1", "p3"], teeth = [15, 18]}, {gears = ["p3", "p4"], teeth = [18, 26]},
        {gears = ["p4", "m2"], teeth = [26, 89], type = "internal", efficiency = 0.924},
        {gears = ["m2", "p6"], teeth = [24, 14], efficiency = 0.927},
        {gears = ["p6", "m0"], teeth = [39, 67], efficiency = 0.933}]
planet = [{name = "p3", carrier = "m0"}, {name = "p4", carrier = "m0"}, {name = "p6", carrier = "m5"}]
input = [{member = "m0", speed = 23}, {member = "m1", speed = 56}]
output = {member = "m5", torque = 1}
)");
  ASSERT_TRUE(train) << train.error().front().message;
  const auto result = solve(*train, {});
  EXPECT_EQ(result.status, Status::infeasible);
  const auto& metrics = result.designs.front().metrics;
  const auto locks = std::ranges::find(metrics, "self_locking", &Quantity::name);
  ASSERT_NE(locks, metrics.end());
  EXPECT_TRUE(std::get<bool>(locks->value));
}

TEST(GearTrainTest, PlanetaryTrainsOfEveryArrangement) {
  // The ratios of the textbooks' table, k = ring/sun.
  using M = PlanetaryMember;
  const auto expected = [](M in, M out, double k) {
    if (in == M::sun) return out == M::carrier ? 1 + k : -k;
    if (in == M::ring) return out == M::carrier ? 1 + 1 / k : -1 / k;
    return out == M::sun ? 1 / (1 + k) : k / (1 + k);
  };
  for (const M in : {M::sun, M::ring, M::carrier}) {
    for (const M out : {M::sun, M::ring, M::carrier}) {
      if (in == out) continue;
      GearTrainProblem problem;
      problem.target = TrainTarget{.train = TrainType::planetary,
                                   .ratio = expected(in, out, 84.0 / 24),
                                   .ratio_tolerance = 0,
                                   .teeth = {24, 30},
                                   .ring_teeth = {84, 84},
                                   .input = in,
                                   .output = out};
      const auto result = solve(problem, {});
      ASSERT_EQ(result.status, Status::solved);
      EXPECT_EQ(result.designs[0].settled.meshes[0].teeth, (std::array{24, 30}));
      EXPECT_NEAR(number(result.designs[0], "ratio"), problem.target->ratio, 1e-14);
    }
  }
}

TEST(GearTrainTest, PlanetsThatDoNotFitAreSaid) {
  GearTrainProblem problem = library("planetary");
  problem.planets[0].count = 5;
  const auto result = solve(problem, {});
  EXPECT_EQ(result.status, Status::infeasible);
  EXPECT_FALSE(result.notes.empty());
}

TEST(GearTrainTest, ALoopThatSharesTheLoadHasNoTorques) {
  GearTrainProblem problem;
  problem.meshes = {{.gears = {"a", "b"}, .teeth = {20, 40}},
                    {.gears = {"a", "b"}, .teeth = {30, 60}}};
  problem.inputs = {{.member = "a"}};
  problem.output = TrainOutput{.member = "b"};
  const auto result = solve(problem, {});
  ASSERT_EQ(result.designs.size(), 1U);
  EXPECT_EQ(number(result.designs[0], "ratio"), -2);
  EXPECT_FALSE(result.designs[0].members[0].torque);
  EXPECT_FALSE(result.notes.empty());
}

}  // namespace
}  // namespace cognate::problems::gear_train_test
