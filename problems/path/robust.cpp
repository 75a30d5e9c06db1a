/// Paths by four-bars that mind their tolerances least, as a task of the search for these.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "problems/path/crank_sense.hpp"
#include "problems/path/found.hpp"
#include "problems/path/order.hpp"
#include "problems/path/ordered_model.hpp"
#include "problems/path/search.hpp"

namespace cognate::problems {
namespace {

struct TolerancedName {
  std::string_view name;
  PathModel::Dimension dimension;
};
constexpr std::array kTolerancedNames{TolerancedName{"crank", PathModel::crank},
                                      TolerancedName{"coupler", PathModel::coupler},
                                      TolerancedName{"rocker", PathModel::rocker},
                                      TolerancedName{"frame", PathModel::frame},
                                      TolerancedName{"coupler_point.u", PathModel::point_u},
                                      TolerancedName{"coupler_point.v", PathModel::point_v}};

/// Whether the file gives a dimension.
bool is_given(const Given& given, PathModel::Dimension dimension) {
  const bool pivots = given.pivot_a && given.pivot_d;
  switch (dimension) {
    case PathModel::crank:
      return given.crank.has_value();
    case PathModel::coupler:
      return given.coupler.has_value();
    case PathModel::rocker:
      return given.rocker.has_value();
    case PathModel::frame:
      return given.frame || pivots;
    case PathModel::angle:
      return given.frame_angle || pivots;
    case PathModel::point_u:
    case PathModel::point_v:
      return given.coupler_point.has_value();
    case PathModel::anchor_x:
    case PathModel::anchor_y:
      return given.pivot_a.has_value();
    case PathModel::phase:
      return false;
  }
  return false;
}

/// A model in which all dimensions are variables, those that are given held by bounds.
class OpenedPath {
 public:
  OpenedPath(const PathProblem& scaled, const PathMinimum& minimum)
      : problem_(scaled), clockwise_(minimum.clockwise) {
    const std::optional<Assembly> assembly = scaled.given.assembly;
    problem_.given = {};
    problem_.given.assembly = assembly;
    problem_.constraints.required_class = minimum.confined_to;
    model_ = std::make_shared<const PathModel>(problem_, minimum.assembly, clockwise_);
  }

  const std::shared_ptr<const PathModel>& model() const { return model_; }

  /// With points that are not timed where they come nearest; false where there is no such place.
  bool place_points(std::vector<double>& x) const {
    if (!assigns_places(problem_)) return true;
    std::optional<OrderedPathModel::Whole> best;
    for (const bool clockwise : {false, true}) {
      const CrankSense sense = clockwise ? CrankSense::cw : CrankSense::ccw;
      const bool allowed =
          problem_.crank_sense == CrankSense::either || problem_.crank_sense == sense;
      if (leaves_sense_open(problem_) ? !allowed : clockwise != clockwise_) continue;
      auto whole = OrderedPathModel(problem_, *model_, clockwise).whole(x);
      if (whole && (!best || whole->places.cost < best->places.cost)) best = std::move(whole);
    }
    if (best) x = std::move(best->x);
    return best.has_value();
  }

 private:
  PathProblem problem_;
  bool clockwise_;
  std::shared_ptr<const PathModel> model_;
};

/// Empty where no dimension has a tolerance, or a standard has none for it.
std::optional<RobustStart> start_of(const PathProblem& problem, const PathProblem& scaled,
                                    const PathScale& scale, const PathMinimum& minimum,
                                    const OpenedPath& opened) {
  const PathModel found = model_of(scaled, minimum);
  const FourBar linkage = found.linkage(minimum.solution.x);
  RobustStart start;
  start.model = opened.model();
  start.x = opened.model()->variables_of(linkage, found.crank_angles(minimum.solution.x));
  const auto free = opened.model()->free_dimensions();
  for (std::size_t i = 0; i < start.x.size(); ++i) {
    const auto& [name, lower, upper, unit] = opened.model()->variables()[i];
    const bool given =
        i < free.size() && is_given(problem.given, static_cast<PathModel::Dimension>(free[i]));
    start.lower.push_back(given ? start.x[i] : lower);
    start.upper.push_back(given ? start.x[i] : upper);
  }
  const auto toleranced =
      problems::toleranced(named(scale.out_of(linkage)), *problem.tolerances, problem.length_unit);
  if (!toleranced) return std::nullopt;
  for (const TolerancedDimension& dimension : toleranced->dimensions) {
    const auto known = std::ranges::find(kTolerancedNames, dimension.name, &TolerancedName::name);
    if (known == kTolerancedNames.end()) continue;
    const auto place = std::ranges::find(free, static_cast<int>(known->dimension));
    start.dimensions.push_back(dimension);
    start.variables.push_back(
        {.variable = static_cast<int>(place - free.begin()), .scale = scale.size});
  }
  return start.dimensions.empty() ? std::nullopt : std::optional(std::move(start));
}

}  // namespace

RobustTask robust_path_task(const PathProblem& problem, const PathProblem& scaled,
                            const PathScale& scale, const std::vector<PathMinimum>& minima,
                            const VerifiedPath& verified) {
  RobustTask task;
  task.share = *problem.solve.robust;
  task.distribution = problem.tolerances->distribution;
  task.components = 2;
  task.unit = scale.size;
  for (const double weight : scaled.weights) {
    task.scale.push_back(weight > 0 ? 1 / std::sqrt(weight) : 0);
  }
  using Opened = std::map<const synthesis::Model*, std::shared_ptr<const OpenedPath>>;
  auto opened = std::make_shared<Opened>();
  for (const PathMinimum& minimum : minima) {
    if (minimum.solution.violation > kPathFeasibility) continue;
    auto path = std::make_shared<const OpenedPath>(scaled, minimum);
    auto start = start_of(problem, scaled, scale, minimum, *path);
    if (!start) {
      task.lacks_tolerances = true;
      continue;
    }
    opened->emplace(start->model.get(), std::move(path));
    task.starts.push_back(*std::move(start));
  }
  task.place = [opened](const RobustStart& start, std::vector<double>& x) {
    return opened->at(start.model.get())->place_points(x);
  };
  task.design = [&scale, verified, opened](const RobustStart& start, const std::vector<double>& x) {
    const PathModel& model = *opened->at(start.model.get())->model();
    return verified(scale.out_of(model.linkage(x)), model.crank_angles(x));
  };
  return task;
}

}  // namespace cognate::problems
