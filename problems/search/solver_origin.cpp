#include "problems/search/solver_origin.hpp"

#include <utility>

namespace cognate::problems {

using synthesis::Solver;

std::string search_origin(Solver solver, std::string start) {
  return std::move(start) + refined_by(solver);
}

std::string search_origin(std::initializer_list<Solver> solvers) {
  std::string origin = "search";
  for (const Solver solver : solvers) origin.append(" + ").append(synthesis::name(solver));
  return origin;
}

std::string refined_by(Solver solver) {
  const std::string text = " + gauss-newton";
  return solver == Solver::gauss_newton ? text : text + " + " + std::string(name(solver));
}

}  // namespace cognate::problems
