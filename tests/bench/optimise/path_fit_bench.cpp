/// Least-squares solves of the search's inner loop: ten points of an ellipse at free crank angles,
/// nine dimensions and ten angles, from screened starts. The fit in SIMD lanes against Ceres on the
/// full problem (dense QR) and on the same by normal equations, and against the solver that takes
/// constraints; one thread each. `solves` counts starts brought to their minimum within 80
/// iterations, per second.
#include <benchmark/benchmark.h>
#include <ceres/cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "problems/path/model.hpp"
#include "problems/path/starts.hpp"
#include "synthesis/lanes/path_fit.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {
namespace {

constexpr int kStarts = 256;
constexpr int kIterations = 80;
constexpr double kTolerance = 1e-10;

PathProblem ellipse() {
  PathProblem problem;
  for (int j = 0; j < 10; ++j) {
    const double angle = 2 * M_PI * j / 10;
    problem.points.push_back({1.2 * std::cos(angle), 0.7 * std::sin(angle)});
  }
  return problem;
}

struct Start {
  PathModel model;
  std::vector<double> x;
};

const std::vector<Start>& starts() {
  static const std::vector<Start> all = [] {
    const PathProblem problem = ellipse();
    const PathStarts source(problem);
    std::vector<Start> drawn;
    for (std::uint64_t seed = 1; drawn.size() < kStarts; ++seed) {
      std::mt19937_64 random(seed);
      const auto start = source.draw(random, 256);
      if (!start) continue;
      PathModel model(problem, start->linkage.assembly, start->clockwise);
      auto x = model.variables_of(start->linkage, start->crank_angles);
      drawn.push_back({std::move(model), std::move(x)});
    }
    return drawn;
  }();
  return all;
}

double median(std::vector<double> costs) {
  const auto middle = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
  std::ranges::nth_element(costs, middle);
  return *middle;
}

void report(benchmark::State& state, const std::vector<double>& costs) {
  state.counters["solves"] =
      benchmark::Counter(kStarts, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["median_cost"] = median(costs);
}

void lanes(benchmark::State& state, InstructionSet set) {
  std::vector<double> costs;
  for (auto _ : state) {
    state.PauseTiming();
    std::vector<synthesis::PathFitState> states;
    for (const Start& start : starts()) states.push_back(start.model.lane_state(start.x));
    state.ResumeTiming();
    fit_paths(starts()[0].model.lane_fit(), states,
              {.most_iterations = kIterations, .tolerance = kTolerance, .set = set});
    costs.clear();
    for (const auto& fit : states) costs.push_back(fit.cost);
  }
  report(state, costs);
}

void with_solver(benchmark::State& state, synthesis::Solver solver) {
  std::vector<double> costs;
  for (auto _ : state) {
    costs.clear();
    for (const Start& start : starts()) {
      const auto solution = solve(solver, start.model, start.x,
                                  {.tolerance = kTolerance, .max_iterations = kIterations});
      costs.push_back(solution.objective);
    }
  }
  report(state, costs);
}

/// The two residuals of one point, as a block of their own for Ceres.
class PointError final : public ceres::CostFunction {
 public:
  explicit PointError(const PathProblem& whole, std::size_t j, Assembly assembly)
      : model_(at_point(whole, j), assembly, false) {
    set_num_residuals(2);
    mutable_parameter_block_sizes()->push_back(model_.global_count());
    mutable_parameter_block_sizes()->push_back(1);
  }

  bool Evaluate(double const* const* blocks, double* r, double** jacobians) const override {
    const int n = model_.global_count();
    double x[PathModel::dimensions + 1];
    std::copy_n(blocks[0], n, x);
    x[n] = blocks[1][0];
    double jacobian[2 * PathModel::dimensions], local[2];
    const std::span<double> none;
    const bool wanted = jacobians != nullptr;
    if (!model_.residuals({x, std::size_t(n) + 1}, {r, 2},
                          wanted ? std::span<double>{jacobian, std::size_t(2 * n)} : none,
                          wanted ? std::span<double>{local, 2} : none)) {
      return false;
    }
    if (wanted && jacobians[0]) std::copy_n(jacobian, 2 * n, jacobians[0]);
    if (wanted && jacobians[1]) std::copy_n(local, 2, jacobians[1]);
    return true;
  }

 private:
  static PathProblem at_point(PathProblem whole, std::size_t j) {
    whole.points = {whole.points[j]};
    return whole;
  }
  PathModel model_;
};

void ceres_blocks(benchmark::State& state) {
  const PathProblem problem = ellipse();
  std::vector<double> costs;
  for (auto _ : state) {
    costs.clear();
    for (const Start& start : starts()) {
      std::vector<double> x = start.x;
      const int n = start.model.global_count();
      ceres::Problem fit;
      for (std::size_t j = 0; j < problem.points.size(); ++j) {
        fit.AddResidualBlock(new PointError(problem, j, start.model.linkage(start.x).assembly),
                             nullptr, {x.data(), x.data() + n + j});
      }
      for (int i = 0; i < n; ++i) {
        fit.SetParameterLowerBound(x.data(), i, start.model.variables()[i].lower);
        fit.SetParameterUpperBound(x.data(), i, start.model.variables()[i].upper);
      }
      ceres::Solver::Options options;
      options.linear_solver_type = ceres::DENSE_QR;
      options.max_num_iterations = kIterations;
      options.function_tolerance = kTolerance;
      options.logging_type = ceres::SILENT;
      ceres::Solver::Summary summary;
      ceres::Solve(options, &fit, &summary);
      costs.push_back(2 * summary.final_cost);
    }
  }
  report(state, costs);
}
BENCHMARK(ceres_blocks)
    ->Name("ceres, a block for each point, dense QR")
    ->Unit(benchmark::kMillisecond);

const bool listed = [] {
  const auto add = [](const std::string& name, auto run) {
    benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
  };
  add("ceres, one block, normal equations",
      [](benchmark::State& state) { with_solver(state, synthesis::Solver::ceres); });
  add("constrained Gauss-Newton",
      [](benchmark::State& state) { with_solver(state, synthesis::Solver::gauss_newton); });
  for (const InstructionSet set : instruction_sets()) {
    add(std::string("lanes, ") + name(set), [set](benchmark::State& state) { lanes(state, set); });
  }
  return true;
}();

}  // namespace
}  // namespace cognate::problems

BENCHMARK_MAIN();
