/// @file What is demanded of a cylindrical gear pair, as numbers with their limits: the search
/// weighs them, the checks of a finished design tell them.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "analysis/gear/spur_pair.hpp"
#include "problems/gear/problem.hpp"

namespace cognate::problems {

/// Teeth, module, shifts (in normal modules) and centre distance of a pair, in one unit of length.
struct GearPairNumbers {
  std::array<int, 2> teeth{};
  double module = 1;
  std::array<double, 2> shift{};
  double centre_distance = 0;
};

/// Its transverse sections.
gear::SpurPair section_of(const GearPairProblem& problem, const GearPairNumbers& numbers);

/// Whether neither gear is impossible, and the centres are farther apart than base circles reach.
bool can_mesh(const gear::SpurPair& pair);

/// What holds of the pair where there is one: neither gear is impossible, and the centres are
/// farther apart than the base circles reach.
std::optional<gear::PairGeometry> mesh_of(const gear::SpurPair& pair);

/// What a demand is of, which decides how much it counts.
enum class GearLimitKind {
  wish,     ///< without it the pair runs
  running,  ///< without it the pair cannot run, and is no answer to wishes
  teeth     ///< the numbers of teeth alone tell
};

/// A demand: value ≥ bound, or value ≤ bound. `scale` is what counts as half a violation.
struct GearLimit {
  const char* name = "";
  double value = 0;
  double bound = 0;
  bool at_least = true;
  double scale = 1;
  GearLimitKind kind = GearLimitKind::wish;

  /// 0 where it is met, below 1 where it is missed, 1 where its value is not a number; ten times as
  /// much of what a pair cannot run without.
  double violation() const;
};

/// Every demand of a file, without memory of its own.
class GearLimits {
 public:
  GearLimits(const GearPairProblem& problem, const GearPairNumbers& numbers,
             const gear::SpurPair& pair, const std::optional<gear::PairGeometry>& mesh);

  std::span<const GearLimit> all() const { return {limits_.data(), count_}; }
  /// The sum of all, so that nothing is missed needlessly, and what of it is the teeth's.
  double violation() const;
  double violation_of_teeth() const;

 private:
  void at_least(const char* name, double value, double bound, double scale = 1,
                GearLimitKind kind = GearLimitKind::wish) {
    limits_.at(count_++) = {name, value, bound, true, scale, kind};
  }
  void at_most(const char* name, double value, double bound, double scale = 1,
               GearLimitKind kind = GearLimitKind::wish) {
    limits_.at(count_++) = {name, value, bound, false, scale, kind};
  }
  void add_possibility();
  void add_backlash();
  void add_gear(std::size_t index);
  void add_bounds();

  const GearPairProblem& problem_;
  const GearPairNumbers& numbers_;
  const gear::SpurPair& pair_;
  const std::optional<gear::PairGeometry>& mesh_;
  std::array<GearLimit, 28> limits_{};
  std::size_t count_ = 0;
};

/// ε_β of helical gears of that (normal) module, 0 of others.
double overlap_of(const GearPairProblem& problem, double module);

/// Of helical gears with their overlap ε_α + ε_β, else ε_α.
double total_contact_ratio(const GearPairProblem& problem, double module,
                           const gear::PairGeometry& mesh);

/// The greatest magnitude of specific sliding at the four ends of the active flanks.
double greatest_sliding(const gear::PairGeometry& mesh);

}  // namespace cognate::problems
