#include "app/report/cam_names.hpp"

namespace cognate::app {

std::string law_title(cam::MotionLaw law) {
  switch (law) {
    case cam::MotionLaw::dwell:
      return "dwell";
    case cam::MotionLaw::constant_velocity:
      return "constant velocity";
    case cam::MotionLaw::constant_acceleration:
      return "constant acceleration";
    case cam::MotionLaw::harmonic:
      return "harmonic";
    case cam::MotionLaw::cycloidal:
      return "cycloidal";
    case cam::MotionLaw::polynomial_345:
      return "3-4-5 polynomial";
    case cam::MotionLaw::polynomial_4567:
      return "4-5-6-7 polynomial";
    case cam::MotionLaw::modified_sine:
      return "modified sine";
    case cam::MotionLaw::modified_trapezoid:
      return "modified trapezoid";
    case cam::MotionLaw::modified_constant_velocity:
      return "modified constant velocity";
    case cam::MotionLaw::double_harmonic:
      return "double harmonic";
    case cam::MotionLaw::universal:
      return "universal";
    case cam::MotionLaw::polynomial:
      return "polynomial";
    case cam::MotionLaw::spline:
      return "spline";
  }
  return {};
}

std::string follower_title(cam::FollowerType type) {
  switch (type) {
    case cam::FollowerType::translating_roller:
      return "translating roller";
    case cam::FollowerType::translating_flat:
      return "translating flat face";
    case cam::FollowerType::translating_knife:
      return "translating knife edge";
    case cam::FollowerType::oscillating_roller:
      return "oscillating roller";
    case cam::FollowerType::oscillating_flat:
      return "oscillating flat face";
  }
  return {};
}

std::string closure_title(cam::Closure closure) {
  switch (closure) {
    case cam::Closure::force:
      return "force";
    case cam::Closure::groove:
      return "groove";
    case cam::Closure::conjugate:
      return "conjugate";
    case cam::Closure::constant_breadth:
      return "constant breadth";
  }
  return {};
}

std::string stroke_title(cam::Stroke stroke) {
  switch (stroke) {
    case cam::Stroke::rise:
      return "rise";
    case cam::Stroke::fall:
      return "return";
    case cam::Stroke::dwell:
      return "dwell";
  }
  return {};
}

}  // namespace cognate::app
