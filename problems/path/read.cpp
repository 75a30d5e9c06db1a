#include "problems/raster/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

#include "problems/basics/names.hpp"
#include "problems/layers/link_names.hpp"
#include "problems/linkage/cycle/read_cycle.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/read_linkage.hpp"
#include "problems/linkage/read_raster.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/path/crank_sense.hpp"
#include "problems/path/problem.hpp"
#include "problems/path/read_curve.hpp"
#include "problems/path/read_exact.hpp"
#include "problems/search/read_objectives.hpp"
#include "problems/tolerance/read.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {
namespace {

void read_points(TableReader& target, PathProblem& problem) {
  constexpr std::string_view kKey = "points";
  if (!target.has(kKey)) {
    target.fault(
        kKey,
        "is missing; expected an array of 3 to 10000 points [x, y], or a closed curve as curve, "
        "svg_path or svg");
    return;
  }
  const auto points = target.each_two(kKey, kNumber, "[x, y]", {.min = 3, .of = "points"});
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!points[i] || points[i - 1] != points[i]) continue;
    target.faults().add(target.where(kKey, i),
                        fmt::format("point {} of target.points repeats point {}; neighbouring "
                                    "points must differ (only the last may repeat the first)",
                                    i + 1, i));
  }
  for (const Two& point : all_or_none(points).value_or(std::vector<Two>{})) {
    problem.points.push_back({point[0], point[1]});
  }
}

// Equal neighbours would ask one position of the crank for two points.
void check_crank_angles(TableReader& target, const std::vector<std::optional<double>>& degrees,
                        const PathProblem& problem) {
  std::optional<std::size_t> before;
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    if (problem.timing == Timing::mixed && !problem.has_crank_angle[i]) continue;
    const auto last = std::exchange(before, i);
    if (!last || !degrees[i] || !degrees[*last]) continue;
    // A last point that repeats the first may come a whole turn later.
    const bool neighbours = *last + 1 == i, round = *last == 0 && i + 1 == degrees.size();
    if (round && !neighbours && degrees[i] != degrees[*last]) continue;
    if (std::abs(std::remainder(*degrees[i] - *degrees[*last], 360.0)) > 1e-9) continue;
    target.faults().add(target.where("crank_deg", i),
                        fmt::format("entry {} of target.crank_deg, {}, is the same position of the "
                                    "crank as entry {}; neighbouring angles must differ by more "
                                    "than whole turns",
                                    i + 1, *degrees[i], *last + 1));
  }
}

// What is free between lies on the way from one timed point to the next.
void check_one_sense(TableReader& target, const PathProblem& problem) {
  const PossibleSenses senses = senses_between(problem);
  if (senses.forward || senses.backward) return;
  target.fault("crank_deg",
               "gives angles that the crank does not pass one after the other within one turn; "
               "with timing = \"mixed\" they must follow one another in one sense");
}

// Angles that are no increments have a sense of their own.
void check_sense(TableReader& target, const PathProblem& problem) {
  if (problem.crank_reference == CrankReference::first) return;
  const PossibleSenses senses = senses_between(problem);
  const bool possible = problem.crank_sense == CrankSense::either ||
                        (problem.crank_sense == CrankSense::ccw && senses.forward) ||
                        (problem.crank_sense == CrankSense::cw && senses.backward);
  if (possible) return;
  target.fault(
      "crank_sense",
      "is not the sense in which the crank passes the angles of crank_deg within one turn; "
      "expected the other, or none");
}

std::vector<std::optional<double>> read_degrees(TableReader& target, PathProblem& problem) {
  constexpr std::string_view kKey = "crank_deg";
  const Count count{.min = 1, .of = "angles"};
  if (problem.timing == Timing::prescribed) return target.each_number(kKey, kAngle, count);
  auto degrees = target.each_number_or(kKey, kFreeAngle, kAngle, count, problem.has_crank_angle);
  const auto timed = std::ranges::count(problem.has_crank_angle, true);
  if (!degrees.empty() && timed == 0) {
    target.fault(kKey, "holds no angle; expected at least one, or timing = \"free\"");
  }
  return degrees;
}

void read_crank_angles(TableReader& target, PathProblem& problem) {
  constexpr std::string_view kKey = "crank_deg";
  if (!target.has(kKey)) {
    target.fault("timing", fmt::format("is \"{}\" without crank_deg; give one angle for each point "
                                       "in target.crank_deg, or timing = \"free\"",
                                       to_string(problem.timing)));
    return;
  }
  const auto degrees = read_degrees(target, problem);
  if (degrees.empty()) return;
  if (!problem.points.empty() && degrees.size() != problem.points.size()) {
    target.fault(kKey, fmt::format("has {} angles for {} points; expected one for each point",
                                   degrees.size(), problem.points.size()));
  }
  check_crank_angles(target, degrees, problem);
  for (const double angle : all_or_none(degrees).value_or(std::vector<double>{})) {
    problem.crank_angles.push_back(radians(angle));
  }
  if (problem.crank_angles.size() != problem.points.size()) return;
  const std::size_t before = target.faults().size();
  if (problem.timing == Timing::mixed) check_one_sense(target, problem);
  if (target.faults().size() == before) check_sense(target, problem);
}

void read_timing(TableReader& target, PathProblem& problem) {
  problem.timing = target.choice<Timing>("timing").value_or(Timing::free);
  problem.crank_reference =
      target.choice<CrankReference>("crank_reference").value_or(problem.crank_reference);
  problem.crank_sense = target.choice<CrankSense>("crank_sense").value_or(problem.crank_sense);
  problem.order = target.choice<PointOrder>("order").value_or(problem.order);
  target.know({"crank_deg"});
  if (problem.timing != Timing::free) {
    read_crank_angles(target, problem);
    if (problem.order == PointOrder::any) {
      target.fault("order", fmt::format("is \"any\" with {} timing, whose crank angles are the "
                                        "order; remove it, or use timing = \"free\"",
                                        to_string(problem.timing)));
    }
    return;
  }
  for (const std::string_view key : {"crank_deg", "crank_reference"}) {
    if (!target.has(key)) continue;
    target.fault(
        key, "is given with free timing; add timing = \"prescribed\" or \"mixed\", or remove it");
  }
}

void read_weights(TableReader& target, PathProblem& problem) {
  constexpr std::string_view kKey = "weights";
  problem.weights.assign(problem.points.size(), 1.0);
  const auto weights = target.numbers(kKey, kWeight, {.min = 1, .of = "weights"});
  if (!weights) return;
  if (!problem.points.empty() && weights->size() != problem.points.size()) {
    target.fault(kKey, fmt::format("has {} weights for {} points; expected one for each point",
                                   weights->size(), problem.points.size()));
  }
  if (std::ranges::all_of(*weights, [](double weight) { return weight == 0; })) {
    target.fault(kKey, "are all 0; expected at least one positive weight");
  }
  problem.weights = *weights;
}

// The order in which poses and points alternate is not known.
void read_positions(TableReader& target, PathProblem& problem) {
  constexpr std::string_view kPoses = "poses";
  if (problem.method == PathMethod::exact) {
    read_exact_positions(target, problem);
    const bool mixed =
        !problem.pose_angles.empty() && problem.points.size() > problem.pose_angles.size();
    if (mixed) problem.order = PointOrder::any;
    return;
  }
  read_points(target, problem);
  if (target.has(kPoses)) {
    target.fault(kPoses, "are given without method = \"exact\"; add it, or give points alone");
  }
}

/// Dimensions that the file leaves open, and a crank angle for each point that is not timed.
int unknown_count(const PathProblem& problem) {
  const Given& given = problem.given;
  const bool both_pivots = given.pivot_a && given.pivot_d;
  const int lengths = !given.crank + !given.coupler + !given.rocker + !(given.frame || both_pivots);
  const int places = (given.coupler_point ? 0 : 2) + (given.pivot_a || given.pivot_d ? 0 : 2) +
                     !(given.frame_angle || both_pivots);
  const auto all = static_cast<std::ptrdiff_t>(problem.points.size());
  const auto timed = problem.timing == Timing::mixed
                         ? std::ranges::count(problem.has_crank_angle, true)
                         : (problem.timing == Timing::free ? 0 : all);
  const bool phase = timed > 0 && problem.crank_reference == CrankReference::first;
  return lengths + places + phase + static_cast<int>(all - timed);
}

// The unknown crank angles of free timing are too many to be divided.
std::string_view certificate_refusal(const PathProblem& problem) {
  if (problem.method == PathMethod::exact) {
    return "is true with method = \"exact\", whose designs meet the points; remove it";
  }
  if (limits_turn(problem.constraints)) return kTurnNotCertified;
  if (problem.timing != Timing::prescribed) {
    return "is true where crank angles are free; only paths with timing = \"prescribed\" can be "
           "certified";
  }
  return {};
}

// Bounds on the error and what goes with them are in the file's unit.
std::string_view error_limit_refusal(const PathProblem& problem) {
  if (problem.method == PathMethod::exact) {
    return "is given with method = \"exact\", whose designs meet the points; remove it";
  }
  if (problem.curve && problem.curve->place == CurvePlace::similar) {
    return "is given with target.place = \"similar\", whose figures are of different sizes; remove "
           "it, or take place = \"given\"";
  }
  return {};
}

std::optional<AtlasSource> read_atlas(TableReader& solve, const std::filesystem::path& folder,
                                      bool closed) {
  constexpr std::string_view kKey = "atlas";
  const auto name = solve.text(kKey);
  if (!name) return std::nullopt;
  if (!closed) {
    solve.fault(kKey,
                "is given without a closed curve, which its curves could be compared with; "
                "remove it, or give target.curve, svg_path or svg");
    return std::nullopt;
  }
  if (folder.empty()) {
    solve.fault(kKey, "names a file beside the problem file, but there is none; remove it");
    return std::nullopt;
  }
  const auto file = folder / *name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    solve.fault(
        kKey, fmt::format("is \"{}\", where there is no file; expected the study file of an atlas, "
                          "as cognate sweep writes it",
                          *name));
    return std::nullopt;
  }
  const Where where = solve.where(kKey);
  return AtlasSource{*name, file, where.line, where.column};
}

// Designs on a raster are searched for by the error alone, where the target is.
std::string_view raster_refusal(const PathProblem& problem) {
  if (problem.method == PathMethod::exact) {
    return "is given with method = \"exact\", whose dimensions follow from the points; remove it";
  }
  if (problem.curve && problem.curve->place == CurvePlace::similar) {
    return "is given with target.place = \"similar\", whose figures are of different sizes; remove "
           "it, or take place = \"given\"";
  }
  return search_raster_refusal(problem.solve);
}

// Quantiles are those of tolerances, and sought from designs of least error.
std::string_view robust_refusal(const PathProblem& problem) {
  if (const auto why = robust_tolerance_refusal(problem.tolerances); !why.empty()) return why;
  if (problem.raster) return "is given with a raster; remove one of them";
  if (problem.given.pivot_d && !problem.given.pivot_a) {
    return "is given with pivot_d alone; give pivot_a as well, or neither";
  }
  if (problem.tolerances->pivots) {
    return "is given with tolerance.pivots, which it does not take into account: give that of "
           "frame instead, or remove it";
  }
  if (problem.curve && problem.curve->place == CurvePlace::similar) {
    return "is given with target.place = \"similar\"; remove it, or take place = \"given\"";
  }
  if (problem.method == PathMethod::exact) return "is given with method = \"exact\"; remove it";
  return robust_search_refusal(problem.solve);
}

void check_raster_frame(TableReader& document, const PathProblem& problem) {
  const Raster& raster = *problem.raster;
  const Given& given = problem.given;
  const bool pivots_open = !given.pivot_a || !given.pivot_d;
  if (!pivots_open || raster.rule("pivots") == nullptr) return;
  if (given.frame || given.frame_angle) {
    document.fault("raster",
                   "puts pivots on a raster, but mechanism gives frame or frame_angle_deg, which "
                   "follow from them; add pivots = \"free\"");
  }
  if (raster.has("frame")) {
    document.fault("raster",
                   "has frame, which follows from pivots on the raster; remove it, or add pivots = "
                   "\"free\"");
  }
}

std::optional<Raster> read_path_raster(TableReader& document, PathProblem& problem) {
  constexpr std::array<std::string_view, 7> kKeys{"length",  "pivots", "coupler_point", "crank",
                                                  "coupler", "rocker", "frame"};
  problem.raster = read_raster(document, kKeys, raster_refusal(problem));
  if (!problem.raster) return std::nullopt;
  check_raster_frame(document, problem);
  check_raster_bounds(document, *problem.raster, problem.given, problem.bounds);
  return problem.raster;
}

}  // namespace

}  // namespace cognate::problems::reading

namespace cognate::problems {

PathProblem KindTraits<PathProblem>::read(reading::TableReader& document,
                                          const std::filesystem::path& folder) {
  using namespace reading;
  PathProblem problem;
  LinkageTables tables(document);
  auto& [target, mechanism, bounds, constraints, solve] = tables;

  problem.method = holder("method", target, solve)
                       .choice<PathMethod>("method")
                       .value_or(PathMethod::least_squares);
  const bool closed = has_curve(target);
  if (closed && problem.method == PathMethod::exact) {
    holder("method", target, solve)
        .fault("method", "is \"exact\" for a closed curve, which no four-bar need meet; remove it");
    problem.method = PathMethod::least_squares;
  }
  const bool exact = problem.method == PathMethod::exact;
  if (closed) {
    read_curve(target, folder, problem);
    problem.crank_sense = target.choice<CrankSense>("crank_sense").value_or(problem.crank_sense);
  } else {
    read_positions(target, problem);
    read_timing(target, problem);
    read_weights(target, problem);
  }
  read_mechanism_type(mechanism);
  read_given_links(mechanism, problem.given);
  read_given_places(mechanism, problem.given);
  read_length_bounds(bounds, problem.bounds);
  read_place_bounds(bounds, problem.bounds);
  check_given(mechanism, problem.given, problem.bounds);
  read_link_constraints(constraints, length_limits(problem.given, problem.bounds),
                        problem.constraints);
  read_pivot_region(constraints, problem.given, problem.constraints);
  read_cycle_limits(document, constraints, solve,
                    {.refusal = exact ? "is given with method = \"exact\", whose designs meet the "
                                        "points regardless of what they do between; remove it"
                                      : ""},
                    problem.constraints);
  if (closed) {
    finish_curve(mechanism, bounds, constraints, problem);
  } else if (constraints.has("no_extra_loop")) {
    constraints.fault("no_extra_loop", "is given without a closed curve; remove it");
  }
  problem.solve = read_solve(solve, problem.constraints, false,
                             exact ? kMostExactDesigns : kMostSearchedDesigns);
  problem.atlas = read_atlas(solve, folder, closed);
  read_loss(solve, exact ? "method = \"exact\"" : "", problem.solve);
  if (!exact) check_unknown_count(solve, problem.solve.solver, unknown_count(problem));
  read_certificate(solve, certificate_refusal(problem), problem.solve);
  read_objectives(constraints, solve,
                  {.error = ErrorMeasure::rms_length, .exact = error_limit_refusal(problem)},
                  problem.constraints, problem.solve);
  if (exact) {
    if (!solve.has("designs")) problem.solve.designs = default_exact_designs(problem);
    check_exact_path(target, mechanism, solve, problem);
  }

  problem.raster = read_path_raster(document, problem);

  problem.tolerances = read_tolerances(document, four_bar_scope());
  read_robust(solve, robust_refusal(problem), problem.solve);
  problem.layers = read_design_layers(document, constraints, links_of<FourBar>(),
                                      layers_max_refusal(problem.solve));
  tables.finish();
  problem.warnings = read_warnings(document);
  return problem;
}

}  // namespace cognate::problems
