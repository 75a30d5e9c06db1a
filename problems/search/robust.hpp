/// @file Designs whose error over their tolerances is least, by a quantile or in the worst case,
/// for any kind whose problem is a model.
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
  /// Of what is made: its error is no greater than the quantile. 1: the worst case.
  double share = 0.99;
  ToleranceDistribution distribution = ToleranceDistribution::normal;
  int components = 2;               ///< see QuantileOptions
  std::vector<double> scale;        ///< likewise
  double unit = 1;                  ///< of an error of the model, in the file's unit
  std::vector<RobustStart> starts;  ///< the nominal optimum first
  bool lacks_tolerances = false;    ///< of a nominal design that meets every constraint
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
  double error = 0;   ///< nominal
  double figure = 0;  ///< quantile or worst case, by samples that the search has not seen
};

struct RobustAnswer {
  /// From the nominal optimum to the least figure: each point but the first has a lesser one than
  /// the one before. At least one, unless no start is within its constraints.
  std::vector<RobustPoint> front;
  std::size_t samples = 0;  ///< by which its ends are judged
};

/// The limits of a file and a transmission angle far from those of dead points, near which every
/// design minds its dimensions much; empty where the file's own limits are as narrow. Its nominal
/// minima are starts that a search for the least nominal error does not come to.
std::optional<Constraints> with_good_transmission(const Constraints& constraints);

/// Where the search for nominal minima, that for more starts, and that from both end.
inline constexpr double kNominalDone = 0.3, kStartsDone = 0.6;

/// Whether the worst case is to be least.
inline bool is_worst_case(const RobustTask& task) {
  return task.share == 1;
}

/// Starts from each nominal design and along bounds on the nominal error. No figure is worse than
/// the nominal optimum's, which is itself a point.
RobustAnswer robust_designs(const RobustTask& task, const Run& run, const Deadline& deadline);

/// Puts the answer into `result`: the robust design first, then the others of the front by their
/// figure, the nominal optimum last; the family "Robust front"; quantities and a note.
void add_robust(const RobustTask& task, RobustAnswer answer, bool is_angle, Result& result);

}  // namespace cognate::problems
