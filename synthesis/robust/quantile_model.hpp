/// @file The quantile of an error over what is made, as a model: designs whose dimensions are off
/// err by no more in so many cases.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/robust/perturbed_model.hpp"

namespace cognate::synthesis {

/// What is least.
struct QuantileOptions {
  double share = 0.99;  ///< of the samples that err by no more, above 0 and below 1
  /// So many residuals in succession are the components of one error, at one station.
  int components = 2;
  /// What each error is multiplied by: 1 over the weight of its residuals, 0 where it does not
  /// count. Empty: 1.
  std::vector<double> scale{};
  /// Where a station has a local variable, so many Newton steps of its own bring it to the least
  /// error of each sample: a crank that is not timed follows. The error does then not depend on
  /// the variable itself.
  int follow = 2;
  /// Bound on the sum of squares of the residuals of the design itself; empty: none.
  std::optional<double> most_sum_of_squares{};
};

/// One residual: the quantile of the greatest error over the stations, among samples that are the
/// same at every evaluation (sample average approximation: Shapiro, Dentcheva & Ruszczyński 2009,
/// "Lectures on Stochastic Programming", ch. 5; common random numbers).
///
/// The quantile is the mean of the samples whose ranks are near the share, with weights that fall
/// to 0 as those of Epanechnikov do (an L-estimate: Sheather & Marron 1990, "Kernel quantile
/// estimators", JASA 85): a continuous function, with the exact gradient wherever no two samples
/// change their ranks. Variables are those of the nominal model, none of them local; its
/// constraints hold for the nominal design. Without a value where that or a sample of weight has
/// none.
class QuantileModel final : public Model {
 public:
  /// Both must outlive this object.
  QuantileModel(const Model& nominal, const Perturbation& perturbation, QuantileOptions options);

  std::span<const Variable> variables() const override { return nominal_.variables(); }
  int residual_count() const override { return 1; }
  int constraint_count() const override {
    return samples_.constraint_count(options_.most_sum_of_squares);
  }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override {
    samples_.constraints(x, options_.most_sum_of_squares, c, jacobian);
  }

  /// The error of each sample, ascending; infinite where it has no value. The same for any number
  /// of threads.
  std::vector<double> errors(std::span<const double> x, int threads) const;

 private:
  struct Made;

  Made made(std::span<const double> x, std::size_t number) const;
  std::vector<Made> sorted(std::span<const double> x) const;
  bool add_gradient(std::span<const double> x, const Made& of, double weight,
                    std::span<double> gradient) const;

  const Model& nominal_;
  PerturbedModel samples_;
  QuantileOptions options_;
  std::vector<double> weight_;  ///< of each rank, ascending; their sum is 1
};

}  // namespace cognate::synthesis
