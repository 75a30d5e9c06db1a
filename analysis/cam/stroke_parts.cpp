#include "analysis/cam/stroke_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/cam/extremes.hpp"
#include "analysis/cam/piece_bounds.hpp"

namespace cognate::cam {
namespace {

double size_of(const Bounds& bounds) {
  return std::max(std::abs(bounds.least), std::abs(bounds.greatest));
}

/// The parts of a piece whose velocity has zeros at the shares `cuts`. A part that moves no further
/// than rounding (of a zero found twice, or of one at an end) joins its neighbour.
void append_cut(const MotionPiece<double>& piece, int index, std::vector<double> cuts,
                std::vector<StrokePart>& parts) {
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * size_of(bounds_of(piece, 0));
  cuts.push_back(1);
  const std::size_t first = parts.size();
  double from = 0, before = motion_at(piece, 0.0).displacement;
  for (const double to : cuts) {
    const double here = motion_at(piece, to).displacement, step = here - before;
    if (std::abs(step) > rounding) {
      const Stroke stroke = step > 0 ? Stroke::rise : Stroke::fall;
      if (parts.size() > first && parts.back().stroke == stroke) {
        parts.back().to = to;
      } else {
        parts.push_back({index, from, to, stroke});
      }
      from = to;
      before = here;
    }
  }
  if (parts.size() == first) parts.push_back({index, 0, 1, Stroke::dwell});
  parts.back().to = 1;
}

}  // namespace

std::vector<StrokePart> stroke_parts_of(const std::vector<MotionPiece<double>>& pieces) {
  std::vector<Bounds> velocities;
  velocities.reserve(pieces.size());
  double greatest = 0;
  for (const auto& piece : pieces) {
    velocities.push_back(bounds_of(piece, 1));
    greatest = std::max(greatest, size_of(velocities.back()));
  }
  const double rest = 1e-13 * greatest;
  std::vector<StrokePart> parts;
  parts.reserve(pieces.size());
  std::vector<double> cuts;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Bounds& velocity = velocities[i];
    const auto index = static_cast<int>(i);
    if (size_of(velocity) <= rest) {
      parts.push_back({index, 0, 1, Stroke::dwell});
    } else if (velocity.least >= -rest) {
      parts.push_back({index, 0, 1, Stroke::rise});
    } else if (velocity.greatest <= rest) {
      parts.push_back({index, 0, 1, Stroke::fall});
    } else {
      cuts.clear();
      zeros([&](double t) { return motion_at(pieces[i], t).velocity; }, 0, 1, greatest, cuts);
      append_cut(pieces[i], index, cuts, parts);
    }
  }
  return parts;
}

}  // namespace cognate::cam
