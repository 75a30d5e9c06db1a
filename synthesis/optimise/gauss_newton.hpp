/// @file Constrained Gauss–Newton: the solver of the inner loop.
#pragma once

#include "synthesis/optimise/solver.hpp"

namespace cognate::synthesis {

/// Levenberg–Marquardt whose step is a quadratic program: at x with residuals r and Jacobian J it
/// takes the dx that minimises ½|r + J dx|² + ½ λ |D dx|² subject to the bounds and the linearised
/// constraints c + C dx ≥ 0 (equalities: = 0), local variables eliminated row by row (Schur
/// complement). Steps are judged by ½|r|² + Σ ρᵢ max(0, −cᵢ), of equalities ρᵢ |cᵢ|. With objective
/// max_abs the step minimises the largest |rᵢ + Jᵢ dx| instead (Madsen 1975, "An algorithm for
/// minimax solution of overdetermined systems of non-linear equations", with the trust region
/// replaced by the damping).
///
/// Where constraints contradict each other in linear form they are relaxed, so that the solver ends
/// at a point of small violation instead of giving up; `Solution::stop` says which it is.
Solution solve_gauss_newton(const Model& model, std::span<const double> start,
                            const Options& options);

}  // namespace cognate::synthesis
