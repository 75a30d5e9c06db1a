/// @file The best profile shifts and centre distance of a cylindrical pair whose teeth and module
/// are chosen.
#pragma once

#include <optional>

#include "problems/gear/pair_limits.hpp"

namespace cognate::problems {

/// Teeth and module.
struct GearCombination {
  std::array<int, 2> teeth{};
  double module = 1;
};

/// A pair that was found.
struct PairDesign {
  GearPairNumbers numbers;
  double violation = 0;    ///< of all limits; 0 where every one is met
  double unavoidable = 0;  ///< what of it the teeth alone tell
  double objective = 0;    ///< the less the better
  double unit = 1;         ///< of the objective, so that it is a number of the size of 1

  /// One number to be least over pairs of the same teeth: below 0 where every limit is met but
  /// those that the teeth alone miss, by the objective; else the violation.
  double merit() const;
};

/// How finely it is searched: to drop most of many combinations, to put the rest in order, to tell.
enum class SearchDepth { rough, coarse, fine };

/// The cheap tests, in the order in which they are made.
enum class CheapTest { ratio, hunting, centre_distance, undercut };

/// Which of them a combination fails first, and how far it is from passing: relative to the ratio;
/// 1 of teeth with a common divisor; by how many modules of shift or distance.
struct Refusal {
  CheapTest test = CheapTest::ratio;
  double missing = 0;
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

  /// Empty where every cheap test is passed.
  std::optional<Refusal> refusal() const;

  /// Empty where no pair of these teeth has a working pressure angle. Where bounds leave no pair,
  /// one within those of the shifts that is near to what is requested.
  std::optional<PairDesign> best(SearchDepth depth) const;

  /// The pair of these shifts of the normal section, in a centre distance that belongs to them.
  /// Whether tips dig into fillets takes most of the time, and is asked only of a pair that would
  /// else be better than `to_beat`; before the fine search only if it meets every other limit.
  PairDesign at(double first, double second, double centre_distance, double to_beat,
                SearchDepth depth) const;

 private:
  struct Interval {
    double from = 0, to = 0;
    bool empty() const { return !(from <= to); }
    Interval operator+(const Interval& other) const { return {from + other.from, to + other.to}; }
    Interval operator&(const Interval& other) const;
  };
  Interval shifts_of(std::size_t index, bool without_undercut) const;
  Interval wanted_sums() const;
  Interval sums() const;
  Interval first_shifts(double sum) const;
  double missing_sum(bool without_undercut) const;
  double distance_of(double sum) const;
  double sum_at(double distance) const;
  double balanced_shift(double sum, double distance, const Interval& shifts) const;
  PairDesign best_split(double sum, SearchDepth depth) const;
  double objective_of(const GearPairNumbers& numbers, const gear::PairGeometry& mesh) const;

  const GearPairProblem& problem_;
  GearCombination combination_;
  double normal_ = 1;  ///< cos β: shifts of the section over those of the normal section
  double backlash_ = 0;
  std::array<gear::SpurGear, 2> unshifted_;
  double closest_ = 0;  ///< centre distance at which the line of action still has a length
};

/// Whether `a` has the lesser centre distance, of the same one the fewer teeth.
bool is_smaller(const PairDesign& a, const PairDesign& b);

/// Whether `a` is to be preferred: meets more, else is better by the objective, else is smaller.
bool is_better(const PairDesign& a, const PairDesign& b);

/// Whether neither violation nor objective of the two differ by more than rounding.
bool is_as_good(const PairDesign& a, const PairDesign& b);

}  // namespace cognate::problems
