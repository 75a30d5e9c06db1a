#include "analysis/cam/motion_programme.hpp"

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

/// The parts of `pieces` in order, cut where the velocity changes its sign. Velocities below 1e-13
/// of the greatest are rest.
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

/// `angle` less whole turns, in [0, 2π).
double in_turn(double angle) {
  const double turn = 2 * pi_of<double>();
  const double rest = std::fmod(angle, turn);
  const double positive = rest < 0 ? rest + turn : rest;
  return positive < turn ? positive : 0;
}

std::array<double, 3> first_derivatives(const MotionPiece<double>& piece, double t) {
  const auto motion = motion_at(piece, t);
  return {motion.displacement, motion.velocity, motion.acceleration};
}

}  // namespace

MotionProgramme::MotionProgramme(std::vector<MotionPiece<double>> pieces)
    : pieces_(std::move(pieces)), parts_(stroke_parts_of(pieces_)) {
  begins_.reserve(pieces_.size());
  for (const auto& piece : pieces_) begins_.push_back(piece.begin);
  for (const StrokePart& part : parts_) {  // no extremes inside: the follower does not turn back
    const auto& piece = pieces_[static_cast<std::size_t>(part.piece)];
    for (const double t : {part.from, part.to}) {
      const double displacement = motion_at(piece, t).displacement;
      lowest_ = std::min(lowest_, displacement);
      highest_ = std::max(highest_, displacement);
    }
  }
}

FollowerMotion<double> MotionProgramme::at(double angle) const {
  if (pieces_.empty()) return {};
  const double here = in_turn(angle);
  const auto next = std::upper_bound(begins_.begin() + 1, begins_.end(), here);
  const auto& piece = pieces_[static_cast<std::size_t>(next - begins_.begin()) - 1];
  return motion_at(piece, std::clamp((here - piece.begin) / piece.span, 0.0, 1.0));
}

std::optional<MotionProgramme> programme_of(const std::vector<MotionSegment>& segments) {
  std::vector<MotionPiece<double>> pieces;
  double begin = 0, start = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!append_pieces(segments[i], begin, start, static_cast<int>(i), pieces)) return std::nullopt;
    begin += segments[i].over;
    start += segments[i].rise;
  }
  return MotionProgramme(std::move(pieces));
}

std::vector<Jump> jumps(const MotionProgramme& programme) {
  const auto& pieces = programme.pieces();
  std::vector<Jump> found;
  if (pieces.empty()) return found;
  std::array<double, 3> least_jump{};
  for (const auto& piece : pieces) {
    for (std::size_t order = 0; order < 3; ++order) {
      const Bounds bounds = bounds_of(piece, static_cast<int>(order));
      least_jump[order] = std::max(
          {least_jump[order], 1e-9 * std::abs(bounds.least), 1e-9 * std::abs(bounds.greatest)});
    }
  }
  auto before = first_derivatives(pieces.back(), 1);
  for (const auto& piece : pieces) {
    const auto after = first_derivatives(piece, 0);
    for (std::size_t order = 0; order < 3; ++order) {
      if (std::abs(after[order] - before[order]) > least_jump[order]) {
        found.push_back({piece.begin, static_cast<int>(order), before[order], after[order]});
      }
    }
    before = first_derivatives(piece, 1);
  }
  return found;
}

}  // namespace cognate::cam
