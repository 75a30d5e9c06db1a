/// Straight lines by the local theory, from problem to designs.
#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/deadline.hpp"
#include "problems/linkage/oddities.hpp"
#include "problems/linkage/refused.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/straight_line/design.hpp"
#include "problems/straight_line/goal.hpp"
#include "problems/straight_line/solutions.hpp"

namespace cognate::problems {
namespace {

/// Feasible ones first, then by straight length.
void sort(std::vector<Design>& designs) {
  std::ranges::stable_sort(designs, [](const Design& a, const Design& b) {
    const bool first = all_satisfied(a.constraints), second = all_satisfied(b.constraints);
    return first != second ? first : straight_length(a) > straight_length(b);
  });
}

/// The inflection circle of the position, or what of a line is near the linkage.
Locus inflection_locus(const synthesis::FamilyMember& member) {
  const auto position = synthesis::coupler_position(member.linkage, member.crank_angle);
  if (!position) return {};
  const Vec2d a = std::visit(
      [](const auto& linkage) {
        if constexpr (requires { linkage.pivot_a; }) {
          return linkage.pivot_a;
        } else {
          return linkage.pivot;
        }
      },
      member.linkage);
  const Vec2d pin = a + position->series.pin[0];
  const CircleOrLine locus = contact_locus(position->series, 2);
  constexpr double kReach = 1e3;
  std::vector<Vec2d> points;
  if (const auto circle = as_circle(locus, kReach * position->size)) {
    constexpr int kPoints = 180;
    for (int k = 0; k <= kPoints; ++k) {
      const double angle = kTurn * k / kPoints;
      points.push_back(pin + circle->centre + circle->radius * unit_vector(angle));
    }
    return {"inflection circle", {std::move(points)}};
  }
  // Of a circle that large, what is near the linkage is straight.
  const auto line = as_line(locus, 1e-12 * position->size);
  if (!line) return {};
  const double reach = 3 * position->size;
  return {"inflection line",
          {{pin + line->through - reach * line->direction,
            pin + line->through + reach * line->direction}}};
}

Status status_of(const Result& result, const Deadline& deadline, bool ended_early) {
  if (ended_early) return deadline.interrupted() ? Status::interrupted : Status::time_limit;
  if (result.designs.empty()) return Status::no_solution;
  return all_satisfied(result.designs.front().constraints) ? Status::solved : Status::infeasible;
}

}  // namespace

Result solve(const StraightLineProblem& given, const Run& run) {
  const auto valid = KindTraits<StraightLineProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const StraightLineProblem& problem = *valid;
  if (problem.goal) return search_straight_lines(problem, run);
  const Deadline deadline(run);
  Result result;
  StraightLineSolutions found = find_solutions(problem);
  result.notes = std::move(found.notes);
  bool ended_early = false;
  for (const auto& solution : found.all) {
    ended_early = deadline.reached();
    if (ended_early) break;
    result.designs.push_back(straight_line_design(problem, solution));
  }
  sort(result.designs);
  result.quantities.push_back({"solutions", double(found.all.size())});
  const auto wanted = static_cast<std::size_t>(problem.solve.designs);
  if (result.designs.size() > wanted) result.designs.resize(wanted);
  note_oddities(std::nullopt, result);
  if (found.position) {
    Locus locus = inflection_locus(*found.position);
    if (!locus.branches.empty()) result.loci.push_back(std::move(locus));
  }
  result.status = status_of(result, deadline, ended_early);
  result.work.candidates = found.all.size();
  result.work.skipped = {"search", "gradients", "forces"};
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
