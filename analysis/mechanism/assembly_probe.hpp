/// @file How far the dyads of a mechanism are from where they cannot be assembled.
#pragma once

#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/dyad_reach.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/dual.hpp"

namespace cognate {

/// The discriminant of a dyad (less the least that counts), its derivative by the drive, and what
/// rounding may have changed it by. A dyad can be assembled where `margin` ≥ 0.
struct Closeness {
  double margin = 0;
  double rate = 0;
  double rounding = 0;
};

/// Evaluates closures with their derivatives by the drive. Dyads before the requested one
/// are taken as assembled.
class AssemblyProbe {
 public:
  explicit AssemblyProbe(const Mechanism<double>& mechanism);

  /// Of dyad `index` at a position in `run`.
  Closeness closeness(const AssemblyRange& run, double drive, int index);

  /// Of dyad `index` at a position in `run`.
  Reach dyad_reach(const AssemblyRange& run, double drive, int index);

  /// The closure of dyad `index` at a position in `run`; its rate is not a number at a dead point
  /// that ends the run.
  const DyadClosure<Dual>& closure(const AssemblyRange& run, double drive, int index);

 private:
  /// The closure of dyad `index` with `sides_`.
  const DyadClosure<Dual>& evaluate_at(const AssemblyRange& run, double drive, int index);

  /// Leaves the dyads to evaluate at those that dyad `index` may depend on, and itself.
  void keep_to(int index);

  const Dyad<double>& dyad(int index) const {
    return mechanism_.dyads[static_cast<std::size_t>(index)];
  }

  Mechanism<double> mechanism_;
  std::vector<Dyad<Dual>> dyads_;
  Mechanism<Dual> dual_;  ///< with the first of `dyads_`
  std::vector<double> sides_;
  std::vector<Dual> dual_sides_;
  std::vector<BodyMotion<Dual, 0>> bodies_;
  std::vector<BodyMotion<double, 0>> places_;
  std::vector<DyadClosure<Dual>> closures_;
};

}  // namespace cognate
