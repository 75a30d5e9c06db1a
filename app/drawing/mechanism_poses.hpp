/// @file The motion of any mechanism, sampled for drawing.
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/mechanism/mechanism.hpp"

namespace cognate::app {

/// Where the axes of a body stand at each sample: origin, and angle of the first axis from the x
/// axis in radians, continuous from sample to sample. NaN where the body cannot be placed.
struct BodyTrack {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> angle;
};

struct MechanismPoses {
  std::vector<double> drive;      ///< drive coordinates, increasing
  std::vector<BodyTrack> bodies;  ///< the frame first

  std::size_t size() const { return drive.size(); }
};

/// A body's point at sample `k`.
Vec2d place(const BodyTrack& body, std::size_t k, const Vec2d& at);

/// `count` ≥ 2 samples of the motion from `start` to `end`, both included, in equal steps, followed
/// through change points. The ends of the ranges in which the mechanism can be assembled are
/// further samples, with more of them on the way there, where it moves as the square root of the
/// drive. Where it cannot be assembled only the drive is placed.
MechanismPoses sample_poses(const Mechanism<double>& mechanism, double start, double end,
                            int count);

}  // namespace cognate::app
