#include "problems/cam/raster.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "analysis/cam/contact.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/cam/exact.hpp"
#include "problems/cam/extremes.hpp"
#include "problems/cam/quantities.hpp"
#include "problems/cam/second_contact.hpp"
#include "problems/cam/variables.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/raster/report.hpp"
#include "synthesis/raster/raster.hpp"

namespace cognate::problems {
namespace {

using Dimensions = cam::CamDimensions<double>;

/// Combinations that are tried at most: some minutes.
constexpr std::uint64_t kMostTried = 2'000'000;
/// Base radii reach so many typical lengths where nothing bounds them, as without a raster.
constexpr double kFarthestBase = 1e3;
/// What limits are kept to allows a base radius this much below its bound.
constexpr double kBelowBound = 1e-6;

double& length_of(Dimensions& d, CamDimension dimension) {
  double* const all[] = {&d.base_radius,     &d.offset, &d.roller_radius,
                         &d.centre_distance, &d.arm,    &d.face_offset};
  return *all[static_cast<int>(dimension)];
}

bool may_be_negative(CamDimension dimension) {
  return dimension == CamDimension::offset || dimension == CamDimension::face_offset;
}

/// The least value of `rule` that is a length.
double least_length(const RasterRule& rule) {
  if (rule.step) return 0.5 * *rule.step;
  const auto first = std::ranges::upper_bound(rule.values, 0.0);
  return first == rule.values.end() ? kInfinity : *first;
}

/// The greatest that a length without an upper end may have where its rule is a list.
double greatest_listed(const CamRasterAxis& axis) {
  const auto count = axis.values.count();
  if (count == 0) return 0;
  return std::max(std::abs(axis.values.at(0)), std::abs(axis.values.at(count - 1)));
}

/// No cam has a larger base radius, or none is looked for.
double base_reach(const CamProblem& problem, const std::vector<CamRasterAxis>& others) {
  if (!is_oscillating(problem.follower)) {
    double unit = CamVariables(problem).unit();
    for (const CamRasterAxis& axis : others) unit = std::max(unit, greatest_listed(axis));
    return kFarthestBase * unit;
  }
  double reach = 0;
  for (const CamDimension d :
       {CamDimension::centre_distance, CamDimension::arm, CamDimension::face_offset}) {
    reach += std::abs(problem.length(d).given.value_or(0));
  }
  for (const CamRasterAxis& axis : others) {
    if (axis.dimension != CamDimension::roller_radius) reach += greatest_listed(axis);
  }
  return reach;
}

CamRasterAxis axis_of(const CamProblem& problem, CamDimension dimension, double reach) {
  const RasterRule* rule = problem.raster->rule(to_string(dimension));
  if (rule == nullptr) return {dimension, {}};
  Range range = problem.length(dimension).bounds;
  if (!may_be_negative(dimension)) range.min = std::max(range.min, least_length(*rule));
  if (!(range.min <= range.max)) return {dimension, {}};
  const double end = rule->step ? reach : kInfinity;
  return {dimension, values_within(*rule, range, {-end, end})};
}

/// Every combination of the axes but the base radius, in their order.
std::vector<Dimensions> combinations_of(const CamProblem& problem,
                                        const std::vector<CamRasterAxis>& axes) {
  Dimensions given;
  for (const auto& [name, dimension] : names<CamDimension>()) {
    length_of(given, dimension) = problem.length(dimension).given.value_or(0);
  }
  std::vector<Dimensions> all{given};
  for (const CamRasterAxis& axis : axes) {
    if (axis.dimension == CamDimension::base_radius) continue;
    std::vector<Dimensions> longer;
    for (const Dimensions& before : all) {
      for (std::int64_t i = 0; i < axis.values.count(); ++i) {
        longer.push_back(before);
        length_of(longer.back(), axis.dimension) = axis.values.at(i);
      }
    }
    all = std::move(longer);
  }
  return all;
}

/// Whether the follower meets the base circle, and something of the cam is left.
bool can_be_assembled(const CamProblem& problem, const Dimensions& d, double start) {
  if (!std::isfinite(start) || !(d.roller_radius < d.base_radius)) return false;
  switch (problem.follower) {
    case cam::FollowerType::translating_flat:
      return true;
    case cam::FollowerType::oscillating_flat:
      return std::abs(start) < kRightAngle;
    case cam::FollowerType::oscillating_roller:
    case cam::FollowerType::oscillating_knife:
      return start > 0 && start < kPi;
    default:
      return std::abs(d.offset) < d.base_radius;
  }
}

/// The greatest pressure angle of the cam of these lengths; nothing where it breaks a limit.
std::optional<double> pressure_if_kept(const CamProblem& problem, CamDesign& design,
                                       const Dimensions& dimensions) {
  auto& system = design.cam.system;
  system.follower.dimensions = dimensions;
  system.start = starting_place(system.follower);
  if (!can_be_assembled(problem, dimensions, system.start)) return std::nullopt;
  if (problem.second.closure == cam::Closure::conjugate) {
    design.second = conjugate_cam(design.cam, problem.second);
  }
  const CamExtremes extremes(design.cam);
  if (!all_satisfied(cam_checks(problem, design, extremes))) return std::nullopt;
  if (problem.follower == cam::FollowerType::translating_flat) return 0;
  return std::abs(extremes.pressure_angle().value);
}

/// A base radius below which the follower does not meet the base circle, or the roller is larger.
double assembly_bound(const CamProblem& problem, const Dimensions& d) {
  const bool slides = !is_oscillating(problem.follower) && !is_flat(problem.follower);
  const double beside = slides ? std::abs(d.offset) : 0;
  const bool swings = has_arm(problem.follower);
  const double between = swings ? std::abs(d.centre_distance - d.arm) : 0;
  return std::max({d.roller_radius, beside, between}) * (1 - kBelowBound);
}

/// A base radius below which limits of the pressure angle, or of a face's curvature, exclude it.
double base_bound(CamProblem& alone, const Dimensions& d, const cam::MotionProgramme& programme) {
  Dimensions values = d;
  for (const auto& [name, dimension] : names<CamDimension>()) {
    CamLength& length = alone.length(dimension);
    if (length.used) length.given = length_of(values, dimension);
  }
  alone.length(CamDimension::base_radius).given.reset();
  if (has_arm(alone.follower)) {
    alone.length(CamDimension::centre_distance).given.reset();
  }
  const auto exact = exact_cam(alone, programme);
  const double least = assembly_bound(alone, d);
  return exact ? std::max(exact->proof.base_radius_least * (1 - kBelowBound), least) : least;
}

class CamRasterSearch {
 public:
  CamRasterSearch(const CamProblem& problem, const cam::MotionProgramme& programme, const Run& run,
                  const Deadline& deadline)
      : problem_(problem), programme_(programme), run_(run), deadline_(deadline) {
    const auto axes = cam_raster_axes(problem);
    combinations_ = combinations_of(problem, axes);
    if (!axes.empty() && axes.front().dimension == CamDimension::base_radius) {
      bases_ = axes.front().values;
    } else {
      const double base = *problem.length(CamDimension::base_radius).given;
      bases_ = synthesis::RasterValues::list({base}, base, base);
    }
    CamDesign still;
    still.cam = cam_of(problem, programme, {});
    of_threads_.assign(static_cast<std::size_t>(thread_count(run.threads)), still);
  }

  CamRasterAnswer run() {
    find_bounds();
    const double each = static_cast<double>(combinations_.size());
    answer_.combinations = static_cast<double>(bases_.count()) * each;
    std::int64_t at = std::max<std::int64_t>(0, bases_.floor(std::ranges::min(bounds_)));
    for (; at < bases_.count() && !is_full(); ++at) {
      if (answer_.evaluated >= kMostTried || deadline_.reached()) break;
      if (!try_base(bases_.at(at))) break;
    }
    answer_.is_complete = at == bases_.count() || is_full();
    answer_.covered = answer_.best.empty() ? static_cast<double>(at) * each : answer_.combinations;
    answer_.is_complete |= !answer_.best.empty();
    return std::move(answer_);
  }

 private:
  bool is_full() const { return std::ssize(answer_.best) >= problem_.solve.designs; }

  void find_bounds() {
    bounds_.assign(combinations_.size(), 0);
    std::vector<CamProblem> alone(of_threads_.size(), problem_);
    parallel_for(static_cast<int>(combinations_.size()), run_.threads, [&](int i, int thread) {
      const auto index = static_cast<std::size_t>(i);
      bounds_[index] =
          base_bound(alone[static_cast<std::size_t>(thread)], combinations_[index], programme_);
    });
  }

  /// Tries every combination that a base radius is not too small for; false where time ran out.
  bool try_base(double base) {
    std::vector<Dimensions> tried;
    for (std::size_t i = 0; i < combinations_.size(); ++i) {
      if (bounds_[i] > base) continue;
      tried.push_back(combinations_[i]);
      tried.back().base_radius = base;
    }
    std::vector<std::optional<double>> pressures(tried.size());
    parallel_for(static_cast<int>(tried.size()), run_.threads, [&](int i, int thread) {
      if (deadline_.reached()) return;
      const auto index = static_cast<std::size_t>(i);
      pressures[index] =
          pressure_if_kept(problem_, of_threads_[static_cast<std::size_t>(thread)], tried[index]);
    });
    if (deadline_.reached()) return false;
    answer_.evaluated += tried.size();
    add_kept(tried, pressures);
    return true;
  }

  void add_kept(const std::vector<Dimensions>& tried,
                const std::vector<std::optional<double>>& pressures) {
    std::vector<std::tuple<double, double, std::size_t>> kept;
    for (std::size_t i = 0; i < tried.size(); ++i) {
      if (pressures[i]) kept.emplace_back(-tried[i].roller_radius, *pressures[i], i);
    }
    std::ranges::sort(kept);
    for (const auto& [roller, pressure, i] : kept) {
      if (!is_full()) answer_.best.push_back(tried[i]);
    }
  }

  const CamProblem& problem_;
  const cam::MotionProgramme& programme_;
  const Run& run_;
  const Deadline& deadline_;
  std::vector<Dimensions> combinations_;
  std::vector<double> bounds_;  ///< of the base radius, one for each combination
  synthesis::RasterValues bases_;
  std::vector<CamDesign> of_threads_;
  CamRasterAnswer answer_;
};

/// The values nearest to `between`.
Dimensions rounded(const CamProblem& problem, Dimensions between) {
  for (const CamRasterAxis& axis : cam_raster_axes(problem)) {
    double& value = length_of(between, axis.dimension);
    value = axis.values.at(axis.values.nearest(value));
  }
  return between;
}

synthesis::RasterPoint point_of(const Dimensions& d) {
  synthesis::RasterPoint point;
  point.objective = d.base_radius;
  return point;
}

std::string coverage_of(const CamRasterAnswer& answer) {
  const double others = answer.combinations - static_cast<double>(answer.evaluated);
  if (!answer.is_complete) {
    return fmt::format(
        "{} of {:.6g} combinations on the raster were tried before the search was ended; bounds, "
        "or a coarser raster, leave fewer.",
        answer.evaluated, answer.combinations);
  }
  if (answer.best.empty()) {
    return fmt::format(
        "None of the {:.6g} combinations on the raster meets every constraint: {} were tried, the "
        "others are excluded by lower bounds of the base radius.",
        answer.combinations, answer.evaluated);
  }
  return fmt::format(
      "No cam on the raster is smaller: of its {:.6g} combinations {} were tried, the other {:.6g} "
      "are larger or excluded by lower bounds of the base radius.",
      answer.combinations, answer.evaluated, others);
}

std::string comparison_of(const synthesis::RasterResult& found) {
  return fmt::format(
      "Base radius on the raster {:.6g}; of the continuous optimum {:.6g}, which rounded has "
      "{:.6g}{}.",
      found.designs.front().objective, found.relaxed->objective, found.rounded->objective,
      found.rounded_is_accepted ? "" : " and breaks a constraint");
}

}  // namespace

std::vector<CamRasterAxis> cam_raster_axes(const CamProblem& problem) {
  std::vector<CamRasterAxis> axes;
  const auto is_free = [&](CamDimension d) {
    return problem.length(d).used && !problem.length(d).given;
  };
  for (const auto& [name, dimension] : names<CamDimension>()) {
    if (dimension == CamDimension::base_radius || !is_free(dimension)) continue;
    axes.push_back(axis_of(problem, dimension, 0));
  }
  if (!is_free(CamDimension::base_radius)) return axes;
  axes.insert(axes.begin(), axis_of(problem, CamDimension::base_radius, base_reach(problem, axes)));
  return axes;
}

double combinations_beside_base(const std::vector<CamRasterAxis>& axes) {
  double all = 1;
  for (const CamRasterAxis& axis : axes) {
    if (axis.dimension != CamDimension::base_radius) {
      all *= static_cast<double>(axis.values.count());
    }
  }
  return all;
}

CamProblem between_raster_values(const CamProblem& problem) {
  CamProblem between = problem;
  for (const CamRasterAxis& axis : cam_raster_axes(problem)) {
    CamLength& length = between.length(axis.dimension);
    length.bounds = {axis.values.at(0), axis.values.at(axis.values.count() - 1)};
    if (axis.values.count() == 1) length.given = length.bounds.min;
  }
  between.raster.reset();
  return between;
}

CamRasterAnswer search_cam_raster(const CamProblem& problem, const cam::MotionProgramme& programme,
                                  const Run& run, const Deadline& deadline) {
  return CamRasterSearch(problem, programme, run, deadline).run();
}

cam::Cam cam_of(const CamProblem& problem, const cam::MotionProgramme& programme,
                const cam::CamDimensions<double>& dimensions) {
  cam::Cam made;
  made.system.follower = {problem.follower, problem.side, dimensions};
  made.system.operation = problem.operation;
  made.system.groove = problem.second.closure == cam::Closure::groove;
  made.system.start = starting_place(made.system.follower);
  made.programme = programme;
  return made;
}

void tell_cam_raster(const CamProblem& problem, const cam::MotionProgramme& programme,
                     const CamRasterAnswer& answer, const CamDesign* between, CamResult& result) {
  synthesis::RasterResult found;
  found.combinations = answer.combinations;
  found.covered = answer.covered;
  found.evaluated = answer.evaluated;
  found.is_complete = found.is_enumerated = answer.is_complete;
  if (between != nullptr) {
    const Dimensions& d = between->cam.system.follower.dimensions;
    const Dimensions near = rounded(problem, d);
    CamDesign design;
    design.cam = cam_of(problem, programme, near);
    found.relaxed = point_of(d);
    found.rounded = point_of(near);
    found.rounded_is_accepted = pressure_if_kept(problem, design, near).has_value();
  }
  for (const Dimensions& d : answer.best) found.designs.push_back(point_of(d));
  if (!answer.best.empty()) found.bound = answer.best.front().base_radius;
  const RasterMeasure measure{[](double base) { return base; }, "size"};
  result.quantities = raster_quantities(found, measure);
  result.notes.push_back(coverage_of(answer));
  if (found.relaxed && !found.designs.empty()) result.notes.push_back(comparison_of(found));
}

}  // namespace cognate::problems
