/// @file Robust losses: sums of squares that gross errors do not govern.
#pragma once

#include "synthesis/optimise/solver.hpp"

namespace cognate::synthesis {

/// What a squared error s, in units of the scale squared, counts for (as in Ceres; Huber 1964,
/// Black and Rangarajan 1996):
enum class Loss {
  none,     ///< s
  huber,    ///< s up to 1, 2√s − 1 beyond
  soft_l1,  ///< 2(√(1 + s) − 1)
  cauchy,   ///< log(1 + s)
  arctan,   ///< atan s
  tukey,    ///< (1 − (1 − s)³)/3 up to 1, 1/3 beyond: gross errors do not count at all
};

/// ρ(s) and ρ′(s).
struct LossValue {
  double value = 0, slope = 0;
};
LossValue evaluate(Loss loss, double s);

/// A model of least squares whose errors, `block` successive residuals each, count by a loss:
/// Σ a² ρ(|rⱼ|²/a²). Its residuals are those of `model` times √(ρ(s)/s), so every solver takes it.
/// `model`, whose objective is a sum of squares, must outlive this object; `scale` a is positive.
class RobustModel final : public Model {
 public:
  /// `model` with this loss.
  RobustModel(const Model& model, Loss loss, double scale, int block)
      : model_(model), loss_(loss), scale_(scale), block_(block) {}

  std::span<const Variable> variables() const override { return model_.variables(); }
  int residual_count() const override { return model_.residual_count(); }
  int constraint_count() const override { return model_.constraint_count(); }
  int equality_count() const override { return model_.equality_count(); }
  std::span<const int> local_of_residual() const override { return model_.local_of_residual(); }
  int local_count() const override { return model_.local_count(); }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override {
    model_.constraints(x, c, jacobian);
  }

 private:
  const Model& model_;
  Loss loss_;
  double scale_;
  int block_;
};

/// `solve` of `model` by `loss`; plainly where it is none. Tukey's has no slope where all errors
/// are gross, as they are far from the minimum: there Huber's leads the way.
Solution solve_by_loss(Solver solver, const Model& model, Loss loss, double scale, int block,
                       std::span<const double> start, const Options& options);

}  // namespace cognate::synthesis
