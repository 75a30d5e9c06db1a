#include "problems/guidance/raster_axes.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/guidance/dimensions.hpp"

namespace cognate::problems {
namespace {

using namespace motion_dimensions;
using synthesis::Pose;

/// How far values reach where nothing bounds them, in sizes.
constexpr double kMotionReach = 1000;

/// The axes of a problem, in the file's unit.
class MotionAxisList {
 public:
  MotionAxisList(const MotionProblem& problem, const MotionModel& model, const MotionScale& scale)
      : problem_(problem), free_(model.free_dimensions()), scale_(scale) {}

  MotionAxes take() {
    add_point(kMoving1, "moving_pivot_a", "moving_pivots", problem_.moving_bounds[0], {}, {});
    add_point(kMoving2, "moving_pivot_d", "moving_pivots", problem_.moving_bounds[1], {}, {});
    const Vec2d centre = scale_.out_of(Pose{}).at;
    const auto& region = problem_.constraints.pivot_region;
    add_point(kFixed1, "pivot_a", "pivots", problem_.bounds.pivot_a, region, centre);
    add_point(kFixed2, "pivot_d", "pivots", problem_.bounds.pivot_d, region, centre);
    add_length(kLength1, "crank", problem_.bounds.crank);
    add_length(kLength2, "rocker", problem_.bounds.rocker);
    return std::move(all_);
  }

 private:
  void add_point(int dimension, const std::string& name, std::string_view key,
                 const std::optional<Box>& bounds, const std::optional<Box>& region,
                 const Vec2d& offset) {
    const RasterRule* rule = problem_.raster->rule(key);
    if (rule == nullptr) return;
    Range x{-kInfinity, kInfinity}, y = x;
    for (const auto& box : {bounds, region}) {
      if (!box) continue;
      x = {std::max(x.min, box->min.x), std::min(x.max, box->max.x)};
      y = {std::max(y.min, box->min.y), std::min(y.max, box->max.y)};
    }
    const std::string_view ends = key == "pivots" ? "xy" : "uv";
    add(*rule, dimension, name + "." + ends[0], x, offset.x);
    add(*rule, dimension + 1, name + "." + ends[1], y, offset.y);
  }

  void add_length(int dimension, const std::string& name, const std::optional<Range>& bounds) {
    const RasterRule* rule = problem_.raster->rule(name);
    if (rule == nullptr) return;
    Range range = bounds.value_or(Range{0, kInfinity});
    // A link of no length is none.
    range.min = std::max(range.min, rule->step ? 0.5 * *rule->step : rule->values.front());
    add(*rule, dimension, name, range, 0);
  }

  void add(const RasterRule& rule, int dimension, std::string name, const Range& range,
           double offset) {
    const auto place = std::ranges::find(free_, dimension);
    if (place == free_.end()) return;
    const double reach = kMotionReach * scale_.size();
    all_.dimensions.push_back(dimension);
    all_.axes.push_back(
        {std::move(name), values_within(rule, range, {offset - reach, offset + reach})});
    all_.variables.push_back({.variable = static_cast<int>(place - free_.begin()),
                              .offset = offset,
                              .scale = scale_.size()});
  }

  const MotionProblem& problem_;
  std::span<const int> free_;
  const MotionScale& scale_;
  MotionAxes all_;
};

/// Of a point both coordinates are on the raster, one after the other.
void give(MotionProblem& problem, int dimension, double value) {
  const auto coordinate = [&](std::optional<Box>& box, int first) {
    if (!box) box = Box{};
    (dimension == first ? box->min.x : box->min.y) = value;
    (dimension == first ? box->max.x : box->max.y) = value;
  };
  if (dimension == kLength1) {
    problem.crank = value;
  } else if (dimension == kLength2) {
    problem.rocker = value;
  } else if (dimension >= kFixed2) {
    coordinate(problem.bounds.pivot_d, kFixed2);
  } else if (dimension >= kMoving2) {
    coordinate(problem.moving_bounds[1], kMoving2);
  } else if (dimension >= kFixed1) {
    coordinate(problem.bounds.pivot_a, kFixed1);
  } else {
    coordinate(problem.moving_bounds[0], kMoving1);
  }
}

/// Both pivots of a kind, where bounds leave no choice of them.
void give_pivots(const std::optional<Box>& driven, const std::optional<Box>& other,
                 bool first_is_driven, std::vector<Vec2d>& pivots) {
  const auto is_place = [](const std::optional<Box>& box) {
    return box && box->min.x == box->max.x && box->min.y == box->max.y;
  };
  if (!pivots.empty() || !is_place(driven) || !is_place(other)) return;
  pivots = {driven->min, other->min};
  if (!first_is_driven) std::swap(pivots[0], pivots[1]);
}

}  // namespace

MotionAxes motion_axes(const MotionProblem& problem, const MotionModel& model,
                       const MotionScale& scale) {
  return MotionAxisList(problem, model, scale).take();
}

MotionProblem with_dimensions(MotionProblem scaled, std::span<const int> dimensions,
                              std::span<const double> values) {
  for (std::size_t i = 0; i < dimensions.size(); ++i) give(scaled, dimensions[i], values[i]);
  const bool first = scaled.first_is_driven;
  give_pivots(scaled.bounds.pivot_a, scaled.bounds.pivot_d, first, scaled.fixed_pivots);
  give_pivots(scaled.moving_bounds[0], scaled.moving_bounds[1], first, scaled.moving_pivots);
  return scaled;
}

}  // namespace cognate::problems
