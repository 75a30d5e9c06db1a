/// @file The best profile shifts and centre distance of a cylindrical pair whose teeth and module
/// are chosen.
#pragma once

#include <optional>

#include "problems/gear/gear_pair_limits.hpp"

namespace cognate::problems {

/// Teeth and module.
struct GearCombination {
  std::array<int, 2> teeth{};
  double module = 1;
};

/// A pair that was found.
struct FoundPair {
  GearPairNumbers numbers;
  double violation = 0;  ///< 0 where every limit is met
  double objective = 0;  ///< the less the better
  double unit = 1;       ///< of the objective, so that it is a number of the size of 1
};

/// How finely it is searched.
enum class SearchDepth { coarse, fine };

/// What a cheap test says of a combination: how far the pair is from what it asks for, 0 where it
/// passes.
struct CheapTests {
  double ratio = 0;            ///< relative, beyond the tolerance
  double hunting = 0;          ///< 1 where the teeth have a common divisor that they must not have
  double centre_distance = 0;  ///< shifts beyond their bounds, in modules, that it would need
  double undercut = 0;         ///< the same with no gear undercut
};

/// The problem with one combination of teeth and module.
///
/// Backlash ties the sum of shifts to the centre distance, so that one unknown is left where that
/// is given, the pinion's shift, and two where it is free. Over the pinion's shift at a fixed sum
/// the contact ratio is concave, the sliding at one gear's root falls and at the other's grows, and
/// limits leave an interval: samples find its place, the golden section the optimum.
class GearPairSearch {
 public:
  GearPairSearch(const GearPairProblem& problem, const GearCombination& combination);

  CheapTests cheap_tests() const;

  /// Empty where no pair of these teeth has a working pressure angle.
  std::optional<FoundPair> best(SearchDepth depth) const;

  /// The pair of these shifts of the normal section, in a centre distance that belongs to them.
  FoundPair at(double first, double second, double centre_distance) const;

 private:
  struct Interval {
    double from = 0, to = 0;
    bool empty() const { return from > to; }
  };
  Interval shifts_of(std::size_t index, bool without_undercut) const;
  Interval sums(bool without_undercut) const;
  double missing_sum(bool without_undercut) const;
  double distance_of(double sum) const;
  double sum_at(double distance) const;
  double balanced_shift(double sum, double distance, double from, double to) const;
  FoundPair best_split(double sum, SearchDepth depth) const;
  double objective_of(const GearPairNumbers& numbers, const gear::PairGeometry& mesh) const;

  const GearPairProblem& problem_;
  GearCombination combination_;
  double normal_ = 1;  ///< cos β: shifts of the section over those of the normal section
  double backlash_ = 0;
  std::array<gear::SpurGear, 2> unshifted_;
};

/// Whether `a` is to be preferred: meets more, else is better by the objective.
bool is_better(const FoundPair& a, const FoundPair& b);

}  // namespace cognate::problems
