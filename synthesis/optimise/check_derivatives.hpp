/// @file Are the derivatives of a model those of its values?
#pragma once

#include <span>
#include <string>

#include "synthesis/optimise/model.hpp"

namespace cognate::synthesis {

/// The entry in which a model's derivatives and numerical ones differ most.
struct DerivativeError {
  enum class Part { residuals, constraints };

  bool has_value = false;  ///< false: the model has no value at the point, nothing was compared
  Part part = Part::residuals;
  int row = -1;
  int variable = -1;  ///< global or local, as the model counts them
  double analytic = 0;
  double numeric = 0;
  /// |analytic − numeric| · scale of the variable / largest |derivative · scale| or |value| of the
  /// row, 1e-12 at least.
  double relative = 0;

  /// "residual 3 by crank: 1.25, numerically 1.5 (relative 0.2)"
  std::string describe(const Model& model) const;
};

/// Compares every derivative at `x`, global, local and of the constraints, with central differences
/// extrapolated to step 0 (Ridders 1982, "Accurate computation of F'(x) and F'(x)F''(x)"). Right
/// derivatives of a smooth model agree to about 1e-9. Probes may leave the bounds by 1 % of a
/// scale where x lies on one.
[[nodiscard]] DerivativeError check_derivatives(const Model& model, std::span<const double> x);

}  // namespace cognate::synthesis
