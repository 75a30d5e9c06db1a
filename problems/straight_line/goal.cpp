#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/numbers/parallel.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/same_design.hpp"
#include "problems/linkage/twins.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/raster/run_parts.hpp"
#include "problems/straight_line/model.hpp"
#include "problems/straight_line/normalised.hpp"
#include "problems/straight_line/raster.hpp"
#include "problems/straight_line/search.hpp"
#include "problems/straight_line/solutions.hpp"
#include "synthesis/search/pareto_front.hpp"

namespace cognate::problems {
namespace {

using synthesis::FrontDesign;

struct SegmentFront {
  std::vector<SegmentDesign>
      points;    ///< from the largest linkage to the smallest, `designs` at most
  Family table;  ///< all points: measures of each
};

constexpr double kRatio = 0.8;
constexpr int kMostPoints = 12;
/// Afresh at every second bound, and from the points beside each.
constexpr SegmentEffort kFresh{90, 3, 0}, kOnward{0, 1, 0};
/// The front ends where δ/L exceeds this.
constexpr double kBentFront = 0.02;
constexpr double kFeasible = 1e-7;

/// The designs of a front behind their numbers.
class FrontDesigns {
 public:
  FrontDesigns(const StraightLineProblem& problem, const Run& run, const Deadline& deadline,
               Work& work)
      : problem_(problem), run_(silent(run)), deadline_(deadline), work_(work) {
    problem_.solve.designs = 1;
  }

  std::vector<FrontDesign> solve(std::optional<double> bound, const std::vector<std::size_t>& known,
                                 std::optional<std::uint64_t> seed) {
    problem_.segment.size_over_length_max = bound;
    if (seed) run_.seed = *seed;
    std::vector<LinkageSegment> begun;
    for (const std::size_t one : known) begun.push_back(all_[one].segment);
    auto found =
        search_segments(problem_, begun, seed ? kFresh : kOnward, run_, deadline_, work_).found;
    if (found.empty() || found.front().violation > kFeasible) return {};
    all_.push_back(std::move(found.front()));
    const SegmentDesign& best = all_.back();
    return {{all_.size() - 1, size_over_length(best.segment), best.objective}};
  }

  const SegmentDesign& operator[](const FrontDesign& design) const { return all_[design.number]; }

 private:
  StraightLineProblem problem_;
  Run run_;
  const Deadline& deadline_;
  Work& work_;
  std::vector<SegmentDesign> all_;
};

SegmentFront table_of(const std::vector<synthesis::FrontPoint>& points, const FrontDesigns& designs,
                      int wanted) {
  SegmentFront front;
  front.table.name = "straight-line front";
  front.table.columns = {{"size_over_length", {}},
                         {"deviation_relative", {}},
                         {"log10_deviation_relative", {}},
                         {"straight_length_over_size", {}},
                         {"crank_range_deg", {}}};
  const double step = std::max(1.0, static_cast<double>(points.size()) / wanted);
  double next = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SegmentDesign& found = designs[points[i].design()];
    const double size = points[i].design().value;
    const double values[] = {size, found.objective, std::log10(std::max(found.objective, 1e-16)),
                             1 / size, degrees(2 * found.segment.reach)};
    for (std::size_t k = 0; k < 5; ++k) front.table.columns[k].values.push_back(values[k]);
    if (double(i) + 0.5 < next) continue;
    front.points.push_back(found);
    next += step;
  }
  return front;
}

/// The largest dimension over the length is bounded and δ/L minimised, for bounds in equal ratios
/// down from `size_limit` until segments are no longer straight. In the search's unit.
SegmentFront segment_front(const StraightLineProblem& problem, const Run& run,
                           const Deadline& deadline, Work& work) {
  run.enter(Phase::front, kUnknownEnd);
  FrontDesigns designs(problem, run, deadline, work);
  const synthesis::FrontProblem along{
      {.level = [](double size) { return -std::log(size); },
       .value_at = [](double level) { return std::exp(-level); }},
      0,
      [&](std::optional<double> bound, const std::vector<std::size_t>& known,
          std::optional<std::uint64_t> seed) { return designs.solve(bound, known, seed); }};
  synthesis::FrontSearch search(along, {run.seed, deadline, run.progress});
  search.step(-std::log(size_limit(problem)), -std::log(kRatio), kMostPoints, kBentFront);
  return table_of(search.points(), designs, problem.solve.designs);
}

/// The unit of the search, in which segment and linkage are of the order of 1.
double unit_of(const StraightLineProblem& problem) {
  const Given& given = problem.given;
  const Bounds& bounds = problem.bounds;
  if (problem.goal->length) return *problem.goal->length;
  for (const auto& length : {given.frame, given.coupler, given.rocker, given.crank}) {
    if (length) return *length;
  }
  if (given.pivot_a && given.pivot_d) return norm(*given.pivot_d - *given.pivot_a);
  for (const auto& range : {bounds.crank, bounds.coupler, bounds.rocker, bounds.frame}) {
    if (range && std::isfinite(range->max)) return range->max;
  }
  for (const auto& range : {bounds.crank, bounds.coupler, bounds.rocker, bounds.frame}) {
    if (range && range->min > 0) return range->min;
  }
  for (const auto& box :
       {bounds.coupler_point, bounds.pivot_d, bounds.pivot_a, problem.constraints.pivot_region}) {
    const double size = box ? norm(box->max - box->min) : 0;
    if (size > 0 && std::isfinite(size)) return size;
  }
  return 1;
}

/// Pivots given both are a frame and its direction, ends of the line its length and direction.
StraightLineProblem prepared(StraightLineProblem problem) {
  StraightLineGoal& goal = *problem.goal;
  if (goal.ends) {
    goal.length = norm(goal.ends->back() - goal.ends->front());
    goal.direction.reset();
  }
  Given& given = problem.given;
  if (given.pivot_a && given.pivot_d) {
    const Vec2d frame = *given.pivot_d - *given.pivot_a;
    given.frame = norm(frame);
    given.frame_angle = std::atan2(frame.y, frame.x);
  }
  return problem;
}

void mark_cognates(std::vector<Design>& designs) {
  for (std::size_t i = 1; i < designs.size(); ++i) {
    for (std::size_t k = 0; k < i && !designs[i].cognate_of; ++k) {
      const FourBar *own = designs[i].mechanism.four_bar(),
                    *other = designs[k].mechanism.four_bar();
      if (own && other && is_cognate(*other, *own, 1e-4)) {
        designs[i].cognate_of = static_cast<int>(k);
      }
    }
  }
}

double merit(const StraightLineProblem& problem, const Design& design) {
  const auto [length, deviation, size] = measures_of(design);
  switch (objective_of(problem)) {
    case SegmentObjective::deviation:
      return deviation / length;
    case SegmentObjective::length:
      return -length;
    case SegmentObjective::size:
      return size;
  }
  return 0;
}

void sort(const StraightLineProblem& problem, std::vector<Design>& designs) {
  std::ranges::stable_sort(designs, [&](const Design& a, const Design& b) {
    const bool first = all_satisfied(a.constraints), second = all_satisfied(b.constraints);
    if (first != second) return first;
    return first ? merit(problem, a) < merit(problem, b)
                 : violation(a.constraints) < violation(b.constraints);
  });
  // Where there are sound designs nobody wants others.
  if (designs.empty() || !all_satisfied(designs.front().constraints)) return;
  std::erase_if(designs, [](const Design& d) { return !all_satisfied(d.constraints); });
}

Status status_of(const Result& result, const Deadline& deadline) {
  if (deadline.interrupted()) return Status::interrupted;
  if (deadline.expired()) return Status::time_limit;
  if (result.designs.empty()) return Status::no_solution;
  return all_satisfied(result.designs.front().constraints) ? Status::solved : Status::infeasible;
}

void add_notes(const StraightLineProblem& problem, Result& result) {
  if (!has_scale(problem) && !problem.goal->length) {
    result.notes.emplace_back(
        "The file fixes no length: linkages are drawn to a straight segment of length 1.");
  }
  if (!problem.segment.size_over_length_max && size_limit(problem) == kSizeOverLength) {
    result.notes.push_back(
        fmt::format("No link is more than {} times as long as the segment, the coupler's point "
                    "included, since larger linkages are always straighter; "
                    "constraints.size_over_length_max changes that.",
                    kSizeOverLength));
  }
  if (result.designs.empty() && !problem.raster) {
    result.notes.emplace_back(
        "No linkage with a segment worth refining was found under these constraints.");
  }
}

/// The continuous optimum and other minima, then the raster.
void add_raster_designs(const StraightLineProblem& problem, StraightLineProblem scaled, double unit,
                        const Run& run, const Deadline& deadline, Result& result) {
  constexpr int kMinima = 6;
  scaled.solve.designs = std::max(scaled.solve.designs, kMinima);
  const SegmentSearchResult continuous =
      search_segments(scaled, {}, {}, between_values(run), deadline, result.work);
  const auto accepts = [&](const SegmentDesign& found) {
    return all_satisfied(searched_design(problem, found).constraints);
  };
  const SegmentRasterResult found = search_segment_raster(
      problem, scaled, unit, continuous.found, accepts, on_values(run), deadline, result.work);
  for (const SegmentDesign& one : found.designs) {
    result.designs.push_back(searched_design(problem, one));
    result.designs.back().origin = one.origin;
  }
  result.quantities = quantities(continuous.statistics);
  const RasterMeasure measure = segment_measure(problem, unit);
  std::ranges::move(raster_quantities(found.search, measure),
                    std::back_inserter(result.quantities));
  result.notes = raster_notes(found.search, measure);
}

Result find_segments(const StraightLineProblem& problem, const Run& run, const Deadline& deadline) {
  const double unit = unit_of(problem);
  const StraightLineProblem scaled = in_unit(problem, unit);
  const bool front = wants_front(problem);
  Result result;
  std::vector<SegmentDesign> found;
  if (front) {
    SegmentFront along = segment_front(scaled, run, deadline, result.work);
    found = std::move(along.points);
    result.families.push_back(std::move(along.table));
  } else if (problem.raster) {
    add_raster_designs(problem, scaled, unit, run, deadline, result);
  } else {
    SegmentSearchResult search = search_segments(scaled, {}, {}, run, deadline, result.work);
    found = std::move(search.found);
    result.quantities = quantities(search.statistics);
  }
  for (SegmentDesign& one : found) {
    one.segment = in_file_unit(one.segment, unit);
    result.designs.push_back(searched_design(problem, one));
  }
  sort(problem, result.designs);
  const auto wanted = static_cast<std::size_t>(problem.solve.designs);
  if (!front && result.designs.size() > wanted) result.designs.resize(wanted);
  mark_cognates(result.designs);
  add_notes(problem, result);
  result.status = status_of(result, deadline);
  return result;
}

}  // namespace

Result search_straight_lines(const StraightLineProblem& file, const Run& run) {
  const Deadline deadline(run);
  const StraightLineProblem problem = prepared(file);
  Result result = solve_in_layers(problem, run, DesignSource::search,
                                  [&](const StraightLineProblem& one, const Run& own) {
                                    return find_segments(one, own, deadline);
                                  });
  mark_twins(result.designs);
  add_warnings(std::nullopt, problem.warnings, result);
  result.work.skipped = {"accelerations", "forces"};
  result.work.threads = thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
