/// @file What the tolerances of a design do to it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/numbers/vec2.hpp"

namespace cognate::problems {

/// How much of an error one dimension makes.
struct Contribution {
  std::string dimension;
  double sensitivity = 0;      ///< ∂q/∂x at the worst position; of a point |∂P/∂x|
  double largest = 0;          ///< the greatest over all positions, by magnitude
  std::size_t largest_at = 0;  ///< where that is
  double amount = 0;           ///< |∂q/∂x|·t at the worst position
  double share = 0;            ///< of the sum of these
};

/// Deviations of a quantity at one position. Not numbers where the box of tolerances comes to a
/// dead point there.
struct PositionFigures {
  double nominal = 0;          ///< its nominal error; 0 of a plain deviation
  double linear = 0;           ///< worst case of first order, Σ |∂q/∂x| t
  double low = 0, high = 0;    ///< exact extremes over the box; of a point 0 and the distance
  double rss = 0;              ///< root sum of squares of |∂q/∂x| t
  double mean = 0, sigma = 0;  ///< of the samples
};

/// A share of the samples errs by no more than this.
struct Quantile {
  double share = 0;
  double error = 0;
};

/// One quantity that the file is about. Angles are in degrees, lengths in the file's unit.
struct ToleranceFigures {
  std::string name;  ///< "rocker", "P", "error"; "C transmission"
  bool angle = false;
  bool is_point = false;  ///< the deviation is a distance
  bool judged = false;    ///< what yield, quantiles and allocation are about
  bool exact = true;      ///< whether `low` and `high` are known
  std::vector<PositionFigures> positions;
  std::vector<Vec2d> along;  ///< unit vectors along which a point's deviation counts; else empty
  std::size_t worst = 0;     ///< of the positions: where the linear worst case is greatest
  std::size_t worst_exact = 0;
  bool exact_everywhere = false;  ///< else `low` and `high` are known at `worst_exact` alone
  std::vector<Contribution> contributions;  ///< at `worst`, greatest first
  std::vector<Quantile> quantiles;          ///< of the greatest error over all positions
  double mean_extreme = 0;                  ///< of that error
  std::vector<double> histogram_edges;      ///< of that error
  std::vector<std::size_t> histogram;
};

/// What the play of one pin does.
struct ClearanceFigures {
  std::string joint;
  double radial = 0;
  double massless = 0;  ///< greatest deviation of the judged quantity: the pin anywhere in it
  std::size_t massless_at = 0;
  std::optional<double> loaded;  ///< with the pin where its reaction presses it; with loads alone
  std::size_t loaded_at = 0;
};

/// The tolerance that an allocation gives a dimension.
struct AllocatedTolerance {
  std::string dimension;
  double tolerance = 0;  ///< ±; infinite where the dimension does not change the error
  double cost = 0;       ///< factor/tolerance
};

/// The whole answer to `[tolerance]` for one design.
struct ToleranceResult {
  struct Dimension {
    std::string name;
    double nominal = 0, plus = 0, minus = 0;
  };
  std::vector<Dimension> dimensions;
  std::vector<double> drive;  ///< of the positions: degrees of a crank, length of a slider
  bool drive_slides = false;
  std::vector<ToleranceFigures> quantities;
  std::size_t samples = 0, assembled = 0;
  std::optional<double> yield, yield_standard_error;  ///< of the judged quantity
  std::vector<ClearanceFigures> clearances;
  std::optional<double> clearance_linear;  ///< of all pins at once, massless, to first order
  std::vector<AllocatedTolerance> allocation;
  std::optional<double> allocation_cost, allocation_error;  ///< the error as allocated
  std::optional<std::string> refused;  ///< why there are no figures of first order
  std::vector<std::string> notes;
};

}  // namespace cognate::problems
