/// @file Designs whose quantile of the error over their tolerances is least, for any kind whose
/// problem is a model.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/tolerance/dimensions.hpp"
#include "synthesis/optimise/model.hpp"
#include "synthesis/raster/model_raster.hpp"

namespace cognate::problems {

/// A design from which robust ones are sought: the problem as a model whose variables hold every
/// dimension that has a tolerance, and the design's variables.
struct RobustStart {
  std::shared_ptr<const synthesis::Model> model;
  std::vector<double> x;
  /// Bounds of the variables where they are narrower than the model's: dimensions that are given.
  std::vector<double> lower, upper;
  std::vector<TolerancedDimension> dimensions;
  std::vector<synthesis::AxisVariable> variables;  ///< what each of these is
};

/// What is asked.
struct RobustTask {
  double share = 0.99;  ///< of what is made: its error is no greater than the quantile
  ToleranceDistribution distribution = ToleranceDistribution::normal;
  int components = 2;               ///< see QuantileOptions
  std::vector<double> scale;        ///< likewise
  double unit = 1;                  ///< of an error of the model, in the file's unit
  std::vector<RobustStart> starts;  ///< the nominal optimum first
  /// Brings the local variables of a point to where they are best by the rules of the file (its
  /// order); false where there is no such place. Empty: they need none.
  std::function<bool(const RobustStart& start, std::vector<double>& x)> place;
  /// The design at a point of the model of a start; empty where it breaks a constraint.
  std::function<std::optional<Design>(const RobustStart& start, const std::vector<double>& x)>
      design;
  std::function<double(const Design& design)> error;  ///< the nominal one, in the file's unit
};

/// A point of the front.
struct RobustPoint {
  Design design;
  double error = 0;     ///< nominal
  double quantile = 0;  ///< by samples that the search has not seen
};

struct RobustAnswer {
  /// From the nominal optimum to the least quantile: each point but the first has a lesser quantile
  /// than the one before. At least one, unless no start is within its constraints.
  std::vector<RobustPoint> front;
};

/// The limits of a file and a transmission angle far from those of dead points, near which every
/// design minds its dimensions much; empty where the file's own limits are as narrow. Its nominal
/// minima are starts that a search for the least nominal error does not come to.
std::optional<Constraints> with_good_transmission(const Constraints& constraints);

/// Where the search for nominal minima, that for more starts, and that from both end.
inline constexpr double kNominalDone = 0.3, kStartsDone = 0.6;

/// `run` with a part of its progress.
Run part_of(const Run& run, double from, double to);

/// Starts from each nominal design and along bounds on the nominal error. No quantile is worse than
/// the nominal optimum's, which is itself a point.
RobustAnswer robust_designs(const RobustTask& task, const Run& run, const Deadline& deadline);

/// Puts the answer into `result`: the robust design first, then the others of the front by their
/// quantile, the nominal optimum last; the family "Robust front"; quantities and a note.
void add_robust(const RobustTask& task, RobustAnswer answer, bool is_angle, Result& result);

}  // namespace cognate::problems
