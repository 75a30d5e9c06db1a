/// Gear pairs from problem to designs: cheap tests of every choice of teeth and module, then the
/// best shifts of each that is left.
#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

#include "analysis/numbers/parallel.hpp"
#include "problems/gear/combinations.hpp"
#include "problems/gear/notes.hpp"
#include "problems/gear/pair_design.hpp"
#include "problems/gear/pair_search.hpp"
#include "problems/gear/result.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

/// Of more combinations than these, each with two unknowns, those are searched finely that a coarse
/// search puts first; of more than those coarsely that a rough one does.
constexpr std::size_t kMostFine = 100, kMostCoarse = 2000;
/// Shares of the run, for progress, after the first of several searches and after the second.
constexpr double kSievedDone = 0.4, kCoarseDone = 0.7;

/// Searches combinations; keeps what its parts share.
class Solver {
 public:
  Solver(const GearPairProblem& problem, const Run& run, const Deadline& deadline,
         GearPairResult& result)
      : problem_(problem), run_(run), deadline_(deadline), result_(result) {}

  void solve() {
    const Sieved sieved = sieve(problem_, deadline_);
    report(sieved);
    const auto& combinations = sieved.left.empty() ? sieved.nearest : sieved.left;
    for (const GearCombination& each : combinations) found_.push_back(unsearched(each));
    if (!problem_.centre_distance && found_.size() > kMostFine) {
      const bool are_many = found_.size() > kMostCoarse;
      const std::size_t looked =
          search(are_many ? SearchDepth::rough : SearchDepth::coarse, 0, kSievedDone);
      add_quantity("combinations_searched_coarsely", double(looked));
      note_cut(sieved, looked);
      if (are_many) {
        keep_first(kMostCoarse);
        search(SearchDepth::coarse, kSievedDone, kCoarseDone);
      }
      keep_first(kMostFine);
      add_quantity("combinations_searched",
                   double(search(SearchDepth::fine, are_many ? kCoarseDone : kSievedDone)));
    } else {
      const std::size_t looked = search(SearchDepth::fine);
      add_quantity("combinations_searched", double(looked));
      note_cut(sieved, looked);
    }
    keep_first(found_.size());
    take_best();
  }

 private:
  void add_quantity(const char* name, double value) { result_.quantities.push_back({name, value}); }

  void report(const Sieved& sieved) {
    constexpr const char* kRefused[] = {"refused_by_ratio", "refused_by_hunting",
                                        "refused_by_centre_distance", "refused_by_undercut"};
    add_quantity("combinations", double(sieved.all + sieved.copies));
    if (sieved.copies > 0) {
      add_quantity("scaled_copies", double(sieved.copies));
      result_.notes.emplace_back(
          "With the centre distance free, pairs of other modules are scaled copies: the smallest "
          "module is taken.");
    }
    for (std::size_t i = 0; i < 4; ++i) add_quantity(kRefused[i], double(sieved.refused[i]));
    result_.work.candidates = sieved.tested;
  }

  /// Says so where the run ended before every combination had been looked at once.
  void note_cut(const Sieved& sieved, std::size_t looked) {
    const std::uint64_t refused = sieved.left.empty() ? sieved.tested - sieved.nearest.size()
                                                      : sieved.tested - sieved.left.size();
    if (looked + refused >= sieved.all) return;
    result_.notes.push_back(fmt::format(
        "Only {} of {} combinations had been looked at when the run ended; others may be better.",
        looked + refused, sieved.all));
  }

  /// Stands for a combination until it has been looked at.
  static PairDesign unsearched(const GearCombination& combination) {
    PairDesign none;
    none.numbers.teeth = combination.teeth;
    none.numbers.module = combination.module;
    none.violation = HUGE_VAL;
    return none;
  }

  /// Searches all of `found_` until the deadline, but at least `solve.designs`; what is not
  /// searched stays as it is. How many were.
  std::size_t search(SearchDepth depth, double from = 0, double to = 1) {
    const int least = deadline_.interrupted() ? 1 : problem_.solve.designs;
    std::atomic<std::size_t> looked = 0;
    result_.work.threads = thread_count(run_.threads);
    run_.enter(Phase::search, to);
    const Run run = part_of(run_, from, to);
    double best = HUGE_VAL;  // of those of thread 0
    const auto look = [&](int index, int thread) {
      PairDesign& found = found_[static_cast<std::size_t>(index)];
      const bool is_first = found.violation == HUGE_VAL;
      if (deadline_.reached() && !(is_first && index < least)) return;
      ++looked;
      const GearCombination combination{found.numbers.teeth, found.numbers.module};
      const auto searched = GearPairSearch(problem_, combination).best(depth);
      const bool was_better = found.merit() < 0 && searched && is_better(found, *searched);
      if (searched && !was_better) found = *searched;
      if (thread != 0 || !run.progress) return;
      if (found.violation == 0) best = std::min(best, found.objective);
      run.progress(double(index + 1) / double(found_.size()), best);
    };
    parallel_for(static_cast<int>(found_.size()), run_.threads, look);
    return looked;
  }

  /// The `count` best, without those that are none or have not been looked at.
  void keep_first(std::size_t count) {
    std::erase_if(found_, [](const PairDesign& pair) { return pair.violation == HUGE_VAL; });
    std::ranges::stable_sort(found_, is_better);
    for (auto first = found_.begin(); first != found_.end();) {
      const auto last =
          std::find_if_not(std::next(first), found_.end(),
                           [&](const PairDesign& pair) { return is_as_good(*first, pair); });
      std::ranges::stable_sort(first, last, is_smaller);
      first = last;
    }
    found_.resize(std::min(found_.size(), count));
  }

  void take_best() {
    for (const PairDesign& pair : found_) {
      if (std::ssize(result_.designs) == problem_.solve.designs) return;
      GearPairDesign design = cylindrical_design(problem_, pair.numbers, "search");
      const bool feasible = all_satisfied(design.constraints);
      if (!feasible && !result_.designs.empty()) return;  // one tells what is missing
      result_.designs.push_back(std::move(design));
    }
  }

  const GearPairProblem& problem_;
  const Run& run_;
  const Deadline& deadline_;
  GearPairResult& result_;
  std::vector<PairDesign> found_;
};

/// The pair of which all is given.
std::optional<GearPairDesign> given_design(const GearPairProblem& problem) {
  if (problem.gearing == Gearing::bevel) return bevel_design(problem);
  if (problem.gearing == Gearing::worm) return worm_design(problem);
  if (problem.gearing == Gearing::internal) {
    if (!std::isfinite(internal_pair(problem).centre_distance)) return std::nullopt;
    return internal_design(problem);
  }
  if (problem.gearing == Gearing::rack) return rack_design(problem);
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
    case Gearing::internal:
      return internal_notes(design);
    case Gearing::rack:
      return rack_notes(design);
    default:
      return gear_pair_notes(design);
  }
}

/// What the nearest pair misses of which `notes_of` says nothing.
std::vector<std::string> missed_notes(const GearPairDesign& design) {
  constexpr std::string_view kNoted[] = {"teeth.", "centre_distance", "backlash", "no_undercut",
                                         "no_interference"};
  std::vector<std::string> notes;
  for (const ConstraintCheck& check : design.constraints) {
    const auto* value = std::get_if<double>(&check.value);
    const auto* bound = std::get_if<double>(&check.bound);
    const auto is_noted = [&](std::string_view name) { return check.name.starts_with(name); };
    if (check.satisfied || !value || !bound || std::ranges::any_of(kNoted, is_noted)) continue;
    if (check.name == "target.ratio_tolerance") {
      const auto& settled = design.settled;
      notes.push_back(fmt::format(
          "The nearest ratio is {:.6g}; {:.6g} was requested, with a relative tolerance of {:g}.",
          double(*settled.teeth[1]) / *settled.teeth[0], *settled.ratio, *bound));
    } else {
      notes.push_back(fmt::format("The nearest pair misses {}: it has {:.6g}, the limit is {:.6g}.",
                                  check.name, *value, *bound));
    }
  }
  return notes;
}

/// Why there is no pair at all.
std::string no_pair_note(const GearPairProblem& problem) {
  if (problem.gearing == Gearing::internal) {
    return "No centre distance gives these teeth and shifts the backlash requested: the ring's "
           "spaces are too narrow; expected a greater shift of the ring, or less of the pinion.";
  }
  return fmt::format(
      "No pair of these teeth and shifts has a centre distance {}: the teeth are too thin to "
      "touch; "
      "expected greater shifts.",
      problem.backlash.value_or(0) > 0 ? "with the backlash requested" : "without backlash");
}

Status status_of(const GearPairResult& result, const Deadline& deadline, bool whole) {
  if (!whole && deadline.interrupted()) return Status::interrupted;
  if (!whole && deadline.expired()) return Status::time_limit;
  if (result.designs.empty()) return Status::no_solution;
  return all_satisfied(result.designs.front().constraints) ? Status::solved : Status::infeasible;
}

}  // namespace

bool is_whole(const GearPairProblem& problem) {
  if (!is_searched(problem.gearing)) return true;
  return problem.teeth[0] && problem.teeth[1] && problem.module && problem.profile_shift[0] &&
         problem.profile_shift[1];
}

GearPairResult solve(const GearPairProblem& given, const Run& run) {
  const auto valid = KindTraits<GearPairProblem>::checked(given);
  if (!valid) return refused<GearPairResult>(valid.error());
  const GearPairProblem& problem = *valid;
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
  if (!result.designs.empty()) {
    const GearPairDesign& best = result.designs.front();
    if (!whole) append(result.notes, missed_notes(best));
    append(result.notes, notes_of(best));
  }
  if (result.status == Status::no_solution) result.notes.push_back(no_pair_note(problem));
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
