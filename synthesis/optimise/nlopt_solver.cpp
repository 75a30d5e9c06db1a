#include "synthesis/optimise/nlopt_run.hpp"

namespace cognate::synthesis {
namespace {

using Known = NloptMethod::Constraints;

NloptMethod method_of(Backend backend) {
  switch (backend) {
    // These two know inequalities, but NLopt 2.7 stops them anywhere when they start outside one
    // (Hock-Schittkowski 22 from (2, 2)).
    case Backend::mma:
      return {NLOPT_LD_MMA, true, Known::none};
    case Backend::ccsaq:
      return {NLOPT_LD_CCSAQ, true, Known::none};
    case Backend::cobyla:
      return {NLOPT_LN_COBYLA, false, Known::all};
    case Backend::bobyqa:
      return {NLOPT_LN_BOBYQA, false, Known::none};
    default:
      return {NLOPT_LD_SLSQP, true, Known::all};
  }
}

}  // namespace

Outcome minimise_with_nlopt(Backend backend, DenseModel& model, const Options& options) {
  NloptMethod method = method_of(backend);
  Program program(model);
  // Powell's quadratic models want two unknowns or more.
  if (backend == Backend::bobyqa && program.size() < 2) method.algorithm = NLOPT_LN_COBYLA;
  return run_nlopt(method, program, {program.lower(), program.upper()}, options);
}

}  // namespace cognate::synthesis
