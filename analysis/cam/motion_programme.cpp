#include "analysis/cam/motion_programme.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/cam/piece_bounds.hpp"
#include "analysis/cam/stroke_parts.hpp"

namespace cognate::cam {
namespace {

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
