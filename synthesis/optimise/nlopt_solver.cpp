#include "synthesis/optimise/nlopt_run.hpp"

namespace cognate::synthesis {
namespace {

using Known = NloptMethod::Constraints;

NloptMethod method_of(Solver solver) {
  switch (solver) {
    // These two know inequalities, but NLopt 2.7 stops them anywhere when they start outside one
    // (Hock-Schittkowski 22 from (2, 2)).
    case Solver::mma:
      return {NLOPT_LD_MMA, true, Known::none};
    case Solver::ccsaq:
      return {NLOPT_LD_CCSAQ, true, Known::none};
    case Solver::cobyla:
      return {NLOPT_LN_COBYLA, false, Known::all};
    case Solver::bobyqa:
      return {NLOPT_LN_BOBYQA, false, Known::none};
    default:
      return {NLOPT_LD_SLSQP, true, Known::all};
  }
}

}  // namespace

Outcome minimise_with_nlopt(Solver solver, DenseModel& model, const Options& options) {
  NloptMethod method = method_of(solver);
  Program program(model);
  // Powell's quadratic models want two unknowns or more.
  if (solver == Solver::bobyqa && program.size() < 2) method.algorithm = NLOPT_LN_COBYLA;
  return run_nlopt(method, program, {program.lower(), program.upper()}, options);
}

}  // namespace cognate::synthesis
