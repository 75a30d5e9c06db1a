/// @file The greatest error over a box of tolerances, as a model of least largest residual.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/robust/perturbed_model.hpp"

namespace cognate::synthesis {

/// How errors count; see QuantileOptions.
struct WorstCaseOptions {
  int components = 2;
  std::vector<double> scale{};
  int follow = 2;
  std::optional<double> most_sum_of_squares{};
};

/// The error of one station in one sample of a perturbation.
struct SampledError {
  std::size_t sample = 0, station = 0;
  double error = 0;  ///< infinite where the sample has no value
};

/// The errors of all stations in all samples at `x`, sample by sample; the same for any number of
/// threads.
std::vector<SampledError> sampled_errors(const Model& nominal, const Perturbation& perturbation,
                                         const WorstCaseOptions& options,
                                         std::span<const double> x);

/// Errors of chosen stations in chosen samples, the largest of which is to be least: a continuous
/// minimax problem, to which a search adds those that exceed the others elsewhere (an exchange, as
/// Remez' and Blankenship & Falk 1976, "Infinitely constrained optimization problems", JOTA 19).
/// Of one component a residual is the error with its sign, of more the length. Variables are those
/// of the nominal model, none of them local; its constraints hold for the nominal design.
class WorstCaseModel final : public Model {
 public:
  /// `nominal` and `perturbation` must outlive this object. `chosen`: by samples.
  WorstCaseModel(const Model& nominal, const Perturbation& perturbation, WorstCaseOptions options,
                 std::vector<SampledError> chosen);

  std::span<const Variable> variables() const override { return samples_.nominal().variables(); }
  int residual_count() const override { return static_cast<int>(chosen_.size()); }
  int constraint_count() const override {
    return samples_.constraint_count(options_.most_sum_of_squares);
  }
  Objective objective() const override { return Objective::max_abs; }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override {
    samples_.constraints(x, options_.most_sum_of_squares, c, jacobian);
  }

 private:
  void add_row(const PerturbedModel::Sample& at, std::size_t station, double residual,
               std::span<double> row) const;

  PerturbedModel samples_;
  WorstCaseOptions options_;
  std::vector<SampledError> chosen_;
};

}  // namespace cognate::synthesis
