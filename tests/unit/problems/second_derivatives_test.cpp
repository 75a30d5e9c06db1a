/// The second derivatives of the models against differences of their gradients.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "analysis/linkage/motion.hpp"
#include "problems/function/model.hpp"
#include "problems/path/model.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems::second_derivatives_test {
namespace {

using synthesis::Model;

/// Σ aᵢ ∇rᵢ + Σ bₖ ∇cₖ at x by all variables.
std::vector<double> gradient(const Model& model, std::span<const double> x,
                             std::span<const double> a, std::span<const double> b) {
  const std::size_t rows = a.size(), limits = b.size(), n = x.size();
  const auto globals = static_cast<std::size_t>(model.global_count());
  std::vector<double> r(rows), jacobian(rows * globals), local(model.local_count() ? rows : 0);
  std::vector<double> c(limits), slopes(limits * globals), out(n);
  EXPECT_TRUE(model.residuals(x, r, jacobian, local));
  model.constraints(x, c, slopes);
  for (std::size_t j = 0; j < globals; ++j) {
    for (std::size_t i = 0; i < rows; ++i) out[j] += a[i] * jacobian[i * globals + j];
    for (std::size_t k = 0; k < limits; ++k) out[j] += b[k] * slopes[k * globals + j];
  }
  for (std::size_t i = 0; i < local.size(); ++i) {
    out[globals + model.local_of_residual()[i]] += a[i] * local[i];
  }
  return out;
}

void expect_right_hessian(const Model& model, std::vector<double> x) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<double> a(model.residual_count()), b(model.constraint_count());
  for (double& weight : a) weight = normal(random);
  for (double& weight : b) weight = normal(random);
  const std::size_t n = x.size();
  std::vector<double> hessian(n * n);
  ASSERT_TRUE(model.has_hessian());
  ASSERT_TRUE(model.lagrangian_hessian(x, a, b, hessian));
  double largest = 1;
  for (const double entry : hessian) largest = std::max(largest, std::abs(entry));
  for (std::size_t j = 0; j < n; ++j) {
    // Fourth order: the error is that of rounding, 1e-11 or so, and of h⁴.
    const double h = 1e-3, middle = x[j];
    const auto at = [&](double step) {
      x[j] = middle + step;
      return gradient(model, x, a, b);
    };
    const auto far = at(2 * h), near = at(h), near_below = at(-h), far_below = at(-2 * h);
    x[j] = middle;
    for (std::size_t i = 0; i < n; ++i) {
      const double slope = (8 * (near[i] - near_below[i]) - (far[i] - far_below[i])) / (12 * h);
      EXPECT_NEAR(hessian[i * n + j], slope, 1e-7 * largest) << "entry " << i << ", " << j;
    }
  }
}

const FourBar kLinkage{{0.2, -0.3}, {2.1, 0.9}, 0.8, 1.9, 1.6, Assembly::open, Vec2d{1.1, 0.7}};
const std::vector<double> kAngles{0.4, 0.9, 1.7, 2.2, 3.0};

PathProblem path(Timing timing, CrankReference reference) {
  PathProblem problem;
  problem.timing = timing;
  problem.crank_reference = reference;
  problem.weights = {1, 2, 0.5, 1, 3};
  if (timing == Timing::mixed) problem.has_crank_angle = {false, true, false, true, true};
  for (const double angle : kAngles) {
    problem.points.push_back(*Motion(kLinkage).at(angle)->coupler_point + Vec2d{0.1, -0.2});
    if (timing != Timing::free) problem.crank_angles.push_back(angle);
  }
  return problem;
}

TEST(SecondDerivatives, OfPaths) {
  for (const auto timing : {Timing::free, Timing::prescribed, Timing::mixed}) {
    for (const auto reference :
         {CrankReference::first, CrankReference::frame, CrankReference::global}) {
      SCOPED_TRACE(static_cast<int>(reference));
      PathProblem problem = path(timing, reference);
      std::vector<PathProblem> variants{problem};
      problem.constraints.required_class = RequiredClass::crank_rocker;
      problem.constraints.transmission_angle = Range{0.5, 2.5};
      problem.bounds.pivot_d = Box{{-1, -1}, {4, 4}};
      variants.push_back(problem);
      problem.given.pivot_d = kLinkage.pivot_d;
      problem.given.coupler = kLinkage.coupler;
      problem.bounds.pivot_a = Box{{-1, -1}, {1, std::numeric_limits<double>::infinity()}};
      variants.push_back(problem);
      for (const PathProblem& variant : variants) {
        const PathModel model(variant, kLinkage.assembly, false);
        expect_right_hessian(model, model.variables_of(kLinkage, kAngles));
      }
    }
  }
}

TEST(SecondDerivatives, OfFunctions) {
  FunctionProblem problem;
  FunctionSamples wanted;
  for (const double input : {0.0, 0.3, 0.7, 1.1, 1.4})
    wanted.samples.push_back({input, 0.4 * input});
  wanted.sweep = {0, 1.4};
  FunctionGenerator generator;
  generator.links = {0.8, 1.9, 1.6, 2.2};
  generator.assembly = Assembly::crossed;
  for (const double start : {0.6, -0.5, 2.4}) {  // within, across and before the frame's line
    generator.input_start = start;
    generator.output_start = 1.2;
    for (const bool classed : {false, true}) {
      problem.constraints.transmission_angle = Range{0.4, 2.6};
      problem.constraints.required_class.reset();
      if (classed) problem.constraints.required_class = RequiredClass::crank_rocker;
      problem.constraints.link_ratio_max = 5;
      const FunctionModel model(problem, wanted, generator.assembly,
                                synthesis::Objective::sum_of_squares);
      expect_right_hessian(model, model.variables_of(generator));
    }
  }
}

/// The same model without its second derivatives.
class WithoutHessian final : public Model {
 public:
  explicit WithoutHessian(const PathModel& model) : model_(model) {}
  std::span<const synthesis::Variable> variables() const override { return model_.variables(); }
  int residual_count() const override { return model_.residual_count(); }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override {
    return model_.residuals(x, r, jacobian, local);
  }

 private:
  const PathModel& model_;
};

TEST(SecondDerivatives, SaveIpoptIterations) {
  const PathModel model(path(Timing::prescribed, CrankReference::first), kLinkage.assembly, false);
  const auto start = model.variables_of(kLinkage, kAngles);
  const auto exact = solve(synthesis::Solver::ipopt, model, start);
  const auto approximate = solve(synthesis::Solver::ipopt, WithoutHessian(model), start);
  const auto other = solve(synthesis::Solver::gauss_newton, model, start);
  EXPECT_EQ(exact.stop, synthesis::Stop::converged);
  EXPECT_NEAR(exact.objective, other.objective, 1e-12);
  EXPECT_LT(exact.iterations, approximate.iterations);
}

TEST(SecondDerivatives, AreNotThereWithAStartAtADeadCentre) {
  FunctionProblem problem;
  problem.start = FunctionStart::outer_dead_centre;
  const FunctionSamples wanted;
  const FunctionModel model(problem, wanted, Assembly::open, synthesis::Objective::sum_of_squares);
  EXPECT_FALSE(model.has_hessian());
}

}  // namespace
}  // namespace cognate::problems::second_derivatives_test
