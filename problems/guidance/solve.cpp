#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/guidance/design.hpp"
#include "problems/guidance/dyad_choices.hpp"
#include "problems/guidance/least_squares.hpp"
#include "problems/guidance/loci.hpp"
#include "problems/guidance/search.hpp"
#include "problems/linkage/deadline.hpp"
#include "problems/linkage/oddities.hpp"
#include "problems/linkage/refused.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

using synthesis::Pose;

/// Poses closer than this, relative to the extent and in radians, are one.
constexpr double kOnePose = 1e-12;

/// Where every solution is in a list, so many are returned unless the file says otherwise.
constexpr int kAll = 100;

bool is_same(const Pose& a, const Pose& b, double extent) {
  const double turn = std::remainder(a.angle - b.angle, kTurn);
  return std::abs(turn) <= kOnePose && norm(a.at - b.at) <= kOnePose * extent;
}

/// The problem without poses that repeat an earlier one, which say nothing new.
MotionProblem without_repeats(const MotionProblem& problem, std::vector<std::string>& notes) {
  MotionProblem reduced = problem;
  reduced.poses.clear();
  const double extent = synthesis::extent(problem.poses);
  for (std::size_t i = 0; i < problem.poses.size(); ++i) {
    const auto same = std::ranges::find_if(
        problem.poses, [&](const Pose& pose) { return is_same(pose, problem.poses[i], extent); });
    const auto earlier = static_cast<std::size_t>(same - problem.poses.begin());
    if (earlier >= i) {
      reduced.poses.push_back(problem.poses[i]);
      continue;
    }
    notes.push_back(
        fmt::format("Pose {} is pose {} again (coincident poses): it adds no condition, "
                    "and the body is guided through the others.",
                    i + 1, earlier + 1));
  }
  return reduced;
}

std::string origin(std::size_t poses) {
  switch (poses) {
    case 2:
      return "exact:two-poses";
    case 3:
      return "exact:three-poses";
    case 4:
      return "exact:burmester-4";
    default:
      return "exact:burmester-5";
  }
}

DyadPairChoices dyads_of(const MotionProblem& problem) {
  switch (problem.poses.size()) {
    case 4:
      return {dyad_of_four_poses(problem), std::nullopt};
    case 5:
      return {dyad_of_five_poses(problem), std::nullopt};
    default:
      return dyads_of_few_poses(problem);
  }
}

void add_note(std::string note, Result& result) {
  if (std::ranges::count(result.notes, note) == 0) result.notes.push_back(std::move(note));
}

/// Why pairs of listed dyads make no mechanism.
void note_faults(const MotionProblem& problem, const DyadPairChoices& options, Result& result) {
  if (options.first.is_family() || (options.second && options.second->is_family())) return;
  const DyadChoices& second = options.second ? *options.second : options.first;
  for (std::size_t i = 0; i < options.first.choices.size(); ++i) {
    for (std::size_t j = options.second ? 0 : i + 1; j < second.choices.size(); ++j) {
      const auto fault = synthesis::guided_mechanism(options.first.choices[i].dyad,
                                                     second.choices[j].dyad, problem.poses)
                             .fault;
      if (fault == synthesis::PairingFault::none) continue;
      add_note(fmt::format("A pair of dyads makes no mechanism: {}.", sentence(fault)), result);
    }
  }
}

void note_count(const MotionProblem& problem, const DyadPairChoices& options, Result& result) {
  const std::size_t count = options.first.choices.size();
  if (problem.poses.size() == 5 && !options.first.is_family()) {
    result.quantities.push_back({"dyads", static_cast<double>(count)});
    if (count < 2 && !options.first.is_degenerate) {
      add_note(fmt::format("{} guides the body through the five poses, and a mechanism needs two; "
                           "move or drop a pose.",
                           count == 0 ? "No real dyad" : "One real dyad only"),
               result);
    }
  } else if (result.designs.empty() && result.notes.empty()) {
    add_note("No two dyads guide the body through the poses.", result);
  }
}

Status status_of(const Result& result, const Deadline& deadline) {
  if (deadline.interrupted()) return Status::interrupted;
  if (deadline.expired()) return Status::time_limit;
  if (result.designs.empty()) return Status::no_solution;
  const bool solved = std::ranges::any_of(
      result.designs, [](const Design& design) { return all_satisfied(design.constraints); });
  return solved ? Status::solved : Status::infeasible;
}

void find_designs(const MotionProblem& problem, const Deadline& deadline, Result& result) {
  const DyadPairChoices options = dyads_of(problem);
  for (const std::string& note : options.first.notes) add_note(note, result);
  if (options.second) {
    for (const std::string& note : options.second->notes) add_note(note, result);
  }
  const bool is_family =
      options.first.is_family() || (options.second && options.second->is_family());
  const bool all = !is_family && !problem.designs_given;
  const int count = all ? kAll : problem.solve.designs;
  const RankedPairs ranked = ranked_pairs(problem, options, count, deadline);
  for (const RankedPair& pair : ranked.pairs) {
    if (std::ssize(result.designs) == count) break;
    auto design = motion_design(problem, pair.pair, origin(problem.poses.size()));
    if (design) {
      result.designs.push_back(std::move(*design));
    } else {
      add_note(
          "A pair of dyads is left out whose mechanism rounding keeps from the poses: its slides "
          "are nearly parallel, or its links far longer than the way of the body.",
          result);
    }
  }
  result.work.candidates = ranked.judged;
  result.work.positions = problem.poses.size() * result.designs.size();
  note_faults(problem, options, result);
  note_count(problem, options, result);
}

Result solve_exactly(const MotionProblem& problem, const Run& run) {
  const Deadline deadline(run);
  Result result;
  const MotionProblem reduced = without_repeats(problem, result.notes);
  if (reduced.poses.size() < 2) {
    result.notes.push_back(
        "There is one pose only, and nothing to guide the body through; at least "
        "two different poses are needed.");
  } else {
    find_designs(reduced, deadline, result);
    add_motion_loci(reduced, result);
  }
  result.status = status_of(result, deadline);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace

Result solve(const MotionProblem& given, const Run& run) {
  const auto valid = KindTraits<MotionProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const MotionProblem& problem = *valid;
  const bool exact = problem.method != MotionMethod::least_squares;
  Result result = exact ? solve_exactly(problem, run) : solve_by_least_squares(problem, run);
  std::vector<Vec2d> origins;
  for (const Pose& pose : problem.poses) origins.push_back(pose.at);
  note_oddities(extent_of(origins), result);
  return result;
}

}  // namespace cognate::problems
