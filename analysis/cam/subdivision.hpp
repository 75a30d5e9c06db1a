/// @file A function on an interval as polynomials on as many subintervals as it needs.
#pragma once

#include <limits>
#include <vector>

#include "analysis/cam/extremes.hpp"
#include "analysis/numbers/chebyshev_series.hpp"

namespace cognate::cam {

/// A subinterval with what is known of the function there.
struct Subinterval {
  double from = 0, to = 0;
  double coarser_misfit = std::numeric_limits<double>::infinity();  ///< of the one it is a half of
  ChebyshevSamples values{};
  ChebyshevSeries series{};
  double misfit = std::numeric_limits<double>::infinity();  ///< of the series, as seen
  double size = 0;  ///< of the function: the greater of the scale and the greatest sample

  /// The argument for t in [-1, 1], the ends exactly for -1 and 1.
  double at(double t) const {
    if (t <= -1) return from;
    if (t >= 1) return to;
    const double half = (to - from) / 2;
    return from + half + half * t;
  }
};

/// Represents f on [from, to] by interpolants of degree 24 to `kTight` of its size, halving where
/// that fails. What a halving does not improve is taken for noise of f itself and let pass if it is
/// below `kNoise`, or below `kSteepNoise` where f is so steep that rounding of its argument
/// explains it.
class Subdivision {
 public:
  /// Relative to the size of the function.
  static constexpr double kTight = 2e-14, kNoise = 1e-12, kSteepNoise = 1e-9;

  /// A `scale` that is no positive number counts as 0.
  Subdivision(FunctionRef f, double from, double to, double scale);

  /// Takes the next subinterval, breadth first: its series is good, or it is the end of the
  /// splitting (`is_resolved` false) and only the samples count. Null when there is none left.
  const Subinterval* next();
  bool is_resolved() const { return is_resolved_; }

  /// The ends of the whole with f there.
  Extreme begin() const { return {pending_.front().from, pending_.front().at_from}; }
  Extreme end() const { return end_; }
  double scale() const { return scale_; }

 private:
  /// An interval still to look at, with the values that its neighbours have already.
  struct Pending {
    double from, to, at_from, at_to, coarser_misfit;
  };

  void sample(const Pending& pending);
  double misfit() const;
  double noise() const;
  bool is_good() const;
  bool is_stagnant(double misfit) const;
  bool split(const Pending& pending);

  /// Ends the work on a function that is not analytic.
  static constexpr std::size_t kMostIntervals = 4000;

  FunctionRef f_;
  Extreme end_;
  double scale_, least_width_;
  std::vector<Pending> pending_;
  std::size_t taken_ = 0;
  Subinterval current_;
  bool is_resolved_ = false;
};

}  // namespace cognate::cam
