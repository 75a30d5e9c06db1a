/// Gear pairs from problem to designs: cheap tests of every choice of teeth and module, then the
/// best shifts of each that is left.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/parallel.hpp"
#include "problems/deadline.hpp"
#include "problems/gear/gear_combinations.hpp"
#include "problems/gear/gear_notes.hpp"
#include "problems/gear/gear_pair_design.hpp"
#include "problems/gear/gear_pair_search.hpp"
#include "problems/gear/gear_result.hpp"
#include "problems/verify.hpp"

namespace cognate::problems {
namespace {

using Found = std::vector<std::optional<FoundPair>>;  ///< one for each combination

/// Of more combinations than these, each with two unknowns, those are searched finely that a coarse
/// search puts first.
constexpr std::size_t kMostFine = 100;

/// Searches combinations; keeps what its parts share.
class Solver {
 public:
  Solver(const GearPairProblem& problem, const Run& run, const Deadline& deadline,
         GearPairResult& result)
      : problem_(problem), run_(run), deadline_(deadline), result_(result) {}

  void solve() {
    Sieved sieved = sieve(problem_, deadline_);
    tell(sieved);
    const bool none = sieved.left.empty();
    auto combinations = none ? sieved.nearest : sieved.left;
    if (!problem_.centre_distance && combinations.size() > kMostFine) {
      combinations = first_by_coarse_search(combinations);
    }
    add_fact("combinations_searched", double(combinations.size()));
    Found found = search(combinations, SearchDepth::fine);
    take_best(found);
  }

 private:
  void add_fact(const char* name, double value) { result_.facts.push_back({name, value}); }

  void tell(const Sieved& sieved) {
    add_fact("combinations", double(sieved.tested));
    add_fact("refused_by_ratio", double(sieved.refused_by_ratio));
    add_fact("refused_by_hunting", double(sieved.refused_by_hunting));
    add_fact("refused_by_centre_distance", double(sieved.refused_by_centre_distance));
    add_fact("refused_by_undercut", double(sieved.refused_by_undercut));
    result_.work.candidates = sieved.tested;
  }

  Found search(const std::vector<GearCombination>& combinations, SearchDepth depth) {
    Found found(combinations.size());
    result_.work.threads = thread_count(run_.threads);
    double best = HUGE_VAL;  // of those of thread 0
    parallel_for(static_cast<int>(combinations.size()), run_.threads, [&](int index, int thread) {
      const auto i = static_cast<std::size_t>(index);
      if (index > 0 && deadline_.reached()) return;
      found[i] = GearPairSearch(problem_, combinations[i]).best(depth);
      if (thread != 0 || !run_.progress) return;
      if (found[i] && found[i]->violation == 0) best = std::min(best, found[i]->objective);
      run_.progress(double(i + 1) / double(combinations.size()), best);
    });
    return found;
  }

  std::vector<GearCombination> first_by_coarse_search(
      const std::vector<GearCombination>& combinations) {
    Found found = search(combinations, SearchDepth::coarse);
    sort(found);
    found.resize(std::min(found.size(), kMostFine));
    std::vector<GearCombination> first;
    for (const auto& pair : found) first.push_back({pair->numbers.teeth, pair->numbers.module});
    return first;
  }

  /// Best first, without those that are none.
  static void sort(Found& found) {
    std::erase(found, std::nullopt);
    std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return is_better(*a, *b); });
  }

  void take_best(Found& found) {
    sort(found);
    for (const auto& pair : found) {
      if (std::ssize(result_.designs) == problem_.solve.designs) return;
      GearPairDesign design = cylindrical_design(problem_, pair->numbers, "search");
      const bool feasible = all_satisfied(design.constraints);
      if (!feasible && !result_.designs.empty()) return;  // one tells what is missing
      result_.designs.push_back(std::move(design));
    }
  }

  const GearPairProblem& problem_;
  const Run& run_;
  const Deadline& deadline_;
  GearPairResult& result_;
};

/// The pair of which all is given.
std::optional<GearPairDesign> given_design(const GearPairProblem& problem) {
  if (problem.gearing == Gearing::bevel) return bevel_design(problem);
  if (problem.gearing == Gearing::worm) return worm_design(problem);
  const GearCombination combination{{*problem.teeth[0], *problem.teeth[1]}, *problem.module};
  const auto found = GearPairSearch(problem, combination).best(SearchDepth::fine);
  if (!found) return std::nullopt;
  return cylindrical_design(problem, found->numbers, "given");
}

std::vector<std::string> notes_of(const GearPairDesign& design) {
  switch (design.settled.gearing) {
    case Gearing::bevel:
      return bevel_notes(design);
    case Gearing::worm:
      return worm_notes(design);
    default:
      return gear_pair_notes(design);
  }
}

Status status_of(const GearPairResult& result, const Deadline& deadline, bool whole) {
  if (!whole && deadline.interrupted()) return Status::interrupted;
  if (!whole && deadline.expired()) return Status::time_limit;
  if (result.designs.empty()) return Status::no_solution;
  return all_satisfied(result.designs.front().constraints) ? Status::solved : Status::infeasible;
}

}  // namespace

bool is_whole(const GearPairProblem& problem) {
  if (problem.gearing == Gearing::bevel || problem.gearing == Gearing::worm) return true;
  return problem.teeth[0] && problem.teeth[1] && problem.module && problem.profile_shift[0] &&
         problem.profile_shift[1];
}

GearPairResult solve(const GearPairProblem& problem, const Run& run) {
  const Deadline deadline(run);
  GearPairResult result;
  const bool whole = is_whole(problem);
  if (whole) {
    auto design = given_design(problem);
    if (design) result.designs.push_back(*std::move(design));
    result.work.skipped = {"search"};
  } else {
    Solver(problem, run, deadline, result).solve();
  }
  result.status = status_of(result, deadline, whole);
  if (!result.designs.empty()) result.notes = notes_of(result.designs.front());
  if (result.status == Status::no_solution) {
    result.notes.emplace_back(
        "No pair of these teeth and shifts has a centre distance with the backlash asked for; "
        "greater shifts are wanted.");
  }
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
