#include "problems/path/exact/solve.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <random>

#include "analysis/numbers/parallel.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/exact/designs.hpp"
#include "synthesis/exact/nine_point/constrained_path.hpp"

namespace cognate::problems {
namespace {

using synthesis::ExactPathSolutions;
using synthesis::ExactPathStatus;
using synthesis::RootSymmetry;

/// The equations that determine a four-bar.
constexpr int kEquations = 8;
/// How many members of a family are solved where the file does not say: those without given pivots
/// take tenths of a second each, the others hundredths.
constexpr int kLongTries = 12, kShortTries = 60;

/// A system solved, with its side conditions.
struct Solved {
  ExactPathSolutions solutions;
  std::vector<synthesis::SideCondition> conditions;
  RootSymmetry symmetry = RootSymmetry::none;
  std::string origin;
  bool settled = true;  ///< nothing suggests that there are more than were looked for
};

class Solver {
 public:
  Solver(const PathProblem& problem, const Run& run)
      : problem_(problem), run_(run), deadline_(run) {}

  Result take() {
    const int free = kEquations - equation_count(problem_);
    note_equal_angles(problem_.pose_angles, result_);
    if (note_points_on_a_circle(problem_.points, result_)) {
      result_.work.skipped.push_back("solutions");
    } else if (free == 0) {
      run_.enter(Phase::exact, kUnknownEnd);
      solve_all();
    } else {
      run_.enter(Phase::exact);
      sample_family(free);
    }
    finish();
    return std::move(result_);
  }

 private:
  Solved solved(const std::vector<synthesis::PathPose>& positions,
                const synthesis::FixedParts& parts, double from, double to) {
    const auto progress = [this, from, to](double share) {
      if (run_.progress) run_.progress(from + share * (to - from), best_);
    };
    const auto stop = [this] { return deadline_.reached(); };
    if (condition_count(parts) > 0) {
      auto found = solve_constrained_path(
          positions, parts,
          {.threads = run_.threads, .stop = stop, .progress = progress, .cache = run_.cache});
      return {std::move(found.solutions), std::move(found.conditions), RootSymmetry::none,
              "exact:path-given-parts", found.settled};
    }
    synthesis::ExactPathOptions options;
    options.threads = run_.threads;
    options.cache = run_.cache;
    options.stop = stop;
    options.progress = progress;
    Solved all{
        solve_exact_path(positions, options), {}, RootSymmetry::cognates, "exact:nine-point"};
    if (all.solutions.system.kind.poses > 1) {
      all.symmetry = RootSymmetry::swapped_dyads;
      all.origin = "exact:alt-burmester";
    }
    return all;
  }

  /// Proves roots, all or the real ones alone, as long as there is time.
  ExactRoots proved(Solved& solved, bool all) {
    ExactRoots roots{
        solved.solutions.system, solved.solutions.roots, {}, solved.symmetry, solved.origin};
    const int count = int(roots.roots.size());
    roots.certificates.resize(roots.roots.size());
    parallel_for(count, run_.threads, [&](int i, int) {
      const auto at = std::size_t(i);
      if (!(all || roots.roots[at].real)) return;
      if (deadline_.reached()) {
        unfinished_ = true;
        return;
      }
      synthesis::RootCertificate& proof = roots.certificates[at];
      proof = certify(roots.system, roots.roots[at], solved.conditions);
      // A proof knows better than the digits of an ill-conditioned root.
      if (proof.certified) proof.refined.real = roots.roots[at].real = proof.real;
    });
    return roots;
  }

  void add(const ExactRoots& roots) {
    const int first = designs_.empty() ? 0 : designs_.back().curve + 1;
    for (TracedDesign& design : designs_of(roots, problem_, first)) {
      result_.work.positions += problem_.points.size();
      best_ = std::min(best_, design.design.error.rms);
      designs_.push_back(std::move(design));
    }
  }

  void solve_all() {
    const auto positions = positions_of(problem_);
    Solved all = solved(positions, given_parts(problem_.given), 0, 0.9);
    const ExactPathSolutions& found = all.solutions;
    const bool stopped = found.status == ExactPathStatus::interrupted;
    if (stopped) unfinished_ = true;
    if (found.status != ExactPathStatus::solved && !(stopped && found.tracked > 0)) {
      note_status(found, result_);
      return;
    }
    const ExactRoots roots = proved(all, true);
    add(roots);
    result_.work.candidates = std::uint64_t(found.tracked);
    note_counts(found, roots, {all.symmetry != RootSymmetry::none, all.settled}, result_);
    if (unfinished_) {
      result_.notes.push_back("The run was ended before all of it was done: there may be more.");
    } else {
      note_exact_designs(designs_, result_);
    }
  }

  void sample_family(int free) {
    std::mt19937_64 random(run_.seed);
    const bool is_long = free < 4 && condition_count(given_parts(problem_.given)) == 0;
    const int tries = problem_.solve.starts.value_or(is_long ? kLongTries : kShortTries);
    int members = 0;
    std::optional<ExactPathSolutions> failed;
    for (int i = 0; i < tries && !unfinished_; ++i) {
      const FamilyMember member = random_member(problem_, free, random);
      Solved one = solved(member.positions, member.parts, double(i) / tries, double(i + 1) / tries);
      result_.work.candidates += std::uint64_t(one.solutions.tracked);
      if (one.solutions.status == ExactPathStatus::interrupted) unfinished_ = true;
      members += one.solutions.status == ExactPathStatus::solved;
      add(proved(one, false));
      if (one.solutions.status != ExactPathStatus::solved) failed = std::move(one.solutions);
      if (deadline_.reached() && i + 1 < tries) unfinished_ = true;
    }
    result_.quantities.push_back({"free_parameters", double(free)});
    result_.quantities.push_back({"family_members_solved", double(members)});
    if (members == 0 && failed) note_status(*failed, result_);
    result_.notes.push_back(fmt::format(
        "{} positions leave {} of a four-bar's dimensions free: a family of solutions passes "
        "through them, of which {} members were solved, the rest of their conditions (pivots and "
        "further points) drawn from seed {}. {}",
        problem_.points.size(), free, members, run_.seed,
        members > 0 ? "The best are given; more of solve.starts tries more."
                    : "None was solved, so that nothing is known of the family."));
    if (!unfinished_ && members > 0) note_exact_designs(designs_, result_);
  }

  void finish() {
    const bool sound = std::ranges::any_of(designs_, [](const TracedDesign& traced) {
      return all_satisfied(traced.design.constraints);
    });
    const bool none = designs_.empty();
    result_.designs = ranked(std::move(designs_), problem_.solve.designs);
    result_.status = none ? Status::no_solution : sound ? Status::solved : Status::infeasible;
    if (unfinished_) {
      result_.status = deadline_.interrupted() ? Status::interrupted : Status::time_limit;
    }
    for (const char* what : {"velocities", "accelerations", "forces"}) {
      result_.work.skipped.push_back(what);
    }
    result_.work.threads = thread_count(run_.threads);
    result_.work.seconds = deadline_.spent();
  }

  const PathProblem& problem_;
  const Run& run_;
  Deadline deadline_;
  std::atomic<bool> unfinished_{false};  ///< something was left undone for lack of time
  Result result_;
  std::vector<TracedDesign> designs_;
  double best_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Result solve_exactly(const PathProblem& problem, const Run& run) {
  return Solver(problem, run).take();
}

}  // namespace cognate::problems
