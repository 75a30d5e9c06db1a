/// @file The gait of a leg as a minimax model.
#pragma once

#include <vector>

#include "problems/chain/free_chain.hpp"
#include "problems/leg/space.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::problems {

/// Of the crank's turn: stances are at most this long.
inline constexpr double kMostDuty = 0.95;

/// A leg with its stance: crank angles from `start` over `span`.
struct LegDesign {
  synthesis::ChainDesign chain;
  double start = 0, span = 0;
};

/// Where constraints between samples are asked: crank angles, or shares of the stance in [0, 1].
struct LegChecks {
  std::vector<TransmissionCheck> transmission;
  std::vector<double> swing;       ///< crank angles out of stance at which the foot is low
  double bottom = 0, top = 0;      ///< crank angles of its lowest and highest place
  double ahead = 1, behind = 0;    ///< shares: its extremes in the sense of the stance
  std::vector<double> slow, fast;  ///< shares: of its speed
  int sense = 1;                   ///< of x in stance
  double band = 0;                 ///< with LegObjective::duty: the most half band
};

/// Residuals: what the foot's level deviates from the middle of its band at Chebyshev–Lobatto nodes
/// of the stance, in the unit `unit`; the objective is the greatest. With LegObjective::duty the
/// one residual is the share of the turn out of stance, and that deviation is limited. Unknowns:
/// free parameters, the stance's start, the middle of the band, with LegObjective::duty the
/// stance's span. Constraints: the stride and one level at both ends of the stance
/// (equalities: of all stances in one band `gait` finds such a one), transmission, the foot in
/// swing above the middle of the band, step height, distances, speed.
class LegModel : public synthesis::Model {
 public:
  LegModel(const LegSpace& space, const LegDesign& design, LegChecks checks, int nodes, double unit,
           LegObjective objective);

  std::vector<double> start() const;
  LegDesign design(std::span<const double> x) const;

  std::span<const synthesis::Variable> variables() const override { return variables_; }
  int residual_count() const override;
  int constraint_count() const override;
  int equality_count() const override { return 2; }
  synthesis::Objective objective() const override { return synthesis::Objective::max_abs; }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override;
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override;

 private:
  /// A value with its derivatives by all variables.
  struct Sum;

  bool finds_span() const { return objective_ == LegObjective::duty; }
  std::size_t start_column() const { return space_.free.size(); }
  std::size_t level_column() const { return start_column() + 1; }
  std::size_t span_column() const { return start_column() + 2; }

  /// Adds `weight` times direction·foot at a share of the stance, `beyond` radians after it.
  void add_in_stance(FreeChain& chain, const LegDesign& here, double weight, const Vec2d& direction,
                     double share, double beyond, Sum& sum) const;
  /// Speed over the mean at a share of the stance.
  void add_speed(FreeChain& chain, const LegDesign& here, double share, Sum& sum) const;

  const LegSpace& space_;
  LegDesign design_;
  std::vector<double> side_;
  LegChecks checks_;
  std::vector<double> nodes_;  ///< shares of the stance
  double unit_, level_ = 0;
  LegObjective objective_;
  std::vector<synthesis::Variable> variables_;
};

}  // namespace cognate::problems
