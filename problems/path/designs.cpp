#include "problems/path/designs.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "analysis/linkage/cognates.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/placement.hpp"
#include "problems/linkage/same_design.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/certificate.hpp"
#include "problems/path/crank_sense.hpp"
#include "problems/path/curve_following.hpp"
#include "problems/path/scale.hpp"
#include "problems/path/shape_placement.hpp"

namespace cognate::problems {
namespace {

/// Designs closer than this, relative to their size, are one: no use is made of a thousandth.
constexpr double kSameWithin = 1e-3;

}  // namespace

double rms_of(const PathProblem& problem, double sum_of_squares) {
  const auto& weights = problem.weights;
  const double total = weights.empty() ? static_cast<double>(problem.points.size())
                                       : std::accumulate(weights.begin(), weights.end(), 0.0);
  return std::sqrt(sum_of_squares / total);
}

ErrorMeasure error_measure(const PathProblem& /*problem*/) {
  return ErrorMeasure::rms_length;
}

double error_of(const PathProblem& problem, const Design& design) {
  return rms_of(problem, path_objective(problem, design));
}

double met_error(const PathProblem& problem) {
  return kMetError * PathScale(problem).size;
}

PathDesigns::PathDesigns(const PathProblem& problem, double size)
    : problem_(problem), exact_below_(kMetExactly * size * size) {}

void PathDesigns::add(const FourBar& linkage, const std::vector<double>& crank_angles,
                      std::string origin) {
  origin_ = std::move(origin);
  if (!add_one(linkage, crank_angles)) return;
  const auto cognate = timed_cognate(linkage);
  if (!cognate) return;
  const double turned = frame_angle(*cognate) - frame_angle(linkage);
  const bool from_x_axis =
      problem_.timing != Timing::free && problem_.crank_reference == CrankReference::global;
  const double whole_turn = kTurn;
  if (from_x_axis && std::abs(std::remainder(turned, whole_turn)) > kCheckTolerance) return;
  std::vector<double> angles = crank_angles;
  for (double& angle : angles) angle = in_one_turn(angle + turned);
  Design design = verified(*cognate, angles);
  if (all_satisfied(design.constraints)) insert(std::move(design));
}

void PathDesigns::add_alone(const FourBar& linkage, const std::vector<double>& crank_angles) {
  origin_ = "raster";
  add_one(linkage, crank_angles);
}

std::optional<Design> PathDesigns::accepted(const FourBar& linkage,
                                            const std::vector<double>& crank_angles) const {
  Design design = verified(linkage, crank_angles);
  const bool is_met =
      std::isfinite(design.error.sum_of_squares) && all_satisfied(design.constraints);
  return is_met ? std::optional(std::move(design)) : std::nullopt;
}

void PathDesigns::sort() {
  std::ranges::stable_sort(feasible_, {},
                           [this](const Design& design) { return objective(design); });
}

std::vector<Design> PathDesigns::better_but_violating() const {
  double least = kInfinity;
  for (const Design& design : feasible_) least = std::min(least, objective(design));
  std::vector<Design> better;
  std::ranges::copy_if(violating_, std::back_inserter(better),
                       [&](const Design& design) { return objective(design) < least; });
  std::ranges::stable_sort(better, {}, [this](const Design& one) { return objective(one); });
  return better;
}

std::vector<Design> PathDesigns::take() {
  const auto wanted = static_cast<std::size_t>(problem_.solve.designs);
  std::vector<Design> all = std::move(feasible_.empty() ? violating_ : feasible_);
  const auto exact = std::stable_partition(all.begin(), all.end(), [&](const Design& design) {
    return design.error.sum_of_squares <= exact_below_;
  });
  std::stable_sort(all.begin(), exact, [](const Design& a, const Design& b) {
    return a.metrics.transmission_acute_min > b.metrics.transmission_acute_min;
  });
  if (all.size() > wanted) all.resize(wanted);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i && !all[i].cognate_of; ++k) {
      if (is_cognate(four_bar(all[k]), four_bar(all[i]), kSameWithin)) {
        all[i].cognate_of = static_cast<int>(k);
      }
    }
  }
  return all;
}

double PathDesigns::objective(const Design& design) const {
  return path_objective(problem_, design);
}

/// `linkage` as it was found, where the target is.
Design PathDesigns::verified(const FourBar& linkage,
                             const std::vector<double>& crank_angles) const {
  Design design = is_movable(problem_) ? moved(linkage, crank_angles)
                                       : verified(linkage, problem_.points, crank_angles);
  if (problem_.curve) judge_following(design);
  return design;
}

/// With the target moved to where the file's lengths and pivots want it.
Design PathDesigns::moved(const FourBar& linkage, const std::vector<double>& crank_angles) const {
  const CurvePlacement placement = placement_of(problem_, linkage);
  std::vector<Vec2d> targets;
  for (const Vec2d& point : problem_.points) targets.push_back(placement.point(point));
  std::vector<double> angles = crank_angles;
  for (double& angle : angles) angle = in_one_turn(angle + placement.turn);
  Design design = verified(placed(problem_, linkage, placement), targets, angles);
  design.error = path_error(linkage, problem_.points, crank_angles);
  design.placement = placement;
  design.metrics.quantities = quantities(placement);
  return design;
}

void PathDesigns::judge_following(Design& design) const {
  const ClosedCurve& curve = problem_.curve->curve;
  const double deviation =
      curve_deviation(curve, four_bar(design), design.placement.value_or(CurvePlacement{}));
  design.metrics.quantities.push_back({"curve_deviation_max", deviation});
  if (!problem_.constraints.no_extra_loop) return;
  design.constraints.push_back(check_extra_loop(curve, deviation, design.error.max));
}

Design PathDesigns::verified(const FourBar& linkage, std::span<const Vec2d> targets,
                             const std::vector<double>& crank_angles) const {
  Design design;
  design.mechanism = named(linkage);
  design.crank_angles = crank_angles;
  design.error = path_error(linkage, targets, crank_angles);
  design.metrics = design_metrics(linkage, crank_angles,
                                  {problem_.order, problem_.timing == Timing::prescribed});
  add_cycle_metrics(problem_.constraints, linkage, CycleOutput::coupler_point, design.metrics);
  design.constraints = check_constraints(problem_.constraints, problem_.bounds, problem_.given,
                                         linkage, design.metrics);
  if (problem_.crank_sense != CrankSense::either && leaves_sense_open(problem_)) {
    design.constraints.push_back(check_sense(problem_.crank_sense, crank_angles));
  }
  check_error(problem_, design);
  design.origin = origin_;
  return design;
}

bool PathDesigns::add_one(const FourBar& linkage, const std::vector<double>& crank_angles) {
  return insert(verified(linkage, crank_angles));
}

/// Keeps the design in its list unless an equal one is there, or it does not close at a point: so
/// may a cognate near a dead point, where rounding decides.
bool PathDesigns::insert(Design design) {
  if (!std::isfinite(design.error.sum_of_squares)) return false;
  auto& list = all_satisfied(design.constraints) ? feasible_ : violating_;
  for (const Design& known : list) {
    if (same_design(four_bar(known), four_bar(design), kSameWithin)) return false;
  }
  list.push_back(std::move(design));
  return true;
}

}  // namespace cognate::problems
