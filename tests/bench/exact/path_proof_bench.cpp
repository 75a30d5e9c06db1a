/// Time for a box in the proofs of timed paths with four unknown proportions, with each instruction
/// set and by the bound of single directions, in one run: path_proof_bench [ROUNDS]. Least times of
/// alternating rounds, as ratios to the scalar kernel.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

#include "analysis/batch/instruction_set.hpp"
#include "synthesis/lanes/path_proof.hpp"
#include "tests/support/planted_proofs.hpp"

namespace {

namespace synthesis = cognate::synthesis;
namespace test = cognate::test;

constexpr int kPaths = 40;
constexpr int kBoxes = 256;  // of each path

struct Case {
  test::PlantedProof planted;
  std::vector<synthesis::ProportionBox> boxes;
};

std::vector<Case> cases() {
  std::mt19937_64 random(1);
  std::vector<Case> all;
  while (all.size() < kPaths) {
    auto planted = test::planted_proof(random);
    if (!planted) continue;
    Case made{*std::move(planted), {}};
    for (int i = 0; i < kBoxes; ++i) {
      made.boxes.push_back(
          test::box_with(made.planted.at, made.planted.assembly, made.planted.proportions, random));
    }
    all.push_back(std::move(made));
  }
  return all;
}

/// What a way of bounding needs for all boxes, and how many it proves.
struct Score {
  double seconds = std::numeric_limits<double>::infinity();
  int proved = 0;
};

template <class Prove>
void run(const std::vector<Case>& all, const Prove& prove, Score& score) {
  int proved = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (const Case& each : all) proved += prove(each, 0.9 * each.planted.error);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  score = {std::min(score.seconds, spent.count()), proved};
}

int proved_in_lanes(const Case& each, double target, cognate::InstructionSet set) {
  std::vector<synthesis::StageVerdict> verdicts(each.boxes.size());
  synthesis::PathProver(each.planted.path, test::no_limits(), set)
      .judge(each.boxes, target, 0, verdicts);
  return static_cast<int>(std::ranges::count(verdicts, 2, &synthesis::StageVerdict::reached));
}

int proved_singly(const Case& each, double target) {
  const synthesis::PathBound bound(each.planted.path, test::no_limits());
  return static_cast<int>(std::ranges::count_if(
      each.boxes, [&](const auto& box) { return bound(box, target).least >= target; }));
}

}  // namespace

int main(int count, char** words) {
  const int rounds = count > 1 ? std::atoi(words[1]) : 5;
  const std::vector<Case> all = cases();
  const auto sets = cognate::instruction_sets();
  std::vector<Score> in_lanes(sets.size());
  Score singly;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < sets.size(); ++i) {
      run(
          all,
          [&](const Case& each, double target) { return proved_in_lanes(each, target, sets[i]); },
          in_lanes[i]);
    }
    run(all, proved_singly, singly);
  }
  const auto row = [&](const char* name, const Score& score) {
    fmt::print("{:<24} {:>8.2f} us a box, {:.3f} of scalar; {} of {} boxes proved\n", name,
               1e6 * score.seconds / (kPaths * kBoxes), score.seconds / in_lanes[0].seconds,
               score.proved, kPaths * kBoxes);
  };
  for (std::size_t i = 0; i < sets.size(); ++i) row(cognate::name(sets[i]), in_lanes[i]);
  row("bound of each direction", singly);
}
