/// @file The mean square of an error over what is made, as a model.
#pragma once

#include "synthesis/robust/perturbed_model.hpp"

namespace cognate::synthesis {

/// The residuals of all samples, each divided by the root of their number: their sum of squares is
/// the mean of that of the nominal model. With the samples of `Spread` it is the mean over the
/// tolerances, to third order of these (Julier & Uhlmann 2004, "Unscented filtering and nonlinear
/// estimation", Proc. IEEE 92). A smooth function, from which a search for the least quantile
/// begins.
///
/// Variables are those of the nominal model, none of them local. Those that were local follow in
/// each sample; derivatives are with them following, by Kaufman's approximation of the variable
/// projection (1975, BIT 15), whose gradient is exact.
class MeanSquareModel final : public Model {
 public:
  /// Both must outlive this object. `follow`: see PerturbedModel.
  MeanSquareModel(const Model& nominal, const Perturbation& perturbation, int follow)
      : samples_(nominal, perturbation, follow) {}

  std::span<const Variable> variables() const override { return samples_.nominal().variables(); }
  int residual_count() const override {
    return samples_.nominal().residual_count() * static_cast<int>(samples_.count());
  }
  int constraint_count() const override { return samples_.nominal().constraint_count(); }
  int equality_count() const override { return samples_.nominal().equality_count(); }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override {
    samples_.constraints(x, {}, c, jacobian);
  }

 private:
  PerturbedModel samples_;
};

}  // namespace cognate::synthesis
