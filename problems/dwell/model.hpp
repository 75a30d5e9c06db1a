/// @file The half band of dwells as a minimax model.
#pragma once

#include <vector>

#include "problems/chain/free_chain.hpp"
#include "problems/dwell/space.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::problems {

/// A design with its dwells.
struct DwellDesign {
  synthesis::ChainDesign chain;
  std::vector<double> start;  ///< crank angle at which each dwell begins
};

/// Angles at which constraints between samples are asked.
struct DwellChecks {
  std::vector<TransmissionCheck> transmission;
  double highest = 0, lowest = 0;  ///< crank angles of the output's extremes
  double apart = 0;                ///< of the levels of two dwells
};

/// Residuals: what the output deviates from the level of its dwell at Chebyshev–Lobatto nodes, in
/// the unit `unit`; the objective is the greatest. Unknowns: free parameters, the start of each
/// dwell, the level of each. Constraints: transmission, least swing, levels apart.
class DwellModel : public synthesis::Model {
 public:
  DwellModel(const DwellSpace& space, const DwellDesign& design, DwellChecks checks, int nodes,
             double unit);

  std::vector<double> start() const;
  DwellDesign design(std::span<const double> x) const;

  std::span<const synthesis::Variable> variables() const override { return variables_; }
  int residual_count() const override { return static_cast<int>(dwells() * nodes_.size()); }
  int constraint_count() const override;
  synthesis::Objective objective() const override { return synthesis::Objective::max_abs; }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override;

 private:
  std::size_t dwells() const { return space_.problem->dwells.size(); }
  std::size_t first_start() const { return space_.free.size(); }
  std::size_t first_level() const { return first_start() + dwells(); }
  synthesis::ChainDesign chain(std::span<const double> x) const;
  bool has_swing() const { return space_.problem->swing_min > 0; }
  bool has_apart() const { return space_.apart && dwells() == 2; }

  const DwellSpace& space_;
  DwellDesign design_;
  std::vector<double> side_;
  DwellChecks checks_;
  std::vector<double> nodes_;  ///< in [0, 1]
  double unit_;
  WantedOutput reference_;  ///< the output from which levels are counted
  std::vector<double> levels_;
  std::vector<synthesis::Variable> variables_;
};

}  // namespace cognate::problems
