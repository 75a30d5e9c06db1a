#include "problems/linkage/cycle/operation.hpp"

namespace cognate::problems {

Operation in_joules(Operation operation, double metres) {
  const double square = metres * metres;
  for (LinkMass& link : operation.links) {
    link.mass *= square;
    link.mass_per_length *= square;
  }
  for (WorkingLoad& load : operation.loads) load.force = metres * load.force;
  return operation;
}

}  // namespace cognate::problems
