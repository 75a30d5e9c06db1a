/// @file The structural error of a function generator that is a chain.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "problems/chain/free_chain.hpp"
#include "problems/chain_function/space.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::problems {

/// A chain with the angle of its crank at the start.
struct ChainFunctionDesign {
  synthesis::ChainDesign chain;
  double start = 0;
};

/// The output from which increments count, such that the errors over `pairs` reach as far up as
/// down; empty where the chain does not close.
std::optional<double> output_level(const ChainFunctionSpace& space,
                                   const ChainFunctionDesign& design,
                                   std::span<const synthesis::AnglePair> pairs);

/// Residuals: the output less the wanted one at `pairs`. Unknowns: free parameters, the crank's
/// angle and the output at the start, the latter from `output_level`. It has no value where the
/// design that it begins with, brought within its bounds, does not close. Constraints: transmission
/// at `checks`, whose crank angles turn with the start.
class ChainFunctionModel : public synthesis::Model {
 public:
  ChainFunctionModel(const ChainFunctionSpace& space, const ChainFunctionDesign& design,
                     std::vector<TransmissionCheck> checks,
                     std::span<const synthesis::AnglePair> pairs, synthesis::Objective objective);

  std::vector<double> start() const;
  ChainFunctionDesign design(std::span<const double> x) const;

  std::span<const synthesis::Variable> variables() const override { return variables_; }
  int residual_count() const override { return static_cast<int>(pairs_.size()); }
  int constraint_count() const override { return 2 * static_cast<int>(checks_.size()); }
  synthesis::Objective objective() const override { return objective_; }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override;

 private:
  std::size_t start_column() const { return space_.free.size(); }
  std::size_t level_column() const { return start_column() + 1; }
  using Parameters = std::array<double, synthesis::kMostChainParameters>;
  Parameters parameters(std::span<const double> x) const;

  const ChainFunctionSpace& space_;
  ChainFunctionDesign design_;
  std::vector<double> side_;
  std::vector<TransmissionCheck> checks_;
  std::span<const synthesis::AnglePair> pairs_;
  synthesis::Objective objective_;
  bool closes_ = false;
  std::vector<Vec2d> turned_;  ///< the crank's direction at each pair, from that at the start
  std::vector<WantedOutput> wanted_;  ///< at each pair
  std::vector<synthesis::Variable> variables_;
};

}  // namespace cognate::problems
