/// Quick return from problem to designs: exact synthesis, every solution checked.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "problems/basics/degrees.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/twins.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/quick_return/designs.hpp"
#include "problems/quick_return/raster.hpp"

namespace cognate::problems {
namespace {

using synthesis::LengthInterval;
using synthesis::PivotArc;

constexpr int kFamilyPoints = 121;
/// Pivots farther away than this times the rocker are not drawn.
constexpr double kFarthestDrawn = 5;

/// A design and its mirror images, which follow it.
using Images = std::vector<Design>;

/// Designs in the order of the synthesis, each mirror image in the group of what it mirrors.
template <class Found>
std::vector<Images> grouped(const QuickReturnProblem& problem, const std::vector<Found>& all) {
  std::vector<Images> groups;
  for (const Found& found : all) {
    if (!found.mirror || groups.empty()) groups.emplace_back();
    groups.back().push_back(quick_return_design(problem, found));
  }
  return groups;
}

/// The groups best first: those that satisfy every constraint, then by the transmission angle.
void put_in_order(std::vector<Images> groups, int count, Result& result) {
  const auto key = [](const Images& group) {
    const bool sound = std::ranges::any_of(
        group, [](const Design& design) { return all_satisfied(design.constraints); });
    return std::pair(!sound, -group.front().metrics.transmission_acute_min);
  };
  std::ranges::stable_sort(groups, {}, key);
  for (Images& group : groups) {
    const auto original = static_cast<int>(result.designs.size());
    for (std::size_t i = 0; i < group.size() && std::ssize(result.designs) < count; ++i) {
      if (i > 0) group[i].mirror_of = original;
      result.designs.push_back(std::move(group[i]));
    }
  }
}

LengthInterval interval(const std::optional<Range>& range) {
  return range ? LengthInterval{range->min, range->max} : LengthInterval{};
}

synthesis::RockerBounds bounds_of(const QuickReturnProblem& problem) {
  const Bounds& bounds = problem.bounds;
  const Constraints& constraints = problem.constraints;
  synthesis::RockerBounds limits;
  limits.crank = interval(bounds.crank);
  limits.coupler = interval(bounds.coupler);
  limits.frame = interval(bounds.frame);
  if (constraints.link_ratio_max) limits.link_ratio_max = *constraints.link_ratio_max;
  if (constraints.transmission_angle) {
    limits.transmission_min = constraints.transmission_angle->min;
    limits.transmission_max = constraints.transmission_angle->max;
  }
  return limits;
}

bool leaves_family(const QuickReturnProblem& problem) {
  const Given& given = problem.given;
  return !given.crank && !given.coupler && !given.frame && !problem.crank_pivot_line &&
         !problem.limit_angle;
}

synthesis::RockerSolutions rockers_with_what_is_given(const QuickReturnProblem& problem) {
  const synthesis::RockerTask task = rocker_task(problem);
  const Given& given = problem.given;
  if (given.crank) return rockers_with_crank(task, *given.crank);
  if (given.coupler) return rockers_with_coupler(task, *given.coupler);
  if (given.frame) return rockers_with_frame(task, *given.frame);
  if (problem.limit_angle) return rockers_at_limit(task, *problem.limit_angle);
  return rockers_on_line(task, *problem.crank_pivot_line);
}

/// Where what is given leaves a curve of solutions, the best of them.
synthesis::RockerSolutions rockers(const QuickReturnProblem& problem) {
  if (!problem.swing) {
    return rockers_with_frame_at_limit(
        {problem.time_ratio, *problem.given.rocker, *problem.given.frame}, *problem.limit_angle);
  }
  const synthesis::RockerTask task = rocker_task(problem);
  synthesis::RockerBounds bounds = bounds_of(problem);
  if (leaves_family(problem)) return best_rockers(task, bounds);
  auto found = rockers_with_what_is_given(problem);
  if (found.degeneracy == synthesis::RockerDegeneracy::none) return found;
  if (found.degeneracy == synthesis::RockerDegeneracy::one_frame) {
    bounds.frame = {*problem.given.frame, *problem.given.frame};
  }
  const auto best = best_rockers(task, bounds);
  found.designs.insert(found.designs.begin(), best.designs.begin(), best.designs.end());
  return found;
}

/// The columns of a family and the two branches of its crank pivots.
void add_family(const QuickReturnProblem& problem, PivotArc arc, Result& result) {
  const std::string arc_name = arc == PivotArc::near ? "near arc" : "far arc";
  Family family{"crank-rockers, " + arc_name,
                {{"coupler", {}},
                 {"crank", {}},
                 {"frame", {}},
                 {"crank_pivot_x", {}},
                 {"crank_pivot_y", {}},
                 {"transmission_angle_min_deg", {}}}};
  Locus locus{"crank pivots, " + arc_name, {{}, {}}};
  for (const auto& point :
       rocker_family(rocker_task(problem), arc, bounds_of(problem), kFamilyPoints)) {
    const Vec2d& a = point.pivot_a;
    const double values[] = {
        point.links.coupler,        point.links.crank, point.links.frame, a.x, a.y,
        degrees(point.transmission)};
    for (std::size_t i = 0; i < family.columns.size(); ++i) {
      family.columns[i].values.push_back(values[i]);
    }
    if (norm(a) > kFarthestDrawn * *problem.given.rocker) continue;
    locus.branches[0].push_back(a);
    locus.branches[1].push_back({-a.x, a.y});
  }
  if (family.columns[0].values.empty()) return;
  result.families.push_back(std::move(family));
  if (!locus.branches[0].empty()) result.loci.push_back(std::move(locus));
}

void solve_four_bar(const QuickReturnProblem& problem, Result& result) {
  const auto found = rockers(problem);
  result.notes = rocker_notes(problem, found);
  put_in_order(grouped(problem, found.designs), problem.solve.designs, result);
  if (found.circuit_defects > 0) {
    result.quantities.push_back({"circuit_defects", double(found.circuit_defects)});
  }
  if (!leaves_family(problem)) return;
  add_family(problem, PivotArc::near, result);
  if (problem.time_ratio > 1) add_family(problem, PivotArc::far, result);
}

/// A coupler as long as a crank `half` of the stroke ought to have where nothing else decides:
/// four times, or as the pressure angle asks.
double free_coupler(const QuickReturnProblem& problem, double half) {
  constexpr double kUsual = 4;
  const auto& most = problem.pressure_angle_max;
  return half * (most ? std::max(kUsual, 1 / std::sin(*most)) : kUsual);
}

void solve_slider_crank(const QuickReturnProblem& problem, Result& result) {
  const synthesis::SliderTask task{problem.time_ratio, *problem.stroke};
  auto found = problem.offset          ? sliders_with_offset(task, *problem.offset)
               : problem.given.crank   ? sliders_with_crank(task, *problem.given.crank)
               : problem.given.coupler ? sliders_with_coupler(task, *problem.given.coupler)
                                       : best_sliders(task);
  if (found.degeneracy == synthesis::SliderDegeneracy::any_coupler) {
    found.designs = sliders_with_coupler(task, free_coupler(problem, 0.5 * task.stroke)).designs;
  }
  result.notes = slider_notes(problem, found);
  put_in_order(grouped(problem, found.designs), problem.solve.designs, result);
}

void solve_guide_bar(const QuickReturnProblem& problem, Result& result) {
  const double offset = problem.offset.value_or(0);
  const auto found =
      problem.given.frame
          ? synthesis::guides_with_frame(problem.time_ratio, *problem.given.frame, offset)
          : synthesis::guides_with_crank(problem.time_ratio, *problem.given.crank, offset);
  if (found.empty()) result.notes.push_back(guide_note(problem));
  put_in_order(grouped(problem, found), problem.solve.designs, result);
}

void solve_shaper(const QuickReturnProblem& problem, Result& result) {
  const auto found = synthesis::shaper({problem.time_ratio, *problem.stroke, problem.given.frame,
                                        problem.given.crank, problem.rod,
                                        problem.pressure_angle_max, problem.ram_height});
  std::optional<synthesis::RamMotion> motion;
  if (found.outcome == synthesis::ShaperOutcome::solved) motion = simulate(found.shaper);
  if (!motion) {
    result.notes.push_back(shaper_note(found.outcome));
    return;
  }
  result.designs.push_back(quick_return_design(problem, found.shaper, *motion));
}

void solve_exactly(const QuickReturnProblem& problem, Result& result) {
  switch (problem.type) {
    case QuickReturnType::four_bar:
      return solve_four_bar(problem, result);
    case QuickReturnType::slider_crank:
      return solve_slider_crank(problem, result);
    case QuickReturnType::guide_bar:
      return solve_guide_bar(problem, result);
    case QuickReturnType::shaper:
      return solve_shaper(problem, result);
  }
}

/// The best on the raster, beside the exact design that comes next to it.
void solve_on_raster(const QuickReturnProblem& problem, const Run& run, const Deadline& deadline,
                     Result& result) {
  run.enter(Phase::raster);
  const ReturnRasterAnswer answer = search_return_raster(problem, run, deadline);
  Result exact;
  if (!answer.designs.empty()) solve_exactly(exact_problem(problem, answer.best), exact);
  tell_return_raster(problem, answer, exact.designs, result);
  result.work.candidates = answer.search.evaluated;
  if (deadline.interrupted()) result.status = Status::interrupted;
  if (deadline.expired()) result.status = Status::time_limit;
}

Result find_returns(const QuickReturnProblem& problem, const Run& run, const Deadline& deadline) {
  Result result;
  if (problem.raster) {
    solve_on_raster(problem, run, deadline, result);
  } else {
    solve_exactly(problem, result);
  }
  const bool sound = std::ranges::any_of(
      result.designs, [](const Design& design) { return all_satisfied(design.constraints); });
  if (!result.designs.empty()) result.status = sound ? Status::solved : Status::infeasible;
  if (result.status == Status::infeasible && !result.families.empty()) {
    result.notes.emplace_back(
        "No linkage of the family meets every constraint; the designs are the nearest.");
  }
  return result;
}

}  // namespace

Result solve(const QuickReturnProblem& given, const Run& run) {
  const auto valid = KindTraits<QuickReturnProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const QuickReturnProblem& problem = *valid;
  const Deadline deadline(run);
  Result result = solve_in_layers(problem, run, DesignSource::exact,
                                  [&](const QuickReturnProblem& one, const Run& own) {
                                    return find_returns(one, own, deadline);
                                  });
  mark_twins(result.designs);
  add_warnings(std::nullopt, problem.warnings, result);
  add_tolerances(
      problem.tolerances, problem.length_unit, run,
      [](const Design& design) {
        return output_over_motion(design.mechanism, design.crank_angles);
      },
      result);
  result.work.skipped = {"search", "gradients", "velocities", "accelerations", "forces"};
  result.work.threads = 1;
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
