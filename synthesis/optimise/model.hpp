/// @file The one interface between problems and solvers.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace cognate::synthesis {

/// A free dimension. `scale` is a typical magnitude: solvers work in value / scale.
struct Variable {
  std::string name;
  double lower = 0;
  double upper = 0;
  double scale = 1;
};

/// What the residuals are folded into.
enum class Objective { sum_of_squares, max_abs };

/// A nonlinear program: least ‖r(x)‖² or max |r(x)| subject to bounds and c(x) ≥ 0, of which the
/// first `equality_count()` are equalities, c(x) = 0.
///
/// The variables are n = global + local ones. A local variable touches only the residuals that name
/// it (the crank angle of one target point), so that a solver may eliminate it row by row: column j
/// of the Jacobian beyond the global ones is zero but where `local_of_residual()[row] == j`.
/// Constraints depend on global variables only.
///
/// Implementations are immutable: every function may be called from many threads at once.
class Model {
 public:
  virtual ~Model() = default;

  /// Global variables, then local ones.
  virtual std::span<const Variable> variables() const = 0;
  virtual int residual_count() const = 0;
  virtual int constraint_count() const { return 0; }  ///< equalities among them
  virtual int equality_count() const { return 0; }
  virtual Objective objective() const { return Objective::sum_of_squares; }

  /// For each residual the local variable (0, 1, …) it depends on, or −1. Empty: no local ones.
  virtual std::span<const int> local_of_residual() const { return {}; }
  virtual int local_count() const { return 0; }

  /// Residuals at `x`, and on request their derivatives: `jacobian` is row-major,
  /// residual_count × global count, `local` has one entry for each residual. Either both are empty
  /// or both are full, (empty if there are no global / local variables). Returns false
  /// where x has no value (the linkage does not close there); the outputs are then unspecified.
  virtual bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                         std::span<double> local) const = 0;

  /// Constraints, equalities first, each scaled to order 1; `jacobian` empty or row-major,
  /// constraint_count × global count. Defined for every x within the bounds.
  virtual void constraints(std::span<const double> x, std::span<double> c,
                           std::span<double> jacobian) const;

  /// Whether `lagrangian_hessian` is there.
  virtual bool has_hessian() const { return false; }

  /// Σ `of_residuals`ᵢ ∇²rᵢ + Σ `of_constraints`ₖ ∇²cₖ at x, by global and local variables alike:
  /// row-major, n × n, symmetric. Returns false where x has no value or no finite derivatives; the
  /// output is then unspecified.
  virtual bool lagrangian_hessian(std::span<const double> x, std::span<const double> of_residuals,
                                  std::span<const double> of_constraints,
                                  std::span<double> out) const;

  /// How many variables are global.
  int global_count() const { return static_cast<int>(variables().size()) - local_count(); }
};

}  // namespace cognate::synthesis
