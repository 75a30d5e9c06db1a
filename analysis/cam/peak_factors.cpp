#include <algorithm>
#include <cmath>

#include "analysis/cam/extremes.hpp"
#include "analysis/cam/motion_law.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::cam {
namespace {

using Derivative = double FollowerMotion<double>::*;
constexpr std::array<Derivative, 4> kDerivatives{
    &FollowerMotion<double>::displacement, &FollowerMotion<double>::velocity,
    &FollowerMotion<double>::acceleration, &FollowerMotion<double>::jerk};

/// Least and greatest values of the derivative `order` over all pieces.
Extremes extremes_of(const std::vector<MotionPiece<double>>& pieces, std::size_t order) {
  const auto value = [&](const MotionPiece<double>& piece, double t) {
    return motion_at(piece, t).*kDerivatives[order];
  };
  double scale = 0;
  for (const auto& piece : pieces) {
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      scale = std::max(scale, std::abs(value(piece, t)));
    }
  }
  Extremes all{{0, value(pieces.front(), 0)}, {0, value(pieces.front(), 0)}};
  for (const auto& piece : pieces) {
    const auto [least, greatest] = extremes([&](double t) { return value(piece, t); }, 0, 1, scale);
    if (least.value < all.least.value) all.least = least;
    if (greatest.value > all.greatest.value) all.greatest = greatest;
  }
  return all;
}

double peak(const Extremes& extremes) {
  return std::max(std::abs(extremes.least.value), std::abs(extremes.greatest.value));
}

/// Whether the derivative `order` of pieces with the peak `greatest` jumps inside the segment.
bool has_jump(const std::vector<MotionPiece<double>>& pieces, std::size_t order, double greatest) {
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const double before = motion_at(pieces[i - 1], 1.0).*kDerivatives[order];
    const double after = motion_at(pieces[i], 0.0).*kDerivatives[order];
    if (std::abs(after - before) > 1e-9 * greatest) return true;
  }
  return false;
}

}  // namespace

PeakFactors peak_factors(const MotionSegment& segment) {
  std::vector<MotionPiece<double>> pieces;
  if (!append_pieces(segment, 0, 0, 0, pieces)) return {};
  const Extremes displacement = extremes_of(pieces, 0);
  const double rise = segment.rise != 0 ? std::abs(segment.rise)
                                        : displacement.greatest.value - displacement.least.value;
  if (!(rise > 0)) return {};
  const double velocity = peak(extremes_of(pieces, 1)), acceleration = peak(extremes_of(pieces, 2)),
               jerk = peak(extremes_of(pieces, 3));
  const bool velocity_jumps = has_jump(pieces, 1, velocity);
  const bool acceleration_jumps = velocity_jumps || has_jump(pieces, 2, acceleration);
  const double over = segment.over;
  return {velocity * over / rise, velocity_jumps ? kInfinity : acceleration * over * over / rise,
          acceleration_jumps ? kInfinity : jerk * over * over * over / rise};
}

}  // namespace cognate::cam
