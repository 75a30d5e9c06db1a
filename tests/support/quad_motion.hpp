/// @file A mechanism evaluated with 113 bits: the reference for what dimensions alone settle.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "analysis/mechanism/convert.hpp"
#include "analysis/mechanism/kinematics.hpp"

namespace cognate::test {

using Quad = boost::multiprecision::cpp_bin_float_quad;

inline Vec2<Quad> quad(const Vec2d& v) {
  return {Quad(v.x), Quad(v.y)};
}

inline double angle_between(const Vec2<Quad>& a, const Vec2<Quad>& b) {
  return static_cast<double>(atan2(cross(a, b), dot(a, b)));
}

/// The unit vector of `direction` to 113 bits, so that no rounding of it is mistaken for an error.
inline Vec2<Quad> unit(const Vec2d& direction) {
  const Vec2<Quad> v = quad(direction);
  return (Quad(1) / sqrt(squared_norm(v))) * v;
}

/// The difference of two angles, less whole turns.
inline double turn(double from, double to) {
  return std::remainder(to - from, 2 * std::acos(-1.0));
}

inline Vec2d random_direction(std::mt19937_64& random) {
  const double angle = std::uniform_real_distribution<double>(-3.0, 3.0)(random);
  return {std::cos(angle), std::sin(angle)};
}

inline Vec2d random_point(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  return {place(random), place(random)};
}

/// Bodies with first and second derivatives at a drive angle counted from `reference`; empty where
/// a dyad does not close.
class QuadMotion {
 public:
  explicit QuadMotion(const Mechanism<double>& mechanism, const Vec2d& reference = {1, 0})
      : mechanism_(cognate::convert<Quad>(mechanism)), reference_(unit(reference)) {
    for (const double side : cognate::sides(mechanism)) sides_.emplace_back(side);
    bodies_.resize(static_cast<std::size_t>(body_count(mechanism)));
    closures_.resize(mechanism.dyads.size());
  }

  using Bodies = std::vector<BodyMotion<Quad, 2>>;

  std::optional<Bodies> at(const Quad& q) {
    const DrivePosition<Quad> drive{reference_ * Vec2<Quad>{cos(q), sin(q)}, Quad(0)};
    evaluate<2, Quad>(mechanism_, drive, sides_, bodies_, closures_);
    for (const auto& closure : closures_) {
      if (!(closure.discriminant >= 0)) return std::nullopt;
    }
    return bodies_;
  }

 private:
  Mechanism<Quad> mechanism_;
  Vec2<Quad> reference_;
  std::vector<Quad> sides_;
  Bodies bodies_;
  std::vector<DyadClosure<Quad>> closures_;
};

}  // namespace cognate::test
