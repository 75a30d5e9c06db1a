/// @file The path problem of a chain as a model for any solver.
#pragma once

#include <vector>

#include "problems/chain/free_chain.hpp"
#include "problems/chain/scaled.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::problems {

/// Two residuals for each target, of a pose a third, its angle, divided by √n, so that their
/// squares sum up to the mean square. Unknowns are the free parameters, then the phase of a timed
/// path or a crank angle for each target, which stays between the middles to its neighbours in
/// `angles`. Where the target may be moved, its place's four numbers stand before the angles.
/// Constraints: ± cos μ is within the limit, less `margin`, at each check.
class ChainPathModel : public synthesis::Model {
 public:
  /// `angles`: of the crank at the targets, in order; timed: the phase alone. `at`: where the
  /// target is, from where it may be moved.
  ChainPathModel(const ScaledChain& problem, const synthesis::ChainDesign& design,
                 std::vector<double> angles, const TargetPlace& at,
                 std::vector<TransmissionCheck> checks, double margin = 0);

  std::vector<double> start() const;
  synthesis::ChainDesign design(std::span<const double> x) const;
  std::vector<double> angles(std::span<const double> x) const;
  TargetPlace target_place(std::span<const double> x) const;

  std::span<const synthesis::Variable> variables() const override { return variables_; }
  int residual_count() const override {
    return static_cast<int>(stride() * problem_.points.size());
  }
  int constraint_count() const override { return 2 * static_cast<int>(checks_.size()); }
  std::span<const int> local_of_residual() const override { return locals_; }
  int local_count() const override;
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override;

 private:
  struct Row;  ///< of the Jacobian

  /// Residuals of one target.
  std::size_t stride() const { return problem_.is_motion() ? 3 : 2; }
  void add_variables();
  /// How many stand before the crank angles.
  std::size_t global_count() const;

  const ScaledChain& problem_;
  synthesis::ChainDesign design_;
  std::vector<double> angles_, side_;
  TargetPlace at_;
  std::vector<TransmissionCheck> checks_;
  double cosine_limit_;
  std::vector<synthesis::Variable> variables_;
  std::vector<int> locals_;
};

}  // namespace cognate::problems
