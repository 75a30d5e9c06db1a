/// Certificates as a user meets them: published problems are proved, what a file says reaches the
/// bound as it is meant, and neither threads nor an interrupt make a proof wrong.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <variant>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/function/certificate.hpp"
#include "problems/function/generator.hpp"
#include "problems/path/certificate.hpp"
#include "problems/path/model.hpp"
#include "problems/path/scale.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::certificates_test {
namespace {

template <class Kind>
Kind of_library(const std::string& name) {
  const auto read = read_task(std::filesystem::path(kLibraryFolder) / name);
  return std::get<Kind>(read.value());
}

template <class... Given>
Certificate certified(const problems::Run& run, const Given&... given) {
  return certify(given..., run, Deadline(run));
}

// Best known errors of others' searches and ours: see the files.
TEST(Certificates, ProveThePublishedSemicircle) {
  const auto problem = of_library<PathProblem>("path/semicircle.toml");
  constexpr double kBest = 2.580355625505;
  const Certificate proof = certified({}, problem, kBest);
  EXPECT_TRUE(proof.complete);
  EXPECT_NEAR(proof.lower_bound, kBest, 1.001e-3 * kBest);
  EXPECT_LE(proof.lower_bound, kBest);
}

TEST(Certificates, ProveThePublishedParabola) {
  const auto problem = of_library<FunctionProblem>("function/crank-rocker-parabola.toml");
  constexpr double kBest = 0.007592373605334677;
  const Certificate proof = certified({}, problem, function_samples(problem), kBest);
  EXPECT_TRUE(proof.complete);
  EXPECT_NEAR(proof.lower_bound, kBest, 1.001e-3 * kBest);
}

/// Four unknowns, over fewer links than the file allows so that it is quickly done.
PathProblem short_links() {
  auto problem = of_library<PathProblem>("path/textbook-eight-points.toml");
  problem.crank_sense = CrankSense::ccw;
  problem.constraints.link_ratio_max = 4;
  problem.solve.certify_gap = 0.3;
  return problem;
}

TEST(Certificates, ProvePathsWithFourUnknowns) {
  constexpr double kUpper = 0.6010945318;
  const Certificate proof = certified({}, short_links(), kUpper);
  EXPECT_TRUE(proof.complete);
  EXPECT_NEAR(proof.lower_bound, 0.7 * kUpper, 1e-9);
}

// Where time ends, the bound is the last that was proved everywhere.
TEST(Certificates, StateTheLastStageThatEnded) {
  problems::Run brief;
  brief.time_limit = 0.5;
  const auto problem = of_library<PathProblem>("path/textbook-eight-points.toml");
  constexpr double kBest = 0.5780747028;
  for (const double upper : {kBest, 2 * kBest}) {
    const Certificate proof = certified(brief, problem, upper);
    EXPECT_FALSE(proof.complete);
    EXPECT_LE(proof.lower_bound, kBest);
    double nearest = proof.lower_bound;
    for (const double share : {0.1, 0.5, 0.9}) {
      nearest = std::min(nearest, std::abs(proof.lower_bound - share * upper));
    }
    EXPECT_LT(nearest, 1e-9);
  }
}

// A design twice as good as any cannot be proved to be near the best: a bound that is too high
// would do so.
TEST(Certificates, DoNotProveWhatIsNotSo) {
  const auto path = of_library<PathProblem>("path/semicircle.toml");
  problems::Run brief;
  brief.time_limit = 0.5;
  const Certificate proof = certified(brief, path, 2 * 2.580355625505);
  EXPECT_LE(proof.lower_bound, 2.580355625505);
  EXPECT_FALSE(proof.complete);
  const auto function = of_library<FunctionProblem>("function/crank-rocker-parabola.toml");
  const Certificate other =
      certified(brief, function, function_samples(function), 2 * 0.007592373605334677);
  EXPECT_LE(other.lower_bound, 0.007592373605334677);
}

TEST(Certificates, DoNotDependOnThreads) {
  const auto problem = of_library<FunctionProblem>("function/crank-rocker-parabola.toml");
  const auto wanted = function_samples(problem);
  problems::Run one, many;
  one.threads = 1;
  many.threads = 5;
  const Certificate a = certified(one, problem, wanted, 0.007592373605334677);
  const Certificate b = certified(many, problem, wanted, 0.007592373605334677);
  EXPECT_EQ(a.boxes, b.boxes);
  EXPECT_EQ(a.lower_bound, b.lower_bound);
}

TEST(Certificates, EndWhenInterrupted) {
  const std::atomic<bool> interrupted{true};
  problems::Run run;
  run.interrupted = &interrupted;
  const auto problem = of_library<PathProblem>("path/eighteen-points.toml");
  const Certificate proof = certified(run, problem, 0.009028884631);
  EXPECT_FALSE(proof.complete);
  EXPECT_GE(proof.lower_bound, 0);
  EXPECT_LE(proof.gap_relative, 1);
}

TEST(Certificates, OfPointsThatAreMet) {
  const auto problem = of_library<PathProblem>("path/semicircle.toml");
  const Certificate proof = certified({}, problem, 1e-25);
  EXPECT_TRUE(proof.complete);
  EXPECT_EQ(proof.gap_relative, 0);
}

/// A box about a design: ξ and η, or δ and σ, by their definitions.
synthesis::ProportionBox box_about(const Lengths<double>& links, double assembly, double phase,
                                   synthesis::Proportions proportions, double half) {
  const double base = links.crank + links.frame;
  const double k = links.frame / base, difference = (links.coupler - links.rocker) / base;
  const double inverse = base / (links.coupler + links.rocker);
  const bool any = proportions == synthesis::Proportions::any;
  const double first = any ? difference : std::acos(difference / std::abs(2 * k - 1));
  const double second = any ? inverse / (1 + inverse) : std::acos(inverse);
  synthesis::ProportionBox box;
  box.proportions = proportions;
  box.assembly = assembly > 0 ? 1 : -1;
  box.side = {synthesis::Interval(k - half, k + half),
              synthesis::Interval(first - half, first + half),
              synthesis::Interval(second - half, second + half),
              synthesis::Interval(phase - half, phase + half)};
  return box;
}

/// Timed paths of every reference, with parts given and without: the error of a random design, by
/// the kernel alone, is no less than the bound of a box about it, for targets just above it.
TEST(Certificates, PathFilesReachTheBoundAsTheyAreMeant) {
  std::mt19937_64 random(5);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto chance = [&](double share) { return uniform(0, 1) < share; };
  int tight = 0, all = 0;
  for (int i = 0; i < 600; ++i) {
    FourBar design{.pivot_a = {uniform(-3, 3), uniform(-3, 3)},
                   .pivot_d = {},
                   .crank = uniform(0.5, 1),
                   .coupler = uniform(2, 3),
                   .rocker = uniform(2, 3),
                   .assembly = chance(0.5) ? Assembly::open : Assembly::crossed,
                   .coupler_point = Vec2d{uniform(-2, 2), uniform(-2, 2)}};
    const double direction = uniform(-kPi, kPi), frame = uniform(2, 2.6);
    design.pivot_d = design.pivot_a + frame * Vec2d{std::cos(direction), std::sin(direction)};
    PathProblem problem;
    problem.timing = Timing::prescribed;
    problem.crank_reference =
        std::array{CrankReference::first, CrankReference::frame, CrankReference::global}[i % 3];
    problem.crank_sense = chance(0.5) ? CrankSense::ccw : CrankSense::cw;
    const bool clockwise =
        problem.crank_reference == CrankReference::first && problem.crank_sense == CrankSense::cw;
    const double first = uniform(-kPi, kPi), blur = std::pow(10.0, uniform(-4, 0));
    Design finished;
    finished.mechanism = named(design);
    for (int j = 0; j < 7; ++j) {
      const double increment = 0.8 * j + uniform(0, 0.3);
      const double angle = first + (clockwise ? -increment : increment);
      const double offset = problem.crank_reference == CrankReference::first   ? first
                            : problem.crank_reference == CrankReference::frame ? direction
                                                                               : 0;
      problem.crank_angles.push_back(clockwise ? increment : angle - offset);
      finished.crank_angles.push_back(angle);
      problem.points.push_back(*Motion(design).at(angle)->coupler_point +
                               blur * Vec2d{uniform(-1, 1), uniform(-1, 1)});
      problem.weights.push_back(uniform(0.5, 2));
    }
    const double start = finished.crank_angles.front() - direction;
    if (chance(0.4)) problem.given.pivot_a = design.pivot_a;
    if (chance(0.4)) problem.given.frame_angle = direction;
    if (chance(0.2)) problem.given.pivot_d = design.pivot_d;
    if (chance(0.3)) problem.given.crank = design.crank;
    if (chance(0.3)) problem.bounds.frame = Range{frame - uniform(0, 1), frame + uniform(0, 1)};
    if (chance(0.3)) problem.bounds.coupler_point = Box{{-2, -2}, {2, 2}};
    if (chance(0.5)) problem.constraints.required_class = RequiredClass::crank_rocker;
    const PathDomain domain = path_domain(problem);
    ASSERT_EQ(domain.bounds.size(), 1u);
    const double error = path_objective(problem, finished);
    const auto proportions =
        chance(0.5) ? synthesis::Proportions::crank_shortest : synthesis::Proportions::any;
    // Where the crank's angle is zero at the first increment, from the frame, or from the x axis.
    const double phase = problem.crank_reference == CrankReference::first   ? start
                         : problem.crank_reference == CrankReference::frame ? 0
                                                                            : -direction;
    const double half = std::pow(10.0, uniform(-9, -3));
    const auto box = box_about(lengths(design), sign(design.assembly), phase, proportions, half);
    const double target = error / domain.to_file;
    const auto bound = domain.bounds[0](box, target * (1 + 1e-9));
    ASSERT_LE(bound.least, target * (1 + 1e-10)) << i;
    // And the bound does see the points: far more is not proved, but something is.
    ++all;
    if (bound.least > 1e-3 * target) ++tight;
  }
  EXPECT_GT(tight, all / 4);
}

TEST(Certificates, FunctionFilesReachTheBoundAsTheyAreMeant) {
  std::mt19937_64 random(6);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto chance = [&](double share) { return uniform(0, 1) < share; };
  int tight = 0, all = 0;
  for (int i = 0; i < 600; ++i) {
    FunctionGenerator generator{.links = {1, uniform(2, 3), uniform(2, 3), uniform(2, 2.6)},
                                .assembly = chance(0.5) ? Assembly::open : Assembly::crossed,
                                .input_start = uniform(-kPi, kPi)};
    const double blur = std::pow(10.0, uniform(-4, -1));
    AnglePairs pairs;
    for (int j = 0; j < 7; ++j) pairs.push_back({0.4 * j, 0});
    generator.output_start = 0;
    for (auto& [input, output] : pairs) {
      output = *StructuralError(generator).at({input, 0}) + blur * uniform(-1, 1);
    }
    FunctionProblem problem;
    problem.target = pairs;
    problem.given.crank = 1;
    if (chance(0.5)) problem.input_start = generator.input_start;
    if (chance(0.5)) problem.output_start = 0;
    if (chance(0.3)) problem.given.frame = generator.links.frame;
    const FunctionSamples wanted = function_samples(problem);
    if (!problem.output_start) {
      generator.output_start = best_output_start(generator, wanted.samples).value();
    }
    const double error = StructuralError(generator).sum_of_squares(wanted.samples);
    const FunctionDomain domain = function_domain(problem, wanted);
    const auto proportions =
        chance(0.5) ? synthesis::Proportions::crank_shortest : synthesis::Proportions::any;
    const auto box = box_about(generator.links, sign(generator.assembly), generator.input_start,
                               proportions, std::pow(10.0, uniform(-9, -3)));
    const auto bound = domain.bound(box, error * (1 + 1e-9));
    ASSERT_LE(bound.least, error * (1 + 1e-10)) << i;
    ++all;
    if (bound.least > 1e-3 * error) ++tight;
  }
  EXPECT_GT(tight, all / 4);
}

}  // namespace
}  // namespace cognate::problems::certificates_test
