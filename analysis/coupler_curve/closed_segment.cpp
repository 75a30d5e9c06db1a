#include "analysis/coupler_curve/closed_segment.hpp"

#include <algorithm>
#include <cstddef>

#include "analysis/numbers/constants.hpp"

namespace cognate {
namespace {

/// Where the longest of the samples' segments may end beside that of the curve, in steps.
constexpr std::size_t kNear = 2;

/// The cubic with the values p0, p1 and the derivatives d0, d1 at the ends of [0, 1].
struct Cubic {
  Vec2d p0, d0, p1, d1;

  Vec2d operator()(double t) const {
    const Vec2d rise = p1 - p0;
    return p0 + t * (d0 + t * (3 * rise - 2 * d0 - d1 + t * (d0 + d1 - 2 * rise)));
  }
};

}  // namespace

double ClosedSegmentFinder::operator()(const CurveSamples& curve, double relative) {
  lay_out(curve);
  const std::size_t count = curve.size();
  const SampledSegment rough = segments_.longest(points_, true, relative);
  const std::size_t found = std::max<std::size_t>(rough.to - rough.from, 1);
  const std::size_t cells = std::min(found + 2 * kNear, count - 1);
  constexpr std::size_t kFinePoints = 64;
  const std::size_t pieces = std::max<std::size_t>(kFinePoints / cells, 2);
  refine(curve, (rough.from + count - kNear) % count, cells, pieces);
  SegmentLimits limits;
  if (found > 2 * kNear) limits.least_cells = (found - 2 * kNear) * pieces;
  return segments_.longest(fine_, false, relative, limits).length;
}

void ClosedSegmentFinder::lay_out(const CurveSamples& curve) {
  points_.resize(curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) points_[i] = {curve.x[i], curve.y[i]};
}

void ClosedSegmentFinder::refine(const CurveSamples& curve, std::size_t first, std::size_t cells,
                                 std::size_t pieces) {
  const std::size_t count = curve.size();
  const double step = kTurn / static_cast<double>(count);
  const auto rate = [&](std::size_t i) { return step * Vec2d{curve.dx[i], curve.dy[i]}; };
  fine_.clear();
  for (std::size_t k = 0; k < cells; ++k) {
    const std::size_t i = (first + k) % count, next = (i + 1) % count;
    const Cubic cubic{points_[i], rate(i), points_[next], rate(next)};
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      fine_.push_back(cubic(static_cast<double>(piece) / static_cast<double>(pieces)));
    }
  }
  fine_.push_back(points_[(first + cells) % count]);
}

}  // namespace cognate
