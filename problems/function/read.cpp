#include "problems/raster/read.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/function/error.hpp"
#include "problems/function/problem.hpp"
#include "problems/function/read_goal.hpp"
#include "problems/function/read_target.hpp"
#include "problems/layers/link_names.hpp"
#include "problems/linkage/cycle/read_cycle.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/read_linkage.hpp"
#include "problems/linkage/read_raster.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/search/read_objectives.hpp"
#include "problems/tolerance/read.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kInputStart = "input_start_deg";
constexpr std::string_view kOutputStart = "output_start_deg";
constexpr std::string_view kSliderStart = "output_start";

std::optional<double> read_start_angle(TableReader& mechanism, std::string_view key) {
  const auto degrees = mechanism.number(key, kAngle);
  return degrees ? std::optional(radians(*degrees)) : std::nullopt;
}

std::optional<Range> read_start_bounds(TableReader& bounds, std::string_view key) {
  const auto range = bounds.range(key, kAngle);
  return range ? std::optional(Range{radians(range->min), radians(range->max)}) : std::nullopt;
}

void check_start_bounds(TableReader& mechanism, std::string_view key,
                        const std::optional<double>& angle, const std::optional<Range>& bounds) {
  if (!angle || !bounds || (*angle >= bounds->min && *angle <= bounds->max)) return;
  mechanism.fault(key, fmt::format("lies outside bounds.{}; expected a start within it", key));
}

// The key of the output's start: an angle, or a slider's displacement.
std::string_view output_key(const FunctionProblem& problem) {
  return problem.type == MechanismType::slider_crank ? kSliderStart : kOutputStart;
}

void read_start(TableReader& mechanism, TableReader& bounds, FunctionProblem& problem) {
  problem.start = mechanism.choice<FunctionStart>("start").value_or(FunctionStart::free);
  const std::string_view output = output_key(problem);
  problem.input_start = read_start_angle(mechanism, kInputStart);
  problem.input_start_bounds = read_start_bounds(bounds, kInputStart);
  if (problem.type == MechanismType::slider_crank) {
    problem.output_start = mechanism.number(output, kNumber);
    problem.output_start_bounds = bounds.range(output, kCoordinateLimit);
  } else {
    problem.output_start = read_start_angle(mechanism, output);
    problem.output_start_bounds = read_start_bounds(bounds, output);
  }
  check_start_bounds(mechanism, kInputStart, problem.input_start, problem.input_start_bounds);
  check_start_bounds(mechanism, output, problem.output_start, problem.output_start_bounds);
  if (!mechanism.has("start") || problem.start == FunctionStart::free) return;
  for (const std::string_view key : {kInputStart, output}) {
    if (!mechanism.has(key)) continue;
    mechanism.fault(key,
                    "is given beside mechanism.start; give the start angles or where the "
                    "motion starts");
  }
}

// The offset of a slider-crank, where it is given one length less to find.
void read_offset(TableReader& mechanism, TableReader& bounds, FunctionProblem& problem) {
  constexpr std::string_view kKey = "offset";
  problem.offset = mechanism.number(kKey, kNumber);
  problem.offset_bounds = bounds.range(kKey, kCoordinateLimit);
  const auto& [offset, range] = std::tie(problem.offset, problem.offset_bounds);
  if (!offset || !range || (*offset >= range->min && *offset <= range->max)) return;
  mechanism.fault(kKey, fmt::format("is {}, outside its bounds; bounds.offset allows [{}, {}]",
                                    *offset, range->min, range->max));
}

// Three conditions determine the three ratios of the lengths (of a slider-crank three lengths, or
// two beside a given offset), each further one a start that is not given; with fewer a family is
// left.
void check_exact_start(TableReader& mechanism, FunctionProblem& problem) {
  const std::string_view output = output_key(problem);
  if (problem.start != FunctionStart::free) {
    mechanism.fault("start",
                    fmt::format("is a limit position, which depends on the lengths sought; "
                                "exact synthesis takes {} and {} instead, or neither",
                                kInputStart, output));
    return;
  }
  const bool pairs = std::holds_alternative<AnglePairs>(problem.target);
  const bool any = mechanism.has(kInputStart) || mechanism.has(output) || mechanism.has("start");
  const bool has_offset = problem.type == MechanismType::slider_crank && mechanism.has("offset");
  if (pairs && problem.precision_points == 3 && !any && !has_offset) {
    // The pairs are then counted from the frame line (from the slide direction and the foot).
    problem.input_start = 0;
    problem.output_start = 0;
    return;
  }
  int room = 5 - problem.precision_points;  // how many of these may be given
  if (has_offset && --room < 0) {
    mechanism.fault("offset",
                    "is given, but five conditions determine it; remove it or give fewer");
  }
  for (const std::string_view key : {kInputStart, output}) {
    if (!mechanism.has(key) || --room >= 0) continue;
    mechanism.fault(
        key, fmt::format("is given, but {} conditions{} leave {} start to be given; remove "
                         "it or give fewer",
                         problem.precision_points, has_offset ? " and the offset" : "",
                         problem.precision_points + int{has_offset} >= 5 ? "no" : "only one"));
  }
}

void check_exact_lengths(TableReader& mechanism) {
  for (const std::string_view key : {"coupler", "rocker"}) {
    if (!mechanism.has(key)) continue;
    mechanism.fault(key,
                    "is given, but exact synthesis finds every ratio of the lengths; only "
                    "crank or frame, for the scale, may be given");
  }
  if (mechanism.has("crank") && mechanism.has("frame")) {
    mechanism.fault("frame",
                    "is given beside crank, but exact synthesis finds their ratio; give "
                    "one of them, for the scale");
  }
}

// Angles say nothing of size: without a given length the crank is the unit.
void set_scale(TableReader& mechanism, TableReader& bounds, FunctionProblem& problem) {
  if (mechanism.has("crank") || mechanism.has("frame")) return;
  const auto& range = problem.bounds.crank;
  if (range && (range->min > 1 || range->max < 1)) {
    bounds.fault(bounds.has("crank") ? "crank" : "length",
                 "excludes crank = 1, which is the scale where neither crank nor frame is given; "
                 "give one of them in [mechanism], or bounds that contain 1");
    return;
  }
  problem.given.crank = 1;
}

// "four-bar", the default, or "slider-crank".
void read_type(TableReader& mechanism, FunctionProblem& problem) {
  constexpr std::string_view kKey = "type";
  constexpr std::string_view kTypes[] = {"four-bar", "slider-crank"};
  const auto type = mechanism.choice_of(kKey, kTypes);
  if (type && *type == 1) problem.type = MechanismType::slider_crank;
}

// Displacements give the scale, so that no length is given.
void read_slider_bounds(TableReader& bounds, FunctionProblem& problem) {
  read_length_bounds(bounds, problem.bounds);
  for (const std::string_view key : {"rocker", "frame"}) {
    if (!bounds.has(key)) continue;
    bounds.fault(key, "has no meaning for a slider-crank; crank, coupler and length have");
  }
  problem.bounds.rocker.reset();
  problem.bounds.frame.reset();
}

void read_slider_constraints(TableReader& constraints, FunctionProblem& problem) {
  const auto& bounds = problem.bounds;
  const Range any{0, kInfinity};
  read_link_constraints(constraints,
                        {bounds.crank.value_or(any), bounds.coupler.value_or(any), any, any},
                        problem.constraints);
  if (!constraints.has("class")) return;
  constraints.fault("class",
                    "is Grashof's of a four-bar; transmission_angle_deg, link_ratio_max and the "
                    "defects are for slider-cranks");
  problem.constraints.required_class.reset();
}

void read_best_by(TableReader& solve, FunctionProblem& problem) {
  constexpr std::string_view kKey = "best_by";
  problem.best_by = solve.choice<BestBy>(kKey);
  if (!solve.has(kKey) || problem.objective == FunctionObjective::exact) return;
  solve.fault(kKey, "chooses among exact designs; expected it with precision_points only");
}

void read_four_bar_tables(TableReader& mechanism, TableReader& bounds, TableReader& constraints,
                          FunctionProblem& problem) {
  read_given_links(mechanism, problem.given);
  read_length_bounds(bounds, problem.bounds);
  read_start(mechanism, bounds, problem);
  if (problem.objective == FunctionObjective::exact) {
    check_exact_start(mechanism, problem);
    check_exact_lengths(mechanism);
  }
  check_given(mechanism, problem.given, problem.bounds);
  set_scale(mechanism, bounds, problem);
  read_link_constraints(constraints, length_limits(problem.given, problem.bounds),
                        problem.constraints);
}

// `target_read`: whether [target] is known to ask for something else than exact synthesis.
void read_slider_tables(TableReader& mechanism, TableReader& bounds, TableReader& constraints,
                        bool target_read, FunctionProblem& problem) {
  read_slider_bounds(bounds, problem);
  read_offset(mechanism, bounds, problem);
  read_start(mechanism, bounds, problem);
  if (problem.objective == FunctionObjective::exact) {
    check_exact_start(mechanism, problem);
  } else if (target_read) {
    mechanism.fault(
        "type",
        "\"slider-crank\" is for exact synthesis in this version; expected precision_points = 3, "
        "4 or 5, or objective = \"exact\"");
  }
  read_slider_constraints(constraints, problem);
}

// The method of the file, where that is not least squares.
std::string_view beside_least_squares(FunctionObjective objective) {
  switch (objective) {
    case FunctionObjective::exact:
      return "precision points";
    case FunctionObjective::minimax:
      return "objective = \"minimax\"";
    case FunctionObjective::least_squares:
      break;
  }
  return {};
}

// Level peaks need a precision point for each thing that is free.
void check_spacing(TableReader& table, const FunctionProblem& problem) {
  constexpr std::string_view kKey = "spacing";
  const bool level = problem.spacing == PointSpacing::equal_peaks;
  if (!level || problem.objective != FunctionObjective::exact) return;
  const int wanted = 3 + int{!problem.input_start} + int{!problem.output_start};
  if (problem.type == MechanismType::slider_crank) {
    table.fault(kKey, "is \"equal-peaks\", which is for four-bars; expected \"chebyshev\"");
  } else if (problem.precision_points < wanted) {
    table.fault(kKey, fmt::format("is \"equal-peaks\" with fewer precision points than lengths and "
                                  "start angles are free; expected precision_points = {}",
                                  wanted));
  }
}

// Whether there is a target to go on with.
bool read_target(TableReader& target, TableReader& solve, FunctionProblem& problem) {
  auto read = read_function_target(target, problem.type);
  if (!read) {
    know_function_goal(target, solve);
    return false;
  }
  problem.target = *std::move(read);
  read_function_goal(target, solve, problem);
  return true;
}

// The frame stands where one likes.
CycleScope turn_scope(const FunctionProblem& problem) {
  CycleScope scope{.has_place = false, .has_coupler_point = false};
  if (problem.objective == FunctionObjective::exact) {
    scope.refusal =
        "is given with exact synthesis, whose designs meet the precision points regardless of what "
        "they do "
        "between; remove it";
  }
  return scope;
}

std::string_view certificate_refusal(const FunctionProblem& problem) {
  if (problem.objective != FunctionObjective::least_squares) {
    return "is true, but only designs of least squares can be certified; expected objective = "
           "\"least-squares\"";
  }
  return limits_turn(problem.constraints) ? kTurnNotCertified : std::string_view{};
}

std::string_view raster_refusal(const FunctionProblem& problem) {
  if (problem.objective == FunctionObjective::exact) {
    return "is given with precision points, which lengths on a raster do not meet exactly; "
           "expected "
           "objective = \"least-squares\" or \"minimax\", or remove it";
  }
  return search_raster_refusal(problem.solve);
}

std::string_view robust_refusal(const FunctionProblem& problem) {
  if (const auto why = robust_tolerance_refusal(problem.tolerances); !why.empty()) return why;
  if (problem.raster) return "is given with a raster; remove one of them";
  if (problem.objective != FunctionObjective::least_squares) {
    return "is given, but robust designs start from least squares; expected objective = "
           "\"least-squares\", or remove it";
  }
  return robust_search_refusal(problem.solve);
}

// On a raster the size matters: bounds of the crank take the place of its unit.
std::optional<Raster> read_function_raster(TableReader& document, TableReader& mechanism,
                                           FunctionProblem& problem) {
  constexpr std::array<std::string_view, 5> kKeys{"length", "crank", "coupler", "rocker", "frame"};
  auto raster = read_raster(document, kKeys, raster_refusal(problem));
  if (!raster) return std::nullopt;
  const auto& crank = problem.bounds.crank;
  const bool is_unit = !mechanism.has("crank") && !mechanism.has("frame");
  if (is_unit && raster->rule("crank") != nullptr && crank && std::isfinite(crank->max)) {
    problem.given.crank.reset();
  }
  check_raster_bounds(document, *raster, problem.given, problem.bounds);
  return raster;
}

LinkNames function_links(MechanismType type) {
  return type == MechanismType::slider_crank ? links_of<SliderCrank>() : links_of<FourBar>();
}

ToleranceScope function_scope(const FunctionProblem& problem) {
  if (problem.type == MechanismType::slider_crank) return slider_crank_scope();
  ToleranceScope scope = four_bar_scope();
  std::erase(scope.dimensions, "coupler_point");
  scope.unit = "deg";
  return scope;
}

}  // namespace

}  // namespace cognate::problems::reading

namespace cognate::problems {

FunctionProblem KindTraits<FunctionProblem>::read(reading::TableReader& document,
                                                  const std::filesystem::path& /*folder*/) {
  using namespace reading;
  FunctionProblem problem;
  LinkageTables tables(document);
  auto& [target, mechanism, bounds, constraints, solve] = tables;

  read_type(mechanism, problem);
  const bool target_read = read_target(target, solve, problem);
  if (problem.type == MechanismType::slider_crank) {
    read_slider_tables(mechanism, bounds, constraints, target_read, problem);
  } else {
    read_four_bar_tables(mechanism, bounds, constraints, problem);
  }
  check_spacing(holder("spacing", target, solve), problem);
  read_cycle_limits(document, constraints, solve, turn_scope(problem), problem.constraints);
  read_best_by(solve, problem);
  problem.solve =
      read_solve(solve, problem.constraints, problem.objective == FunctionObjective::minimax);
  read_loss(solve, beside_least_squares(problem.objective), problem.solve);
  read_certificate(solve, certificate_refusal(problem), problem.solve);

  const bool exact = problem.objective == FunctionObjective::exact;
  read_objectives(constraints, solve,
                  {.error = error_measure(problem),
                   .exact = exact ? "is given with precision points, at which the error is 0; "
                                    "remove it"
                                  : "",
                   .has_sizes = false,
                   .needs_full_turn = false},
                  problem.constraints, problem.solve);
  problem.raster = read_function_raster(document, mechanism, problem);

  problem.tolerances = read_tolerances(document, function_scope(problem));
  read_robust(solve, robust_refusal(problem), problem.solve);
  problem.layers = read_design_layers(document, constraints, function_links(problem.type),
                                      layers_max_refusal(problem.solve));
  tables.finish();
  problem.warnings = read_warnings(document);
  return problem;
}

}  // namespace cognate::problems
