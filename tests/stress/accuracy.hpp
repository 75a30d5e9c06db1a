/// @file The worst errors of a form over a set of configurations.
#pragma once

#include <cstdint>

#include "tests/stress/closure_forms.hpp"

namespace cognate::stress {

/// The formula's own few roundings are allowed for up to this condition.
inline constexpr double kWell = 5;

/// Worst error and where it was: of the directions of coupler and rocker, and of the coupler point
/// relative to its size.
struct Accuracy {
  double error = 0;             ///< in units of 2⁻⁵³
  double well_conditioned = 0;  ///< the same where the condition is kWell at most
  double per_condition = 0;     ///< elsewhere, in units of 2⁻⁵³·condition
  double condition = 0;         ///< the greatest met
  std::int64_t closed = 0;      ///< of the configurations, those that close
  std::int64_t total = 0;
  std::int64_t wrong_flags = 0;
  double wrong_flag_distance = 0;  ///< the greatest, in units of rounding of all inputs

  /// One result: its error in units of rounding, and its condition.
  void include_error(double error_here, double condition_here);
  /// One validity flag, as it should be and as it was, and how far the boundary is.
  void include_flag(bool should_close, bool closes, double boundary_distance);
  void include(const Configuration& at, const ExactClosure& exact, const Answer& answer);
  void include(const Accuracy& other);
};

}  // namespace cognate::stress
