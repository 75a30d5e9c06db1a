/// Straight lines by the local theory, from problem to designs.

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/coupler_curve/straightness.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/evaluation/mechanism_metrics.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/twins.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/straight_line/problem.hpp"
#include "problems/straight_line/solutions.hpp"
#include "synthesis/exact/straight_line/contact_search.hpp"

namespace cognate::problems {
namespace {

double straight_length(const Design& design);

using synthesis::CouplerLinkage;
using synthesis::StraightLineSolution;

constexpr int kCoupler = 2;
constexpr QuantityKey<double> kStraightLengthKey{"straight_length_at_0_001"};

struct Level {
  double relative;
  const char* suffix;
};
constexpr std::array<Level, 2> kLevels{{{1e-3, "at_0_001"}, {1e-2, "at_0_01"}}};

NamedMechanism mechanism_of(const StraightLineSolution& solution) {
  if (const auto* four_bar = std::get_if<FourBar>(&solution.linkage)) {
    FourBar linkage = *four_bar;
    linkage.coupler_point = solution.point.coupler_point;
    return named(linkage);
  }
  NamedMechanism mechanism = named(std::get<SliderCrank>(solution.linkage));
  add_point(mechanism, "P", "coupler", solution.point.coupler_point);
  return mechanism;
}

double longest_link(const CouplerLinkage& linkage) {
  if (const auto* slider = std::get_if<SliderCrank>(&linkage)) {
    return std::max(slider->crank, slider->coupler);
  }
  const Lengths<double> links = lengths(std::get<FourBar>(linkage));
  return std::max({links.crank, links.coupler, links.rocker, links.frame});
}

void add(Metrics& metrics, const std::string& name, double value) {
  if (std::isfinite(value)) metrics.quantities.push_back({name, value});
}

void add_segment(Metrics& metrics, const Path& path, const StraightSegment& segment,
                 const char* suffix) {
  const auto named = [suffix](const char* what) { return fmt::format("{}_{}", what, suffix); };
  add(metrics, named("straight_length"), segment.length);
  if (!(segment.length > 0)) return;
  const Vec2d& along = segment.line.direction;
  add(metrics, named("deviation"), segment.deviation);
  add(metrics, named("direction_deg"), degrees(std::atan2(along.y, along.x)));
  add(metrics, named("crank_from_deg"), degrees(segment.from));
  add(metrics, named("crank_to_deg"), degrees(segment.to));
  const auto variation = speed_variation(path, segment);
  if (variation) add(metrics, named("speed_variation"), *variation);
}

/// The segments at each level; empty where the motion ends at the position itself.
std::vector<StraightSegment> segments(const StraightLineSolution& solution, const Path& path) {
  std::vector<StraightSegment> found;
  const auto limits = synthesis::range_about(solution.linkage, solution.crank_angle);
  if (!limits) return found;
  const auto forward = forward_interval(path, solution.crank_angle, *limits);
  if (!forward) return found;
  for (const Level& level : kLevels) {
    found.push_back(longest_segment(path, solution.crank_angle, *forward, level.relative));
  }
  return found;
}

/// Over the longer segment.
Metrics metrics_of(const NamedMechanism& mechanism, double position,
                   const std::vector<StraightSegment>& straight) {
  const std::vector<double> sides = cognate::sides(mechanism.mechanism);
  std::vector<DriveState> states{{position, sides}};
  if (!straight.empty()) {
    states.push_back({straight.back().from, sides});
    states.push_back({straight.back().to, sides});
  }
  return mechanism_metrics(mechanism, states, PointOrder::any);
}

/// The design with its constraints checked and its quantities: "contact_points" (9: straight to the
/// eighth order), "straight_length_at_0_001" and "…_0_01" (the longest segment about the position
/// with δ/L at most so much, see analysis/coupler_curve/straightness.hpp), for each its
/// "deviation_…", "crank_from_deg_…", "crank_to_deg_…", "direction_deg_…" and
/// "speed_variation_…"; "straight_length_over_longest_link". A value that does not exist is left
/// out.
Design straight_line_design(const StraightLineProblem& problem,
                            const synthesis::StraightLineSolution& solution) {
  Design design;
  design.mechanism = mechanism_of(solution);
  const Path path = path_of(design.mechanism.mechanism, {kCoupler, solution.point.coupler_point});
  const auto straight = segments(solution, path);
  design.crank_angles = {in_one_turn(solution.crank_angle)};
  design.origin = fmt::format("exact:{}", synthesis::name(solution.point.kind));
  Metrics& metrics = design.metrics;
  metrics = metrics_of(design.mechanism, solution.crank_angle, straight);
  metrics.precision_residual = solution.point.contact.residual;
  if (std::isfinite(solution.point.condition)) metrics.condition = solution.point.condition;
  metrics.quantities.push_back({"contact_points", double(solution.point.contact.points)});
  for (std::size_t i = 0; i < straight.size(); ++i) {
    add_segment(metrics, path, straight[i], kLevels[i].suffix);
  }
  add(metrics, "straight_length_over_longest_link",
      straight_length(design) / longest_link(solution.linkage));
  design.constraints = check_constraints(problem.constraints, {}, design.mechanism, metrics);
  return design;
}

/// The straight length at 0.1 %, by which designs are sorted.
double straight_length(const Design& design) {
  return find_quantity(design.metrics.quantities, kStraightLengthKey).value_or(0);
}

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

/// The distance of the coupler point from the best line of its straight segment, which stays where
/// the nominal design has it. Of exact designs the segment straight to 1 %.
std::optional<ToleranceQuestion> line_question(const Design& design) {
  constexpr int kSteps = 90;
  const auto angle = [&](const std::string& key) {
    const auto searched = find_quantity(design.metrics.quantities, AngleKey{key});
    return searched ? searched
                    : find_quantity(design.metrics.quantities, AngleKey{key + "_at_0_01"});
  };
  const auto from = angle("crank_from_deg"), to = angle("crank_to_deg"),
             direction = angle("direction_deg");
  if (!from || !to || !direction) return std::nullopt;
  std::vector<double> angles;
  for (int i = 0; i <= kSteps; ++i) angles.push_back(*from + (*to - *from) * i / kSteps);
  auto [question, kept] = question_at(design.mechanism, angles);
  const auto point = point_response(design.mechanism, "P");
  if (!point || kept.empty()) return std::nullopt;
  ToleranceQuantity error{.name = "error", .response = *point, .judged = true};
  const Vec2d normal{-std::sin(*direction), std::cos(*direction)};
  for (const Vec2d& place : path_frame(design.mechanism, question, *point).place) {
    error.normal.push_back(normal);
    error.offset.push_back(dot(place, normal));
  }
  const auto [least, greatest] = std::ranges::minmax(error.offset);
  const double middle = 0.5 * (least + greatest);
  for (double& offset : error.offset) offset -= middle;
  question.quantities.push_back(std::move(error));
  add_transmissions(design.mechanism, question);
  return std::move(question);
}

void add_line_tolerances(const StraightLineProblem& problem, const Run& run, Result& result) {
  add_tolerances(problem.tolerances, problem.length_unit, run, line_question, result);
}

/// The best of the solutions as designs.
Result designs_of_solutions(const StraightLineProblem& problem, const StraightLineSolutions& found,
                            const Deadline& deadline) {
  Result result;
  result.notes = found.notes;
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
  result.status = status_of(result, deadline, ended_early);
  return result;
}

}  // namespace

Result solve(const StraightLineProblem& given, const Run& run) {
  const auto valid = KindTraits<StraightLineProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const StraightLineProblem& problem = *valid;
  if (problem.goal) {
    Result searched = search_straight_lines(problem, run);
    add_line_tolerances(problem, run, searched);
    return searched;
  }
  const Deadline deadline(run);
  const StraightLineSolutions found = find_solutions(problem);
  Result result = solve_in_layers(problem, run, DesignSource::exact,
                                  [&](const StraightLineProblem& one, const Run& /*own*/) {
                                    return designs_of_solutions(one, found, deadline);
                                  });
  mark_twins(result.designs);
  add_warnings(std::nullopt, problem.warnings, result);
  add_line_tolerances(problem, run, result);
  if (found.position) {
    Locus locus = inflection_locus(*found.position);
    if (!locus.branches.empty()) result.loci.push_back(std::move(locus));
  }
  result.work.candidates = found.all.size();
  result.work.skipped = {"search", "gradients", "forces"};
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
