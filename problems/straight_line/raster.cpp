#include "problems/straight_line/raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/four_bar_raster.hpp"
#include "problems/raster/options.hpp"
#include "problems/raster/run_parts.hpp"
#include "problems/raster/shared_work.hpp"
#include "problems/straight_line/model.hpp"
#include "problems/straight_line/peaks.hpp"
#include "problems/straight_line/scan.hpp"
#include "problems/straight_line/segment_forms.hpp"
#include "synthesis/raster/model_raster.hpp"

namespace cognate::problems {
namespace {

using synthesis::RasterNumbers;
using synthesis::RasterPoint;
using synthesis::Solver;

/// Cells between nodes of single combinations to begin with.
constexpr int kCombinationCells = 24;
/// Rounds in which peaks between the nodes of a combination join them.
constexpr int kCombinationRounds = 10;
/// Segments of one linkage in one assembly that are refined.
constexpr std::size_t kSegmentsOfOne = 2;
/// Minima of a box, from which its halves go on.
constexpr std::size_t kBoxMinima = 3;
constexpr synthesis::ModelRasterOptions kSegmentOptions{.solver = Solver::slsqp,
                                                        .tolerance = 1e-9,
                                                        .iterations = 100,
                                                        .feasibility = kSegmentFeasibility};
/// The solver that takes over where the other leaves limits unmet.
constexpr synthesis::ModelRasterOptions kMendingOptions{.solver = Solver::ipopt,
                                                        .tolerance = 1e-9,
                                                        .iterations = 150,
                                                        .feasibility = kSegmentFeasibility};

/// How many of the best combinations are each searched as a problem of its own, where dimensions
/// are free beside the raster.
constexpr std::size_t kSearchedSegments = 12;

/// The greatest length that a link may have on the raster: by the segment, else by the bounds.
double longest_on_raster(const StraightLineProblem& problem) {
  if (problem.goal->length) return size_limit(problem) * *problem.goal->length;
  const Bounds& bounds = problem.bounds;
  const Given& given = problem.given;
  double longest = 0;
  for (const auto* range : {&bounds.crank, &bounds.coupler, &bounds.rocker, &bounds.frame}) {
    if (*range) longest = std::max(longest, (*range)->max);
  }
  for (const auto* length : {&given.crank, &given.coupler, &given.rocker, &given.frame}) {
    longest = std::max(longest, length->value_or(0));
  }
  return longest;
}

FourBarRaster segment_axes(const StraightLineProblem& problem, const SegmentModel& model,
                           double unit) {
  // The frame's length is on the raster; where its pivots are does not change the path.
  Given given = problem.given;
  given.pivot_a = given.pivot_d = Vec2d{};
  const FourBarPlaces places = model.places();
  const Bounds bounds = raster_bounds(problem);
  FourBarRaster axes = four_bar_raster(*problem.raster, given, bounds, places, {{}, unit});
  const RasterRule* offset = problem.raster->rule("offset");
  if (problem.type != MechanismType::slider_crank || problem.slider_offset || offset == nullptr) {
    return axes;
  }
  const double reach = longest_on_raster(problem);
  axes.dimensions.push_back(FourBarDimension::rocker);
  axes.axes.push_back({"offset", values_within(*offset, {-reach, reach}, {})});
  axes.variables.push_back(
      {.variable = places[static_cast<std::size_t>(FourBarDimension::rocker)], .scale = unit});
  return axes;
}

synthesis::ModelRasterOptions until(synthesis::ModelRasterOptions options,
                                    const Deadline& deadline) {
  options.deadline = &deadline;
  return options;
}

class SegmentRaster final : public synthesis::ModelRaster {
 public:
  SegmentRaster(const StraightLineProblem& problem, const StraightLineProblem& scaled, double unit,
                const SegmentForms& forms, const SegmentAcceptance& accepts,
                const Deadline& deadline)
      : SegmentRaster(scaled, unit, forms, accepts, deadline,
                      segment_axes(problem, forms.model(0), unit)) {}

  /// Of each assembly the best segments, their ends found anew; of a linkage with dimensions that
  /// are free also from the minima known.
  std::vector<RasterPoint> evaluate(const RasterNumbers& at,
                                    std::span<const RasterPoint> from) const override {
    std::vector<RasterPoint> all;
    const auto add = [&](const LinkageSegment& start) {
      auto made = refined(at, start);
      if (made && std::isfinite(made->objective)) all.push_back(*std::move(made));
    };
    const LinkageSegment like = from.empty() ? LinkageSegment{} : segment_at(from.front());
    for (const Assembly assembly : forms_.assemblies()) {
      LinkageSegment linkage = on_raster(at, like, assembly);
      for (const auto& start : starts_of(linkage)) add(start);
    }
    if (is_given_whole()) return all;
    for (const RasterPoint& point : from) add(segment_at(point));
    return all;
  }

  /// Where the quicker solver ends outside the limits another goes on from the same start: a box
  /// without minima counts as covered.
  std::vector<RasterPoint> relax(const synthesis::RasterBox& box,
                                 std::span<const RasterPoint> from) const override {
    std::vector<RasterPoint> all;
    for (const RasterPoint& start : from) {
      const std::span<const RasterPoint> one(&start, 1);
      std::vector<RasterPoint> found = ModelRaster::relax(box, one);
      if (found.empty() || found.front().violation > kSegmentFeasibility) {
        found = mending_.relax(box, one);
      }
      std::ranges::move(found, std::back_inserter(all));
    }
    return all;
  }

  bool accepts(const RasterPoint& point) const override { return accepts_(design(point)); }

  /// Whether the raster and the file leave no dimension free.
  bool is_given_whole() const {
    const FourBarPlaces places = forms_.model(0).places();
    return static_cast<std::ptrdiff_t>(dimensions_.size()) ==
           std::ranges::count_if(places, [](int place) { return place >= 0; });
  }

  /// The minima of one combination that a search begun with none known finds.
  std::vector<RasterPoint> searched(const RasterNumbers& at, const Run& run,
                                    const Deadline& deadline, Work& work) const {
    std::vector<RasterPoint> points;
    for (const SegmentDesign& one :
         search_segments(given_at(at), {}, {}, run, deadline, work).found) {
      auto found = refined(at, one.segment);
      if (found && std::isfinite(found->objective)) points.push_back(*std::move(found));
    }
    return points;
  }

  /// In the file's unit.
  SegmentDesign design(const RasterPoint& point) const {
    SegmentDesign made;
    made.segment = enlarged(segment_at(point), unit_);
    made.segment.pivot_a = unit_ * made.segment.pivot_a;
    for (std::size_t i = 0; i < dimensions_.size(); ++i) {
      const auto& values = axes()[i].values;
      place_of(made.segment, dimensions_[i]) = values.at(values.nearest(point.values[i]));
    }
    made.objective = point.objective;
    made.violation = point.violation;
    made.origin = "raster";
    return made;
  }

 private:
  SegmentRaster(const StraightLineProblem& scaled, double unit, const SegmentForms& forms,
                const SegmentAcceptance& accepts, const Deadline& deadline, FourBarRaster axes)
      : ModelRaster(axes.axes, axes.variables, forms.models(), until(kSegmentOptions, deadline)),
        mending_(std::move(axes.axes), std::move(axes.variables), forms.models(),
                 until(kMendingOptions, deadline)),
        scaled_(scaled),
        unit_(unit),
        forms_(forms),
        accepts_(accepts),
        dimensions_(std::move(axes.dimensions)) {}

  /// A combination as a problem of its own, its dimensions given.
  StraightLineProblem given_at(const RasterNumbers& at) const {
    StraightLineProblem given = scaled_;
    const bool has_offset = scaled_.type == MechanismType::slider_crank;
    for (std::size_t i = 0; i < dimensions_.size(); ++i) {
      const double value = variable_at(at, i);
      if (has_offset && dimensions_[i] == FourBarDimension::rocker) {
        given.slider_offset = value;
      } else {
        give_dimension(given.given, dimensions_[i], value);
      }
    }
    return given;
  }

  LinkageSegment segment_at(const RasterPoint& point) const {
    return forms_.model(point.form).segment(point.x);
  }

  static double& place_of(LinkageSegment& segment, FourBarDimension dimension) {
    if (dimension == FourBarDimension::point_u) return segment.dimensions.point.x;
    if (dimension == FourBarDimension::point_v) return segment.dimensions.point.y;
    return segment.dimensions.links[static_cast<std::size_t>(dimension)];
  }

  LinkageSegment on_raster(const RasterNumbers& at, LinkageSegment segment,
                           Assembly assembly) const {
    segment.type = scaled_.type;
    segment.assembly = assembly;
    segment.reach = std::max(segment.reach, 1e-2);
    segment.length = std::max(segment.length, 1e-2);
    const int form = forms_.known(segment);
    std::vector<double> x = forms_.variables_of(form, segment);
    place(at, x);
    segment = forms_.model(form).segment(x);
    segment.assembly = assembly;
    return segment;
  }

  /// Where the length is sought, from within the limit as well: solvers that begin with too long a
  /// segment may not come back to one that keeps it.
  std::vector<LinkageSegment> starts_of(const LinkageSegment& linkage) const {
    auto starts = scanned_segments(scaled_, linkage, kSegmentsOfOne);
    if (scaled_.goal->length) return starts;
    std::ranges::move(scanned_segments(scaled_, linkage, kSegmentsOfOne, 1.0),
                      std::back_inserter(starts));
    return starts;
  }

  /// The segment of one combination, peaks between the nodes among them (Remez's exchange).
  std::optional<RasterPoint> refined(const RasterNumbers& at, LinkageSegment segment) const {
    std::vector<double> nodes = segment_nodes(kCombinationCells);
    std::optional<RasterPoint> last;
    for (int round = 0; round < kCombinationRounds; ++round) {
      const auto model = std::make_shared<const SegmentModel>(scaled_, segment, nodes);
      const ModelRaster one({axes().begin(), axes().end()}, axis_variables(), {model},
                            kSegmentOptions);
      RasterPoint start;
      start.x = model->variables_of(segment);
      auto found = one.relax({at, at}, std::span(&start, 1));
      if (found.empty()) return std::nullopt;
      last = std::move(found.front());
      segment = model->segment(last->x);
      const std::vector<double> peaks =
          peaks_beyond(segment, nodes, scaled_.segment.speed_variation_max);
      if (peaks.empty()) break;
      nodes.insert(nodes.end() - 1, peaks.begin(), peaks.end());
      std::ranges::sort(nodes);
    }
    return in_form(*std::move(last), segment);
  }

  /// `point` of a model of its own in the variables of its form, with the deviation as measured.
  RasterPoint in_form(RasterPoint point, LinkageSegment segment) const {
    point.form = forms_.known(segment);
    point.x = forms_.variables_of(point.form, segment);
    if (objective_of(scaled_) != SegmentObjective::deviation) return point;
    const auto deviation = fit_line(segment);
    point.objective = deviation ? *deviation / segment.length : kInfinity;
    return point;
  }

  const ModelRaster mending_;
  const StraightLineProblem& scaled_;
  double unit_;
  const SegmentForms& forms_;
  const SegmentAcceptance& accepts_;
  std::vector<FourBarDimension> dimensions_;
};

}  // namespace

Bounds raster_bounds(const StraightLineProblem& problem) {
  Bounds bounds = problem.bounds;
  const double longest = longest_on_raster(problem);
  if (!(longest > 0) || !std::isfinite(longest)) return bounds;
  for (auto* range : {&bounds.crank, &bounds.coupler, &bounds.rocker, &bounds.frame}) {
    if (!*range) *range = Range{0, kInfinity};
    (*range)->max = std::min((*range)->max, longest);
  }
  if (!bounds.coupler_point) {
    bounds.coupler_point = Box{{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
  }
  // No farther from B than the size allows; without a length as far as coupler and any link reach.
  const double reach = problem.goal->length ? longest : 2 * longest;
  Box& box = *bounds.coupler_point;
  box.min = {std::max(box.min.x, -reach), std::max(box.min.y, -reach)};
  box.max = {std::min(box.max.x, reach), std::min(box.max.y, reach)};
  return bounds;
}

RasterMeasure segment_measure(const StraightLineProblem& problem, double unit) {
  switch (objective_of(problem)) {
    case SegmentObjective::deviation:
      return {[length = *problem.goal->length](double objective) { return length * objective; },
              "error"};
    case SegmentObjective::length:
      return {[unit](double objective) { return unit / std::sqrt(objective); }, "length"};
    case SegmentObjective::size:
      break;
  }
  return {[](double objective) { return std::sqrt(objective); }, "size"};
}

SegmentRasterResult search_segment_raster(const StraightLineProblem& problem,
                                          const StraightLineProblem& scaled, double unit,
                                          const std::vector<SegmentDesign>& minima,
                                          const SegmentAcceptance& accepts, const Run& run,
                                          const Deadline& deadline, Work& work) {
  SegmentForms forms(scaled);
  std::vector<int> numbers;
  for (const SegmentDesign& minimum : minima) numbers.push_back(forms.number_of(minimum.segment));
  const SegmentRaster raster(problem, scaled, unit, forms, accepts, deadline);
  std::vector<RasterPoint> from;
  for (std::size_t i = 0; i < minima.size(); ++i) {
    from.push_back(raster.point(numbers[i], forms.variables_of(numbers[i], minima[i].segment)));
  }
  auto options = raster_options(problem.solve, *problem.raster, run, deadline);
  options.feasibility = kSegmentFeasibility;
  options.minima = kBoxMinima;
  options.searched = kSearchedSegments;
  SharedWork shared(work);
  const Run alone = of_one_combination(run);
  if (!raster.is_given_whole()) {
    options.search = [&](const RasterNumbers& at) {
      return shared.counted([&](Work& own) { return raster.searched(at, alone, deadline, own); });
    };
  }
  SegmentRasterResult result;
  result.search = synthesis::search_raster(raster, from, options);
  result.search.is_enumerated = result.search.is_enumerated && raster.is_given_whole();
  for (const RasterPoint& point : result.search.designs) {
    result.designs.push_back(raster.design(point));
  }
  return result;
}

}  // namespace cognate::problems
