#include "problems/search/backend_choice.hpp"

namespace cognate::problems {

using synthesis::Backend;

Backend backend_of(SolverChoice choice) {
  switch (choice) {
    case SolverChoice::automatic:
    case SolverChoice::gauss_newton:
      return Backend::gauss_newton;
    case SolverChoice::ceres:
      return Backend::ceres;
    case SolverChoice::slsqp:
      return Backend::slsqp;
    case SolverChoice::mma:
      return Backend::mma;
    case SolverChoice::ccsaq:
      return Backend::ccsaq;
    case SolverChoice::cobyla:
      return Backend::cobyla;
    case SolverChoice::bobyqa:
      return Backend::bobyqa;
    case SolverChoice::ags:
      return Backend::ags;
    case SolverChoice::isres:
      return Backend::isres;
    case SolverChoice::crs:
      return Backend::crs;
    case SolverChoice::mlsl:
      return Backend::mlsl;
    case SolverChoice::direct:
      return Backend::direct;
    case SolverChoice::ipopt:
      return Backend::ipopt;
  }
  return Backend::gauss_newton;
}

std::string search_origin(Backend backend, std::string start) {
  return std::move(start) + refined_by(backend);
}

std::string refined_by(Backend backend) {
  const std::string text = " + gauss-newton";
  return backend == Backend::gauss_newton ? text : text + " + " + std::string(name(backend));
}

}  // namespace cognate::problems
