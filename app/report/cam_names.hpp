/// @file What the page of a cam calls things.
#pragma once

#include <string>

#include "analysis/cam/follower.hpp"
#include "analysis/cam/motion_law.hpp"
#include "analysis/cam/motion_programme.hpp"

namespace cognate::app {

std::string law_title(cam::MotionLaw law);             ///< "3-4-5 polynomial"
std::string follower_title(cam::FollowerType type);    ///< "translating roller"
std::string closure_title(cam::Closure closure);       ///< "constant breadth"
std::string stroke_title(cam::Stroke stroke);          ///< "rise"

}  // namespace cognate::app
