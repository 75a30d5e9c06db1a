/// @file What the rows of an analysis say of the motion as a whole.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/evaluation/force_extremes.hpp"
#include "problems/evaluation/sweep.hpp"

namespace cognate::problems {

/// The least and the greatest of a quantity, and the drive's value (degrees or length) where it is
/// met first.
struct Extremes {
  double min = 0;
  double min_at = 0;
  double max = 0;
  double max_at = 0;
};

/// Over `values`, one for each row; empty where none is a number.
std::optional<Extremes> extremes(std::span<const double> values, std::span<const double> drive);

/// The greatest gap at a joint, relative to the extent of the mechanism; and, where reactions were
/// computed, the greatest difference between the driving torque of the reactions and that of
/// virtual work, relative to the greatest torque.
std::vector<Quantity> check_quantities(const Sweep& sweep);

/// What is reported of forces over a motion.
struct ForceSummary {
  std::vector<Quantity> quantities;
  std::vector<std::string> notes;
};

/// Extremes of the driving torque, its greatest magnitude and its root mean square over the drive's
/// coordinate, and the extremes of each reaction, with the drive's value where they occur.
/// For a reaction of a turning joint the greatest magnitude, for a slide the greatest normal force
/// of either sign. Those between and at rows (`refined`; empty: of the rows alone). An extreme that
/// does not exist is left out: "…_unbounded_at_deg" is the first place near which the quantity goes
/// beyond every bound, and a note has them all.
ForceSummary force_quantities(const AnalysisProblem& problem, const Sweep& sweep,
                              const std::optional<ForceExtremes>& refined);

/// A sentence for each run of rows whose first open dyad is the same: the drive's range, the dyad,
/// and the distance that its links cannot span where it is worst; or that its position there is not
/// determined. Some sentences only where there are many such runs.
std::vector<std::string> open_row_notes(const AnalysisProblem& problem, const Sweep& sweep);

}  // namespace cognate::problems
