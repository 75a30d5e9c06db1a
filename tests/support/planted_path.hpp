/// @file Positions of the coupler that are known to be those of a four-bar.
#pragma once

#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/nine_point/nine_point.hpp"

<<<<<<< HEAD
namespace cognate::planting {
=======
namespace cognate::test {
>>>>>>> 4d5ca09

/// A four-bar and crank angles from the x axis, in order.
struct PlantedPath {
  FourBar linkage;
  std::vector<double> crank_angles;
};

/// A crank-rocker of about unit size met `count` times over `share` of a turn.
inline PlantedPath random_crank_rocker(std::mt19937_64& random, int count, double share) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  PlantedPath planted;
  FourBar& four_bar = planted.linkage;
  four_bar.pivot_a = {uniform(-1, 1), uniform(-1, 1)};
  const double direction = uniform(0, kTurn);
  const double frame = uniform(1.5, 2);
  four_bar.pivot_d = four_bar.pivot_a + frame * Vec2d{std::cos(direction), std::sin(direction)};
  four_bar.crank = uniform(0.4, 0.7);
  four_bar.coupler = uniform(1.5, 2.2);
  four_bar.rocker = uniform(1.3, 2);
  four_bar.assembly = uniform(0, 1) < 0.5 ? Assembly::open : Assembly::crossed;
  four_bar.coupler_point = Vec2d{uniform(-1, 2), uniform(0.3, 1.5)};
  const double from = uniform(0, kTurn);
  for (int j = 0; j < count; ++j) {
    planted.crank_angles.push_back(from + share * kTurn * (j + uniform(-0.2, 0.2)) / count);
  }
  return planted;
}

/// The positions of the coupler point, with the orientation of B→C in the first `oriented`.
inline std::vector<synthesis::PathPose> positions_of(const PlantedPath& planted, int oriented) {
  std::vector<synthesis::PathPose> positions;
  const Motion motion(planted.linkage);
  for (const double angle : planted.crank_angles) {
    const Pose pose = motion.at(angle).value();
    synthesis::PathPose position{pose.coupler_point.value(), {}};
    const Vec2d coupler = pose.c - pose.b;
    if (int(positions.size()) < oriented) position.angle = std::atan2(coupler.y, coupler.x);
    positions.push_back(position);
  }
  return positions;
}

<<<<<<< HEAD
}  // namespace cognate::planting
=======
}  // namespace cognate::test
>>>>>>> 4d5ca09
