/// Fits of function generators in SIMD lanes: they end where the model, which measures true angles,
/// has its minimum; the screen orders linkages as their structural errors do.
#include "synthesis/lanes/function_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "problems/function/found.hpp"
#include "problems/function/model.hpp"
#include "problems/read.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems::function_fit_test {
namespace {

using synthesis::FunctionFitOptions;
using synthesis::FunctionFitState;

FunctionProblem parsed(const std::string& more) {
  return std::get<FunctionProblem>(*parse_task(
      "kind = \"function-generation\"\n[target]\nfunction = \"sqrt(x)\"\ndomain = [1, 10]\n"
      "input_range_deg = 90\noutput_range_deg = 90\nsamples = 31\n[mechanism]\nframe = 1\n" +
      more));
}

/// A linkage about which the starts of the tests lie: the best known for the square root.
const FunctionGenerator good{{1.0612, 3.3001, 2.6447, 1}, Assembly::open, 0.8731, -0.3732};

std::vector<FunctionGenerator> near_good(int count) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> change(-0.05, 0.05);
  std::vector<FunctionGenerator> all(count, good);
  for (FunctionGenerator& g : all) {
    g.links.crank *= 1 + change(random);
    g.links.coupler *= 1 + change(random);
    g.links.rocker *= 1 + change(random);
    g.input_start += change(random);
    g.output_start += change(random);
  }
  return all;
}

std::vector<FunctionFitState> fitted(const FunctionModel& model,
                                     const std::vector<FunctionGenerator>& from,
                                     const FunctionFitOptions& options) {
  std::vector<FunctionFitState> states;
  for (const FunctionGenerator& g : from) {
    states.push_back({{g.links.crank, g.links.coupler, g.links.rocker, g.links.frame},
                      g.input_start,
                      g.output_start,
                      sign(g.assembly)});
  }
  fit_functions(model.lane_fit(), states, options);
  return states;
}

FunctionGenerator generator(const FunctionFitState& state) {
  const auto [crank, coupler, rocker, frame] = state.length;
  return {{crank, coupler, rocker, frame},
          state.assembly > 0 ? Assembly::open : Assembly::crossed,
          state.input_start,
          state.output_start};
}

FunctionModel model_of(const FunctionProblem& problem, const FunctionSamples& samples) {
  return {problem, samples, good.assembly, synthesis::Objective::sum_of_squares,
          Closing::unguarded};
}

TEST(FunctionFit, EndsAtMinimaThatCeresFinds) {
  for (const char* more : {"", "input_start_deg = 49\n", "output_start_deg = -20\ncrank = 1.1\n",
                           "[bounds]\nrocker = [2.6, 2.62]\n"}) {
    SCOPED_TRACE(more);
    const FunctionProblem problem = parsed(more);
    const FunctionSamples samples = function_samples(problem);
    const FunctionModel model = model_of(problem, samples);
    auto from = near_good(20);
    for (FunctionGenerator& g : from) g = model.generator(model.variables_of(g));
    const auto states = fitted(model, from, {.most_iterations = 500, .tolerance = 1e-15});
    int closing = 0;
    for (const FunctionFitState& state : states) {
      const FunctionGenerator reached = generator(state);
      const double error = StructuralError(reached).sum_of_squares(samples.samples);
      EXPECT_EQ(std::isfinite(error), std::isfinite(state.cost));
      if (!std::isfinite(error)) continue;
      ++closing;
      EXPECT_NEAR(error, state.cost, 1e-3 * error);  // 2 tan(e/2) is e but for its cube
      const auto further =
          solve(synthesis::Solver::ceres, model, model.variables_of(reached), {.tolerance = 1e-15});
      EXPECT_NEAR(further.objective, error, 1e-4 * error);
    }
    EXPECT_GT(closing, 10);
  }
}

TEST(FunctionFit, KeepsTransmissionWithinItsLimits) {
  const FunctionProblem problem = parsed("[constraints]\ntransmission_angle_deg = [50, 130]\n");
  const FunctionSamples samples = function_samples(problem);
  const FunctionModel model(problem, samples, good.assembly, synthesis::Objective::sum_of_squares);
  const auto from = near_good(1);
  const auto state = fitted(model, from, {.most_iterations = 2000, .tolerance = 1e-15}).front();
  const auto x = model.variables_of(generator(state));
  std::vector<double> c(model.constraint_count());
  model.constraints(x, c, {});
  EXPECT_GT(*std::ranges::min_element(c), -0.02);
  const auto exact =
      solve(synthesis::Solver::slsqp, model, model.variables_of(from[0]), {.tolerance = 1e-13});
  EXPECT_LE(exact.violation, 1e-9);
  EXPECT_NEAR(state.cost, exact.objective, 0.2 * exact.objective);
}

TEST(FunctionFit, DoesNotDependOnThreadsOrNeighbours) {
  const FunctionProblem problem = parsed("");
  const FunctionSamples samples = function_samples(problem);
  const FunctionModel model = model_of(problem, samples);
  const auto from = near_good(150);
  const auto one = fitted(model, from, {.threads = 1}), many = fitted(model, from, {.threads = 4});
  for (std::size_t i = 0; i < from.size(); ++i) EXPECT_EQ(one[i].length, many[i].length);
  const auto alone = fitted(model, {from[99]}, {});
  EXPECT_EQ(alone[0].length, one[99].length);
}

TEST(FunctionFit, ReachesTheSameOnEveryInstructionSet) {
  const FunctionProblem problem = parsed("");
  const FunctionSamples samples = function_samples(problem);
  const FunctionModel model = model_of(problem, samples);
  const auto from = near_good(10);
  FunctionFitOptions options{.most_iterations = 500, .tolerance = 1e-15};
  const auto widest = fitted(model, from, options);
  for (const InstructionSet set : instruction_sets()) {
    options.set = set;
    const auto states = fitted(model, from, options);
    for (std::size_t i = 0; i < from.size(); ++i) {
      EXPECT_NEAR(states[i].cost, widest[i].cost, 1e-5 * widest[i].cost) << name(set);
    }
  }
}

/// What `fit_freudenstein` finds for one pair of start angles, by the dense fit.
std::optional<synthesis::FreudensteinRatios> dense_ratios(std::vector<synthesis::AnglePair> pairs,
                                                          double input_start, double output_start,
                                                          int reweightings) {
  for (auto& pair : pairs) {
    pair.input += input_start;
    pair.output += output_start;
  }
  auto ratios = synthesis::freudenstein_fit(pairs);
  for (int k = 0; ratios && k < reweightings; ++k) {
    std::vector<double> weights;
    double mean = 0;
    for (const auto& [input, output] : pairs) {
      const double slope =
          ratios->p[0] * std::sin(output) + ratios->p[1] * std::sin(output - input);
      weights.push_back(slope * slope);
      mean += slope * slope / double(pairs.size());
    }
    for (double& weight : weights) weight = 1 / (weight + 1e-3 * mean);
    ratios = synthesis::freudenstein_fit(pairs, weights);
  }
  return ratios;
}

TEST(FreudensteinLanes, FindTheRatiosOfTheDenseFit) {
  const FunctionSamples samples = function_samples(parsed(""));
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (const int reweightings : {0, 2}) {
    synthesis::StartAngles starts(200);
    std::vector<std::array<double, 2>> angles;
    for (std::size_t i = 0; i < 200; ++i) {
      angles.push_back({angle(random), angle(random)});
      starts.input_x[i] = std::cos(angles[i][0]);
      starts.input_y[i] = std::sin(angles[i][0]);
      starts.output_x[i] = std::cos(angles[i][1]);
      starts.output_y[i] = std::sin(angles[i][1]);
    }
    fit_freudenstein(samples.samples, reweightings, starts);
    int compared = 0;
    for (std::size_t i = 0; i < 200; ++i) {
      const auto dense = dense_ratios(samples.samples, angles[i][0], angles[i][1], reweightings);
      if (!dense || dense->condition > 1e9) continue;
      for (int k = 0; k < 3; ++k) {
        const double size = std::abs(dense->p[0]) + std::abs(dense->p[1]) + std::abs(dense->p[2]);
        EXPECT_NEAR(starts.ratios[k][i], dense->p[k], 1e-15 * dense->condition * size);
      }
      ++compared;
    }
    EXPECT_GT(compared, 150);
  }
}

/// Against the structural errors themselves, with the best output start found by directions.
TEST(FunctionScreen, MeasuresChordsOfTheErrors) {
  const FunctionSamples samples = function_samples(parsed(""));
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> length(0.3, 3), angle(-3, 3);
  synthesis::FunctionCandidates candidates(400);
  std::vector<FunctionGenerator> all;
  for (std::size_t i = 0; i < 400; ++i) {
    FunctionGenerator g{
        {length(random), length(random), length(random), 1}, Assembly::open, angle(random), 0};
    candidates.crank[i] = g.links.crank;
    candidates.coupler[i] = g.links.coupler;
    candidates.rocker[i] = g.links.rocker;
    candidates.frame[i] = g.links.frame;
    candidates.half_start_x[i] = std::cos(0.5 * g.input_start);
    candidates.half_start_y[i] = std::sin(0.5 * g.input_start);
    all.push_back(g);
  }
  screen(samples.samples, synthesis::OutputStart::best, candidates);
  int closing = 0;
  for (std::size_t i = 0; i < 400; ++i) {
    for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
      FunctionGenerator g = all[i];
      g.assembly = assembly;
      const double found = assembly == Assembly::open ? candidates.open[i] : candidates.crossed[i];
      const auto start = best_output_start(g, samples.samples);
      EXPECT_EQ(start.has_value(), std::isfinite(found));
      if (!start) continue;
      g.output_start = *start;
      double chords = 0;
      for (const auto& pair : samples.samples) {
        const double half = 0.5 * StructuralError(g).at(pair).value();
        chords += 4 * std::sin(half) * std::sin(half);
      }
      EXPECT_NEAR(found, chords / double(samples.samples.size()), 1e-12);
      ++closing;
    }
  }
  EXPECT_GT(closing, 50);
}

}  // namespace
}  // namespace cognate::problems::function_fit_test
