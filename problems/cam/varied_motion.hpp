/// @file A follower's motion whose segments' angles and laws may be variables.
#pragma once

#include <algorithm>
#include <vector>

#include "analysis/cam/motion_law.hpp"
#include "analysis/cam/universal_law.hpp"
#include "problems/cam/model.hpp"
#include "problems/cam/problem.hpp"

namespace cognate::problems {

/// The motion of `problem` as a function of its free parameters, over any number type.
template <class T>
class VariedMotion {
 public:
  /// `parameters` are the values of `problem.free_motion`, one for each.
  VariedMotion(const CamProblem& problem, std::span<const T> parameters) {
    T begin(0);
    double level = 0;
    for (std::size_t i = 0; i < problem.motion.size(); ++i) {
      const cam::MotionSegment& segment = problem.motion[i];
      T over(segment.over);
      cam::UniversalShape<T> shape{T(segment.shape.sine), T(segment.shape.constant),
                                   T(segment.shape.cosine)};
      T* target[] = {&over, &shape.sine, &shape.constant, &shape.cosine};
      for (std::size_t k = 0; k < problem.free_motion.size(); ++k) {
        const FreeMotionParameter& free = problem.free_motion[k];
        if (free.segment == i) *target[static_cast<int>(free.parameter)] = parameters[k];
      }
      first_.push_back(pieces_.size());
      begins_.push_back(begin);
      overs_.push_back(over);
      append(segment, static_cast<int>(i), begin, over, T(level), shape);
      begin = begin + over;
      level += segment.rise;
    }
    first_.push_back(pieces_.size());
  }

  cam::FollowerMotion<T> at(const SegmentPlace& place) const {
    const auto i = static_cast<std::size_t>(place.segment);
    const T angle = begins_[i] + T(place.share) * overs_[i];
    std::size_t piece = first_[i];
    while (piece + 1 < first_[i + 1] && !(angle < pieces_[piece + 1].begin)) ++piece;
    const auto& found = pieces_[piece];
    return motion_at(found, (angle - found.begin) / found.span);
  }

 private:
  void append(const cam::MotionSegment& segment, int index, const T& begin, const T& over,
              const T& level, const cam::UniversalShape<T>& shape) {
    if (segment.law == cam::MotionLaw::universal) {
      cam::append_universal(shape, begin, over, level, T(segment.rise), index, pieces_);
      return;
    }
    // Any other law keeps its form when its angle changes.
    std::vector<cam::MotionPiece<double>> fixed;
    append_pieces(segment, 0, 0, index, fixed);
    for (const auto& piece : fixed) {
      cam::MotionPiece<T> varied;
      varied.begin = begin + T(piece.begin / segment.over) * over;
      varied.span = T(piece.span / segment.over) * over;
      std::ranges::transform(piece.polynomial, varied.polynomial.begin(),
                             [](double c) { return T(c); });
      varied.offset = T(piece.offset) + level;
      varied.scale = T(piece.scale);
      for (std::size_t k = 0; k < piece.sinusoids.size(); ++k) {
        const auto& wave = piece.sinusoids[k];
        varied.sinusoids[k] = {T(wave.amplitude), T(wave.rate), T(wave.phase)};
      }
      varied.terms = piece.terms;
      varied.sinusoid_count = piece.sinusoid_count;
      varied.segment = index;
      pieces_.push_back(varied);
    }
  }

  std::vector<cam::MotionPiece<T>> pieces_;
  std::vector<std::size_t> first_;  ///< piece of each segment, and one past the last
  std::vector<T> begins_, overs_;
};

}  // namespace cognate::problems
