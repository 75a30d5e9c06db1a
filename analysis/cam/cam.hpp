/// @file A cam with its follower and the follower's motion.
#pragma once

#include "analysis/cam/motion_programme.hpp"
#include "analysis/cam/quantity.hpp"

namespace cognate::cam {

/// Follower and dimensions, and the motion over a turn of the cam.
struct Cam {
  CamSystem<double> system;
  MotionProgramme programme;
};

}  // namespace cognate::cam
