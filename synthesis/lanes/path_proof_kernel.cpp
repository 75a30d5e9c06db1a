// Judges boxes of proportions, one in each lane. Compiled once for each instruction set:
// COGNATE_ISA names it, see lane_numbers.hpp.
#include "synthesis/lanes/path_proof_kernel.hpp"

#include "synthesis/lanes/path_proof_lanes.hpp"

namespace cognate::synthesis::COGNATE_ISA {

void prove_paths(const PathProofTask& task) {
  PathProof proof(task);
  for (int first = 0; first < task.boxes; first += kLanes) proof.judge(first);
}

}  // namespace cognate::synthesis::COGNATE_ISA
