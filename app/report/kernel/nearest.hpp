/// @file Where on its way a linkage comes nearest to its targets.
#pragma once

#include <optional>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/motion.hpp"

namespace cognate::page {

/// A point that the coupler point is to pass, or a pose that the coupler is to take: then `weight`
/// is the length that one radian counts as, and `angle` that of the coupler, B→C, from the x axis.
struct Target {
  Vec2d at;
  double angle = 0;
  double weight = 0;
};

/// |P − at|² + weight²·(φ − angle)² with the crank at `crank`, φ − angle in [−π, π]; infinite where
/// the linkage does not close or has no coupler point.
double miss(const Motion& motion, const Target& target, double crank);

/// The crank angle at which `miss` has the local minimum that is downhill from `start`; `start`
/// itself where it is infinite there.
double nearest_from(const Motion& motion, const Target& target, double start);

/// The crank angle at which `miss` is least over all ranges of the crank, downhill from its least
/// value among 360 in each; empty where it is infinite at all.
std::optional<double> nearest(const FourBar& linkage, const Motion& motion, const Target& target);

}  // namespace cognate::page
