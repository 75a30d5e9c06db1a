#include "problems/guidance/designs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/guidance/dyads.hpp"
#include "problems/guidance/fit.hpp"
#include "problems/guidance/scale.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/search/solver_origin.hpp"

namespace cognate::problems {
namespace {

using synthesis::DyadKind;
using synthesis::GuidingDyad;
using synthesis::Pose;

/// Starts with limits over the turn, of whose minima half as many were seen to miss the best.
constexpr int kLimitedStarts = 1600;
/// Designs closer than this, relative to their size, are one: no use is made of a thousandth.
constexpr double kSameWithin = 1e-3;

bool is_same(const GuidingDyad& a, const GuidingDyad& b, double size) {
  if (a.kind != b.kind) return false;
  const double turned = a.kind == DyadKind::rr ? 0 : std::abs(cross(a.direction, b.direction));
  const double apart = std::max(
      {norm(a.in_body - b.in_body), norm(a.fixed - b.fixed), std::abs(a.length - b.length)});
  return turned <= kSameWithin && apart <= kSameWithin * (size + std::max(a.length, b.length));
}

/// Whichever dyad drives.
bool is_same(const DyadPair& a, const DyadPair& b, double size) {
  return (is_same(a.first, b.first, size) && is_same(a.second, b.second, size)) ||
         (is_same(a.first, b.second, size) && is_same(a.second, b.first, size));
}

bool is_better(const RatedMotion& a, const RatedMotion& b) {
  if (a.violation != b.violation) return a.violation < b.violation;
  return a.design.metrics.transmission_acute_min > b.design.metrics.transmission_acute_min;
}

}  // namespace

void MotionDesigns::add(HeldBody body, const std::string& origin, bool first_is_driven) {
  const HeldBody turned_body{{body.pair.second, body.pair.first}, body.reached};
  auto best = candidate(std::move(body), origin);
  // The rocker may drive as well, if that mends what is wrong with the crank's driving.
  if (turned_body.pair.first.kind == DyadKind::rr && roles_are_alike(problem_) &&
      (!best || best->violation > 0 || !problem_.constraints.required_class)) {
    auto turned = candidate(turned_body, origin);
    if (turned && (!best || is_better(*turned, *best))) best = std::move(turned);
  }
  if (!best) return;
  best->first_is_driven = first_is_driven;
  auto& list = best->violation > 0 ? violating_ : feasible_;
  const bool known = std::ranges::any_of(list, [&](const RatedMotion& other) {
    return is_same(other.body.pair, best->body.pair, size_);
  });
  if (!known) list.push_back(std::move(*best));
}

std::optional<RatedMotion> MotionDesigns::candidate(HeldBody body,
                                                    const std::string& origin) const {
  auto design = verified_design(problem_, body, origin);
  if (!design) return std::nullopt;
  const double amount = violation(design->constraints);
  return RatedMotion{std::move(body), *std::move(design), amount};
}

std::vector<RatedMotion>& MotionDesigns::ranked() {
  auto& all = feasible_.empty() ? violating_ : feasible_;
  // Several searches may have added to them.
  std::ranges::stable_sort(all, {}, [](const RatedMotion& c) {
    return std::pair(c.violation, c.design.error.sum_of_squares);
  });
  const auto exact = std::stable_partition(all.begin(), all.end(), [&](const RatedMotion& c) {
    return c.design.error.sum_of_squares <= kMetExactly * size_ * size_;
  });
  std::stable_sort(all.begin(), exact, [](const RatedMotion& a, const RatedMotion& b) {
    return a.design.metrics.transmission_acute_min > b.design.metrics.transmission_acute_min;
  });
  return all;
}

std::vector<Design> MotionDesigns::take() {
  std::vector<Design> designs;
  for (RatedMotion& rated : ranked()) {
    if (std::ssize(designs) == problem_.solve.designs) break;
    designs.push_back(std::move(rated.design));
  }
  return designs;
}

double error_of(const MotionProblem& /*problem*/, const Design& design) {
  return design.error.rms;
}

std::optional<Design> verified_design(const MotionProblem& problem, const HeldBody& body,
                                      const std::string& origin) {
  auto design = nearest_design(problem, body.pair, body.reached, origin);
  if (!design || !std::isfinite(design->error.sum_of_squares)) return std::nullopt;
  check_error(problem, *design);
  return design;
}

std::vector<MotionProblem> drives_of(const MotionProblem& problem) {
  std::vector<MotionProblem> drives{problem};
  MotionProblem without = problem;
  without.fixed_pivots.clear();
  without.moving_pivots.clear();
  if (roles_are_alike(problem) || !roles_are_alike(without)) return drives;
  drives.push_back(problem);
  drives.back().first_is_driven = false;
  return drives;
}

std::optional<int> starts_of(const MotionProblem& problem, std::size_t searches) {
  std::optional<int> starts = problem.solve.starts;
  if (!starts && limits_turn(problem.constraints)) starts = kLimitedStarts;
  const int share = static_cast<int>(searches);
  if (starts) starts = (*starts + share - 1) / share;
  return starts;
}

SearchStatistics add_minima(const MotionProblem& drive, std::optional<int> starts, const Run& run,
                            const Deadline& deadline, MotionDesigns& designs, Work& work) {
  const MotionScale scale(drive);
  const MotionProblem scaled = scale.into(drive);
  const synthesis::Solver solver = synthesis::chosen(drive.solve.solver);
  const double tolerance = drive.solve.tolerance.value_or(kMotionTolerance);
  std::vector<DyadPair> known;
  for (const Design& design : run.known) {
    if (const auto pair = pair_of(drive, design)) known.push_back(scale.into(*pair));
  }
  const auto found = search_motions(scaled, known, starts, solver, tolerance, run, deadline, work);
  for (const MotionMinimum& minimum : found.minima) {
    const MotionModel model(scaled, minimum.form);
    std::vector<Pose> reached = model.reached(minimum.solution.x);
    if (reached.empty()) continue;
    for (Pose& pose : reached) pose = scale.out_of(pose);
    designs.add({scale.out_of(model.pair(minimum.solution.x)), std::move(reached)},
                minimum.origin + refined_by(solver), drive.first_is_driven);
  }
  return found.statistics;
}

SearchStatistics together(const SearchStatistics& a, const SearchStatistics& b) {
  const double starts = std::max(1, a.starts + b.starts);
  return {a.starts + b.starts, std::max(a.best_hits, b.best_hits),
          (a.starts * a.unseen + b.starts * b.unseen) / starts};
}

}  // namespace cognate::problems
