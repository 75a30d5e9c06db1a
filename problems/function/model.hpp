/// @file Function generation of a four-bar as a nonlinear program.
#pragma once

#include <array>
#include <vector>

#include "analysis/linkage/closure.hpp"
#include "problems/function/generator.hpp"
#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/linkage/cycle/cycle_limits.hpp"
#include "problems/linkage/linkage_constraints.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "synthesis/lanes/function_fit.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::problems {

/// Whether a constraint keeps the linkage closing over the whole sweep: then a solver can move
/// along the border of what closes, where many a best design lies, instead of stopping at it, and
/// no gap between samples goes unseen. `unguarded` is for solvers that take no constraints.
enum class Closing { guarded, unguarded };

/// Structural errors of a four-bar at the samples, with exact derivatives.
///
/// Dimensions, those that the file fixes left out of the variables: the logarithms of crank,
/// coupler, rocker and frame, then input and output start angle. With a start at a dead centre the
/// start angles follow from the lengths.
///
/// The transmission angle is limited over the sweep, or over the full turn where the problem
/// demands a class whose crank turns fully: see ConfinedFunctions.
class FunctionModel final : public synthesis::Model {
 public:
  static constexpr int kDimensions = 6;

  /// Keeps references to `problem` and `wanted`.
  FunctionModel(const FunctionProblem& problem, const FunctionSamples& wanted, Assembly assembly,
                synthesis::Objective objective, Closing closing = Closing::guarded);

  std::span<const synthesis::Variable> variables() const override { return variables_; }
  int residual_count() const override { return static_cast<int>(wanted_.samples.size()); }
  int constraint_count() const override;
  synthesis::Objective objective() const override { return objective_; }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override;
  /// Not with a start at a dead centre, nor with limits over the full turn.
  bool has_hessian() const override {
    return problem_.start == FunctionStart::free && cycle_limits_.count() == 0;
  }
  bool lagrangian_hessian(std::span<const double> x, std::span<const double> of_residuals,
                          std::span<const double> of_constraints,
                          std::span<double> out) const override;

  /// The model as the fit in SIMD lanes takes it, without limits on the start angles. Only where
  /// these do not follow from the lengths.
  synthesis::FunctionFit lane_fit() const;

  std::vector<double> variables_of(const FunctionGenerator& generator) const;
  FunctionGenerator generator(std::span<const double> x) const;

 private:
  struct Curvature;
  using Slopes = std::array<double, kDimensions>;

  void list_variables();
  bool set_start(FunctionGenerator& generator, Lengths<double>& input_slope,
                 Lengths<double>& output_slope) const;
  void sweep_constraints(const FunctionGenerator& generator, std::span<double, 2> values,
                         std::span<Slopes, 2> slopes) const;
  void add_sweep_curvature(const FunctionGenerator& g, std::span<const double> weights,
                           Curvature& out) const;
  void limit_turn(const FunctionGenerator& g, std::span<double> values,
                  std::span<double> jacobian) const;
  void write_row(const Slopes& slopes, std::span<double> row) const;

  const FunctionProblem& problem_;
  const FunctionSamples& wanted_;
  Assembly assembly_;
  synthesis::Objective objective_;
  bool limits_sweep_ = false;
  Range transmission_;       ///< limits over the sweep: those of the file, else closure
  double sweep_weight_ = 1;  ///< of their rows
  LinkageConstraints linkage_constraints_;
  CycleLimits cycle_limits_;
  std::array<double, kDimensions> fixed_{};
  std::vector<int> free_;  ///< dimension of each variable
  std::vector<synthesis::Variable> variables_;
  std::vector<Vec2d> half_input_;  ///< unit vectors of half the input increments
};

}  // namespace cognate::problems
