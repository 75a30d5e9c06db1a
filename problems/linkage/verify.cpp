#include "problems/linkage/verify.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "analysis/linkage/change_point.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/linkage/motion_within.hpp"
#include "problems/linkage/linkage_keys.hpp"

namespace cognate::problems {
namespace {

Sequence sequence_of(const MotionKind& motion) {
  if (motion.travel) return Sequence::any;  // a crank that makes its travel meets them in order
  if (motion.timed) return Sequence::timed;
  return motion.order == PointOrder::any ? Sequence::any : Sequence::one_sense;
}

/// The part of the crank's range that the motion runs over, from A→D; empty where there is none.
std::optional<CrankRange> range_of_motion(const FourBar& linkage,
                                          std::span<const CrankPosition> positions,
                                          const MotionKind& motion) {
  if (motion.travel) {
    const double frame = frame_angle(linkage);
    return motion_within(crank_ranges(lengths(linkage)),
                         {motion.travel->from - frame, motion.travel->to - frame});
  }
  std::vector<double> angles;
  for (const CrankPosition& position : positions) angles.push_back(position.crank_angle);
  return range_between(linkage, angles);
}

TransmissionAngles angles_over(const Lengths<double>& links, const std::optional<CrankRange>& range,
                               bool travels) {
  // A change point on the way leaves the motion undetermined: no full turn is used through it.
  const bool turns = crank_rotates(links) && (!travels || !is_change_point(links));
  return turns || !range ? transmission_angles(links) : transmission_angles(links, *range);
}

}  // namespace

Metrics design_metrics(const FourBar& linkage, std::span<const CrankPosition> positions,
                       const MotionKind& motion) {
  const Lengths<double> links = lengths(linkage);
  Defects defects = find_defects(linkage, positions, sequence_of(motion));
  auto range = range_of_motion(linkage, positions, motion);
  if (motion.travel && !range) defects.circuit = true;
  if (defects.circuit || defects.branch) range.reset();
  const TransmissionAngles angles = angles_over(links, range, motion.travel.has_value());
  Metrics metrics;
  metrics.mobility = mobility_class(links);
  metrics.change_point = is_change_point(links);
  if (metrics.change_point) {
    const CrankPosition at =
        positions.empty() ? CrankPosition{0, linkage.assembly} : positions.front();
    FourBar standing = linkage;
    standing.assembly = at.side;
    metrics.quantities.push_back(
        quantity(kChangePointKindKey, std::string(change_point_kind(standing, at.crank_angle))));
  }
  metrics.transmission_min = angles.min;
  metrics.transmission_max = angles.max;
  metrics.transmission_acute_min = angles.acute_min;
  metrics.time_ratio = time_ratio(links);
  if (defects.circuit) metrics.defects.push_back(Defect::circuit);
  if (defects.branch) metrics.defects.push_back(Defect::branch);
  if (defects.order) metrics.defects.push_back(Defect::order);
  return metrics;
}

Metrics design_metrics(const FourBar& linkage, std::span<const double> crank_angles,
                       const MotionKind& motion) {
  std::vector<CrankPosition> positions;
  for (const double angle : crank_angles) positions.push_back({angle, linkage.assembly});
  return design_metrics(linkage, std::span<const CrankPosition>(positions), motion);
}

TargetError path_error(const FourBar& linkage, std::span<const Vec2d> points,
                       std::span<const double> crank_angles) {
  assert(points.size() == crank_angles.size());
  const Motion motion(linkage);
  TargetError error;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto pose = motion.at(crank_angles[i]);
    if (!pose || !pose->coupler_point) {
      constexpr double infinite = std::numeric_limits<double>::infinity();
      return {infinite, infinite, infinite};
    }
    const Vec2d miss = *pose->coupler_point - points[i];
    error.sum_of_squares += squared_norm(miss);
    error.max = std::max(error.max, std::hypot(miss.x, miss.y));
  }
  if (!points.empty()) error.rms = std::sqrt(error.sum_of_squares / double(points.size()));
  return error;
}

}  // namespace cognate::problems
