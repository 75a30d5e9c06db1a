/// @file A model whose dimensions are off, sample by sample.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/optimise/model.hpp"

namespace cognate::synthesis {

/// How the variables of a model move where dimensions are off, sample by sample.
class Perturbation {
 public:
  virtual ~Perturbation() = default;

  /// How many samples there are.
  virtual std::size_t count() const = 0;

  /// The variables that stand for `x` in one sample, and the derivative of each by itself. Called
  /// from many threads at once.
  virtual void move(std::span<const double> x, std::size_t sample, std::span<double> moved,
                    std::span<double> slope) const = 0;
};

/// The residuals of a model in one sample, local variables where they are best in that sample: a
/// crank that is not timed follows.
class PerturbedModel {
 public:
  /// What is known of one sample.
  struct Sample {
    std::vector<double> moved, slope;  ///< see Perturbation
    std::vector<double> r;
    std::vector<double> jacobian;  ///< by the moved global variables, the local ones held
    std::vector<double> local;     ///< by the local variables, as a model gives it
  };

  /// `follow`: Newton steps that bring each local variable to the least error of its station.
  /// Nominal model and perturbation must outlive this object.
  PerturbedModel(const Model& nominal, const Perturbation& perturbation, int follow)
      : nominal_(nominal), perturbation_(perturbation), follow_(follow) {}

  const Model& nominal() const { return nominal_; }
  std::size_t count() const { return perturbation_.count(); }

  /// Memory of the calling thread, of the right size.
  Sample& memory() const;

  /// Fills `at`, the derivatives on request; false without a value.
  bool evaluate(std::span<const double> x, std::size_t number, bool differentiate,
                Sample& at) const;

  /// The constraints of the design itself, `jacobian` by all variables, local ones too; last, where
  /// there is a `most`, that the sum of squares of its residuals is no more.
  int constraint_count(const std::optional<double>& most) const {
    return nominal_.constraint_count() + (most ? 1 : 0);
  }
  void constraints(std::span<const double> x, const std::optional<double>& most,
                   std::span<double> c, std::span<double> jacobian) const;

 private:
  void follow(Sample& at) const;
  bool settle(bool differentiate, Sample& at) const;
  bool approach(std::span<const double> x, bool differentiate, Sample& at) const;
  void nominal_constraints(std::span<const double> x, std::span<double> c,
                           std::span<double> jacobian) const;
  void limit_sum(std::span<const double> x, double limit, double& c, std::span<double> row) const;

  const Model& nominal_;
  const Perturbation& perturbation_;
  int follow_;
};

}  // namespace cognate::synthesis
