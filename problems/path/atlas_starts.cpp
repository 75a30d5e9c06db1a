#include "problems/path/atlas_starts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/coupler_curve/circuit_samples.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/path/curve/closed_curve.hpp"

namespace cognate::problems {
namespace {

constexpr int kPoints = 64;            ///< of the target, with which curves are compared
constexpr int kCurveBeginnings = 512;  ///< of a curve
constexpr std::size_t kSteps = 256;    ///< of the crank
constexpr int kDescriptorPoints = 256;

Vec2d centre_of(std::span<const Vec2d> points) {
  Vec2d sum{};
  for (const Vec2d& point : points) sum = sum + point;
  return (1 / static_cast<double>(points.size())) * sum;
}

/// p → shift + factor·p, `factor` turning and enlarging.
struct Turning {
  Vec2d factor{1, 0};
  Vec2d shift;
  double error = std::numeric_limits<double>::infinity();

  Vec2d operator()(const Vec2d& p) const { return shift + factor * p; }
};

/// What brings `points` in order nearest to `target`: least squares in complex numbers.
Turning turning_onto(std::span<const Vec2d> target, std::span<const Vec2d> points) {
  const Vec2d to = centre_of(target), from = centre_of(points);
  Vec2d product{};
  double square = 0, target_square = 0;
  for (std::size_t i = 0; i < target.size(); ++i) {
    const Vec2d p = points[i] - from, t = target[i] - to;
    product = product + t * conj(p);
    square += squared_norm(p);
    target_square += squared_norm(t);
  }
  if (!(square > 0)) return {};
  const Vec2d factor = (1 / square) * product;
  return {factor, to - factor * from, target_square - squared_norm(product) / square};
}

/// `points` are many times those of the target, so that one of them is near where that begins.
Turning best_turning(std::span<const Vec2d> target, std::span<const Vec2d> points) {
  Turning best;
  std::vector<Vec2d> some(target.size());
  const std::size_t count = points.size(), stride = count / target.size();
  for (std::size_t first = 0; first < count; ++first) {
    for (const std::size_t step : {stride, count - stride}) {
      for (std::size_t i = 0; i < some.size(); ++i) some[i] = points[(first + i * step) % count];
      const Turning found = turning_onto(target, some);
      if (found.error < best.error) best = found;
    }
  }
  return best;
}

FourBar mirrored(FourBar linkage) {
  linkage.pivot_a = conj(linkage.pivot_a);
  linkage.pivot_d = conj(linkage.pivot_d);
  linkage.assembly = linkage.assembly == Assembly::open ? Assembly::crossed : Assembly::open;
  linkage.coupler_point = conj(*linkage.coupler_point);
  return linkage;
}

FourBar moved(FourBar linkage, const Turning& turning) {
  const double scale = norm(turning.factor);
  linkage.pivot_a = turning(linkage.pivot_a);
  linkage.pivot_d = turning(linkage.pivot_d);
  for (double* const length : {&linkage.crank, &linkage.coupler, &linkage.rocker}) {
    *length *= scale;
  }
  linkage.coupler_point = scale * *linkage.coupler_point;
  return linkage;
}

std::vector<Vec2d> curve_points(const FourBar& linkage) {
  CurveRoom curve;
  sample_circuit(linkage, {linkage.assembly, 1}, CycleTable(kSteps), curve);
  std::vector<Vec2d> points(kSteps);
  for (std::size_t i = 0; i < kSteps; ++i) points[i] = {curve.x[i], curve.y[i]};
  return points;
}

/// The crank's angle, from the x axis, where the curve is nearest to each of `targets`.
std::vector<double> crank_angles_at(const FourBar& linkage, std::span<const Vec2d> targets) {
  const std::vector<Vec2d> points = curve_points(linkage);
  const double frame = frame_angle(linkage);
  std::vector<double> angles;
  for (const Vec2d& target : targets) {
    const auto distance = [&](const Vec2d& point) { return squared_norm(point - target); };
    const auto step = std::ranges::min_element(points, {}, distance) - points.begin();
    const double angle = kTurn * static_cast<double>(step) / kSteps;
    angles.push_back(in_one_turn(frame + angle));
  }
  return angles;
}

}  // namespace

CurvePose place_on_target(const PathProblem& problem, const FourBar& linkage) {
  const std::vector<Vec2d> target = problem.curve->curve.equally_spaced(kPoints);
  CurvePose best{linkage, {}, std::numeric_limits<double>::infinity()};
  for (const FourBar& image : {linkage, mirrored(linkage)}) {
    const ClosedCurve curve(curve_points(image));
    const Turning turning = best_turning(target, curve.equally_spaced(kCurveBeginnings));
    if (turning.error < best.error) best = {moved(image, turning), {}, turning.error};
  }
  best.crank_angles = crank_angles_at(best.linkage, problem.points);
  return best;
}

std::vector<Design> atlas_starts(const PathProblem& problem, std::span<const AtlasCurve> atlas,
                                 std::size_t most) {
  const ClosedCurve& target = problem.curve->curve;
  const FourierDescriptors wanted =
      descriptors_of(target.equally_spaced(kDescriptorPoints), target.length());
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < atlas.size(); ++i) {
    order.emplace_back(squared_distance(wanted, atlas[i].descriptors), i);
  }
  const std::size_t count = std::min(most, order.size());
  std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(count));
  std::vector<CurvePose> placed;
  for (std::size_t i = 0; i < count; ++i) {
    placed.push_back(place_on_target(problem, atlas[order[i].second].linkage));
  }
  std::ranges::stable_sort(placed, {}, &CurvePose::error);
  std::vector<Design> starts;
  for (CurvePose& curve : placed) {
    Design design;
    design.mechanism = named(curve.linkage);
    design.crank_angles = std::move(curve.crank_angles);
    starts.push_back(std::move(design));
  }
  return starts;
}

}  // namespace cognate::problems
