/// @file Solvers: each takes a model, a start and options, and returns a point and why it stopped.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "synthesis/optimise/model.hpp"

namespace cognate::synthesis {

/// Every way out of a solver.
enum class Stop {
  converged,        ///< the solver's own test of optimality or of stagnation was met
  iteration_limit,  ///< `max_iterations` was reached
  time_limit,       ///< `time_limit` seconds had passed
  interrupted,      ///< `interrupted` became true
  no_value,         ///< the model has no value at the start
  infeasible,       ///< the solver ended at a point that violates the constraints
  failed,           ///< numerical difficulties; `x` is the best point seen
};

struct Options {
  double tolerance = 1e-12;   ///< relative change of the objective at which to stop
  double feasibility = 1e-9;  ///< largest violation of a constraint that counts as met
  int max_iterations = 200;
  double time_limit = std::numeric_limits<double>::infinity();  ///< seconds
  const std::atomic<bool>* interrupted = nullptr;
};

struct Solution {
  std::vector<double> x;
  double objective = 0;  ///< ‖r‖² or max |r|, by the model's objective
  double violation = 0;  ///< largest max(0, −c) and excess over the bounds, re-evaluated at x
  std::vector<double> multipliers;  ///< of the constraints, where the solver has them
  Stop stop = Stop::failed;
  int iterations = 0;
  std::uint64_t evaluations = 0;  ///< of the residuals
  std::uint64_t gradients = 0;    ///< of their Jacobian
};

/// The back ends. Ceres minimises sums of squares within bounds and refuses models with other
/// constraints or a minimax objective (`can_solve` says which); the others take every model.
enum class Backend { gauss_newton, ceres, slsqp, cobyla, ipopt };

std::string_view name(Backend backend);

/// Whether `backend` can honour everything that `model` asks for.
bool can_solve(Backend backend, const Model& model);

/// The local minimum of `model` that `backend` reaches from `start` (clamped to the bounds).
Solution solve(Backend backend, const Model& model, std::span<const double> start,
               const Options& options = {});

}  // namespace cognate::synthesis
