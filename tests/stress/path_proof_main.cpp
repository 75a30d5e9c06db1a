/// Proofs over boxes about designs whose error is known, which they must never discard, on random
/// timed paths: path_proof [BOXES [SEED]]. Exits with 1 where one was.
#include <fmt/core.h>

#include <cstdlib>
#include <random>

#include "analysis/batch/instruction_set.hpp"
#include "synthesis/lanes/path_proof.hpp"
#include "tests/support/planted_proofs.hpp"

namespace {

namespace synthesis = cognate::synthesis;
namespace test = cognate::test;

struct Tally {
  long boxes = 0, discarded = 0, proved_half = 0, proved_most = 0;
};

void judge(const test::PlantedProof& planted, std::mt19937_64& random, Tally& tally) {
  constexpr int kBoxes = 64;
  std::vector<synthesis::ProportionBox> boxes;
  for (int i = 0; i < kBoxes; ++i) {
    boxes.push_back(test::box_with(planted.at, planted.assembly, planted.proportions, random));
  }
  const synthesis::PathProver prover(planted.path, test::no_limits());
  std::vector<synthesis::StageVerdict> above(kBoxes), below(kBoxes);
  // What the error of the design itself is off by, in sums of squares of order one.
  const double rounding = 1e-13;
  prover.judge(boxes, planted.error * (1 + 1e-7) + rounding, 0, above);
  prover.judge(boxes, 0.99 * planted.error, 0.5 * planted.error, below);
  for (int i = 0; i < kBoxes; ++i) {
    ++tally.boxes;
    tally.discarded += above[i].reached == 2;
    tally.proved_half += below[i].reached > 0;
    tally.proved_most += below[i].reached == 2;
  }
}

}  // namespace

int main(int count, char** words) {
  const long boxes = count > 1 ? std::atol(words[1]) : 1'000'000;
  std::mt19937_64 random(count > 2 ? std::atol(words[2]) : 1);
  Tally tally;
  while (tally.boxes < boxes) {
    const auto planted = test::planted_proof(random);
    if (planted) judge(*planted, random, tally);
  }
  fmt::print("{} boxes, {} discarded; half the error proved in {}, 99 % in {}\n", tally.boxes,
             tally.discarded, tally.proved_half, tally.proved_most);
  return tally.discarded > 0;
}
