/// Fits in SIMD lanes: they end where the path model, which shares no code with them but the
/// closure, has its minimum; the same on any number of threads and on every instruction set.
#include "synthesis/lanes/path_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/linkage/motion.hpp"
#include "problems/path/model.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems::path_fit_test {
namespace {

using synthesis::PathFitOptions;
using synthesis::PathFitState;

const FourBar linkage{{0.2, -0.3}, {2.1, 0.9}, 0.8, 1.9, 1.6, Assembly::open, Vec2d{1.1, 0.7}};
const std::vector<double> angles{0.4, 0.9, 1.3, 1.7, 2.2, 2.6, 3.0, 3.9, 4.5, 5.4, 6.0};

/// Points near those of the linkage, so that the least error is not zero.
PathProblem noisy(Timing timing, CrankReference reference) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0, 0.01);
  PathProblem problem;
  problem.timing = timing;
  problem.crank_reference = reference;
  // Ceres knows no constraints, and the lanes none of closure between the points.
  problem.constraints.no_circuit_defect = problem.constraints.no_order_defect = false;
  for (const double angle : angles) {
    const Vec2d at = *Motion(linkage).at(angle)->coupler_point;
    problem.points.push_back({at.x + noise(random), at.y + noise(random)});
    const double from_frame = angle - frame_angle(linkage);
    if (timing == Timing::free) continue;
    problem.has_crank_angle.push_back(problem.points.size() % 3 != 1);
    problem.crank_angles.push_back(reference == CrankReference::frame ? from_frame : angle);
  }
  return problem;
}

struct Case {
  const char* name;
  PathProblem problem;
};

std::vector<Case> cases() {
  std::vector<Case> all{{"free", noisy(Timing::free, CrankReference::first)},
                        {"first", noisy(Timing::prescribed, CrankReference::first)},
                        {"frame", noisy(Timing::prescribed, CrankReference::frame)},
                        {"global", noisy(Timing::prescribed, CrankReference::global)},
                        {"mixed, first", noisy(Timing::mixed, CrankReference::first)},
                        {"mixed, frame", noisy(Timing::mixed, CrankReference::frame)}};
  for (const Timing timing : {Timing::free, Timing::prescribed, Timing::mixed}) {
    PathProblem fixed = noisy(timing, CrankReference::global);
    fixed.given.pivot_d = linkage.pivot_d;
    fixed.given.coupler = linkage.coupler;
    fixed.weights = {1, 2, 0.5, 1, 3, 1, 1, 0.2, 1, 1, 2};
    all.push_back({"anchored at D, coupler fixed, weighted", fixed});
    fixed.bounds.rocker = Range{1, 1.5};
    all.push_back({"rocker at its bound", fixed});
  }
  return all;
}

/// Variables of linkages that differ from the planted one by some per cent.
std::vector<std::vector<double>> starts(const PathModel& model, int count) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> change(-0.1, 0.1);
  std::vector<std::vector<double>> all(count, model.variables_of(linkage, angles));
  for (auto& x : all) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto& variable = model.variables()[i];
      x[i] = std::clamp(x[i] + change(random), variable.lower, variable.upper);
    }
  }
  return all;
}

std::vector<PathFitState> fitted(const PathModel& model,
                                 const std::vector<std::vector<double>>& from,
                                 const PathFitOptions& options) {
  std::vector<PathFitState> states;
  for (const auto& x : from) states.push_back(model.lane_state(x));
  fit_paths(model.lane_fit(), states, options);
  return states;
}

double objective(const PathModel& model, const std::vector<double>& x) {
  std::vector<double> r(model.residual_count());
  if (!model.residuals(x, r, {}, {})) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const double value : r) sum += value * value;
  return sum;
}

TEST(PathFit, EndsAtMinimaThatCeresFinds) {
  const PathFitOptions options{.most_iterations = 400, .tolerance = 1e-15};
  for (const auto& [name, problem] : cases()) {
    SCOPED_TRACE(name);
    const PathModel model(problem, linkage.assembly, false);
    const auto from = starts(model, 30);
    const auto states = fitted(model, from, options);
    for (std::size_t i = 0; i < from.size(); ++i) {
      const auto x = model.variables_of(states[i], from[i]);
      const double reached = objective(model, x);
      EXPECT_NEAR(reached, states[i].cost, 1e-9 * reached);
      const auto further = solve(synthesis::Solver::ceres, model, x, {.tolerance = 1e-15});
      EXPECT_GE(further.objective, reached * (1 - 1e-6)) << "start " << i;
    }
    const auto ceres = solve(synthesis::Solver::ceres, model, from[0], {.tolerance = 1e-15});
    EXPECT_NEAR(states[0].cost, ceres.objective, 1e-6 * ceres.objective);
  }
}

TEST(PathFit, DoesNotDependOnThreadsOrNeighbours) {
  const PathModel model(noisy(Timing::free, CrankReference::first), linkage.assembly, false);
  const auto from = starts(model, 200);
  const auto one = fitted(model, from, {.threads = 1});
  const auto many = fitted(model, from, {.threads = 5});
  for (std::size_t i = 0; i < from.size(); ++i) {
    EXPECT_EQ(one[i].cost, many[i].cost);
    EXPECT_EQ(one[i].crank_half, many[i].crank_half);
  }
  const auto alone = fitted(model, {from[77]}, {});
  EXPECT_EQ(alone[0].value, one[77].value);
  EXPECT_EQ(alone[0].iterations, one[77].iterations);
}

TEST(PathFit, ReachesTheSameOnEveryInstructionSet) {
  const PathModel model(noisy(Timing::free, CrankReference::first), linkage.assembly, false);
  const auto from = starts(model, 20);
  const PathFitOptions exact{.most_iterations = 400, .tolerance = 1e-15};
  const auto widest = fitted(model, from, exact);
  for (const InstructionSet set : instruction_sets()) {
    PathFitOptions options = exact;
    options.set = set;
    const auto states = fitted(model, from, options);
    for (std::size_t i = 0; i < from.size(); ++i) {
      EXPECT_NEAR(states[i].cost, widest[i].cost, 1e-6 * widest[i].cost) << name(set);
    }
  }
}

/// Against finite differences of the model's own objective with its limits as penalties.
TEST(PathFit, CostsLimitsAsPenalties) {
  PathProblem problem = noisy(Timing::free, CrankReference::first);
  problem.constraints.required_class = RequiredClass::crank_rocker;
  problem.constraints.transmission_angle = Range{0.75, 2.2};
  problem.constraints.link_ratio_max = 2.8;
  problem.given.pivot_a = linkage.pivot_a;
  problem.bounds.pivot_d = Box{{0, 0}, {2.05, 1}};
  const PathModel model(problem, linkage.assembly, false);
  const PathFitOptions options{.most_iterations = 2000, .tolerance = 1e-16};
  const auto penalised = [&](const std::vector<double>& x) {
    std::vector<double> c(model.constraint_count());
    model.constraints(x, c, {});
    double sum = objective(model, x);
    for (const double value : c) sum += std::pow(options.penalty * std::min(0.0, value), 2);
    return sum;
  };
  const auto from = starts(model, 12);
  const auto states = fitted(model, from, options);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const auto x = model.variables_of(states[i], from[i]);
    const double cost = penalised(x);
    EXPECT_NEAR(states[i].cost, cost, 1e-9 * cost);
    EXPECT_GT(cost, objective(model, x)) << "no limit is active: the test shows nothing";
    int inside = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const auto& variable = model.variables()[k];
      if (x[k] - variable.lower < 1e-4 || variable.upper - x[k] < 1e-4) continue;
      ++inside;
      const double h = 1e-6;
      auto left = x, right = x;
      left[k] -= h;
      right[k] += h;
      const double slope = (penalised(right) - penalised(left)) / (2 * h);
      const double bend = std::abs(penalised(right) - 2 * cost + penalised(left)) / (h * h);
      EXPECT_LT(slope * slope / (bend + 1e-12), 1e-4 * cost)
          << "start " << i << ", " << variable.name;
    }
    EXPECT_GE(inside, static_cast<int>(x.size()) - 2) << "start " << i;
  }
  EXPECT_EQ(states.size(), 12u);
}

/// The limits of the transmission angle at every point, of a crank that need not turn fully: the
/// angle from the motion, the derivatives by differences, for each way of timing.
TEST(PathFit, CostsTransmissionAnglesAtThePoints) {
  const Range limits{0.9, 1.5};
  const PathFitOptions options{.most_iterations = 2000, .tolerance = 1e-16};
  int tested = 0;
  for (const auto& [timing, reference] : {std::pair(Timing::free, CrankReference::first),
                                          {Timing::mixed, CrankReference::first},
                                          {Timing::mixed, CrankReference::frame},
                                          {Timing::mixed, CrankReference::global}}) {
    PathProblem problem = noisy(timing, reference);
    problem.constraints.transmission_angle = limits;
    const PathModel model(problem, linkage.assembly, false);
    const auto penalised = [&](const std::vector<double>& x) {
      double sum = objective(model, x);
      const Motion motion(model.linkage(x));
      for (const double angle : model.crank_angles(x)) {
        const double cosine = std::cos(motion.at(angle)->transmission_angle);
        const double over = std::max(0.0, cosine - std::cos(limits.min));
        const double under = std::max(0.0, std::cos(limits.max) - cosine);
        sum += std::pow(options.penalty * (over + under), 2);
      }
      return sum;
    };
    const auto from = starts(model, 6);
    const auto states = fitted(model, from, options);
    for (std::size_t i = 0; i < from.size(); ++i) {
      const auto x = model.variables_of(states[i], from[i]);
      const double cost = penalised(x);
      EXPECT_NEAR(states[i].cost, cost, 1e-9 * cost);
      EXPECT_GT(cost, objective(model, x)) << "no limit is active: the test shows nothing";
      for (std::size_t k = 0; k < x.size(); ++k) {
        const auto& variable = model.variables()[k];
        if (x[k] - variable.lower < 1e-4 || variable.upper - x[k] < 1e-4) continue;
        const double h = 1e-6;
        auto left = x, right = x;
        left[k] -= h;
        right[k] += h;
        const double slope = (penalised(right) - penalised(left)) / (2 * h);
        const double bend = std::abs(penalised(right) - 2 * cost + penalised(left)) / (h * h);
        EXPECT_LT(slope * slope / (bend + 1e-12), 1e-4 * cost)
            << "start " << i << ", " << variable.name;
        ++tested;
      }
    }
  }
  EXPECT_GE(tested, 200);
}

TEST(PathFit, StartsWithinItsBounds) {
  PathProblem problem = noisy(Timing::prescribed, CrankReference::frame);
  const PathModel free(problem, linkage.assembly, false);
  problem.bounds.crank = Range{0.9, 1};
  problem.bounds.coupler_point = Box{{1.2, 0.5}, {1.5, 0.6}};
  const PathModel model(problem, linkage.assembly, false);
  const auto outside = free.variables_of(linkage, angles);
  auto within = outside;
  for (std::size_t i = 0; i < within.size(); ++i) {
    const auto& variable = model.variables()[i];
    within[i] = std::clamp(within[i], variable.lower, variable.upper);
  }
  ASSERT_NE(outside, within);
  const PathFitOptions exact{.most_iterations = 400, .tolerance = 1e-15};
  const auto states = fitted(model, {outside, within}, exact);
  EXPECT_EQ(states[0].value, states[1].value);
  const auto best = solve(synthesis::Solver::slsqp, model, within, {.tolerance = 1e-14});
  EXPECT_NEAR(states[0].cost, best.objective, 1e-6 * best.objective);
}

TEST(PathFit, SaysWhereALinkageDoesNotClose) {
  const PathModel model(noisy(Timing::free, CrankReference::first), linkage.assembly, false);
  auto x = model.variables_of(linkage, angles);
  x[PathModel::frame] = 50;
  const auto states = fitted(model, {x, model.variables_of(linkage, angles)}, {});
  EXPECT_FALSE(std::isfinite(states[0].cost));
  EXPECT_TRUE(std::isfinite(states[1].cost));
}

}  // namespace
}  // namespace cognate::problems::path_fit_test
