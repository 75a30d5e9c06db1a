/// @file The best cam from a start, by optimisation under limits that hold at every position.
#pragma once

#include <optional>
#include <vector>

#include "analysis/cam/cam.hpp"
#include "problems/cam/variables.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {

/// Where a search ended.
struct CamCandidate {
  std::vector<double> x;
  double objective = 0;        ///< in the file's unit (rad for angles), exact over the turn
  double violation = 0;        ///< the worst of all margins below 0, exact over the turn
  synthesis::Solver solver{};  ///< which came here
};

/// Limits at every position are infinitely many. They are kept by exchange (Blankenship & Falk
/// 1976): the problem is solved with some positions, those where its solution breaks a limit most
/// (all local extremes, found exactly) are added, until none does. Nothing where `start` has no
/// value.
std::optional<CamCandidate> search_cam(const CamVariables& variables, std::vector<double> start,
                                       synthesis::Solver solver, const Deadline& deadline,
                                       Work& work);

/// What counts as no violation: solvers reach constraints to about this.
inline constexpr double kCamFeasibility = 1e-10;

/// Whether `a` is the better: feasible before infeasible, then by the objective, or the violation.
inline bool is_better(const CamCandidate& a, const CamCandidate& b) {
  const bool a_keeps = a.violation <= kCamFeasibility, b_keeps = b.violation <= kCamFeasibility;
  if (a_keeps != b_keeps) return a_keeps;
  return a_keeps ? a.objective < b.objective : a.violation < b.violation;
}

}  // namespace cognate::problems
