#include "app/drawing/mechanism_poses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::app {
namespace {

/// The drive coordinates of the samples, increasing.
std::vector<double> drive_samples(const AssemblyRanges& assembly_ranges, int count) {
  const auto [low, high] = std::minmax(assembly_ranges.start, assembly_ranges.end);
  std::vector<double> samples;
  for (int i = 0; i < count; ++i) samples.push_back(std::lerp(low, high, i / (count - 1.0)));
  const double step = (high - low) / (count - 1);
  for (const AssemblyRange& run : assembly_ranges.runs) {
    constexpr double kShares[] = {0, 0.01, 0.05, 0.2, 0.5};
    for (const double share : kShares) {
      const double way = share * std::min(step, run.to - run.from);
      if (run.from_dyad >= 0) samples.push_back(run.from + way);
      if (run.to_dyad >= 0) samples.push_back(run.to - way);
    }
  }
  std::ranges::sort(samples);
  const auto [first, last] = std::ranges::unique(samples);
  samples.erase(first, last);
  return samples;
}

/// `angle` plus whole turns, nearest to the last number in `before`.
double continued(double angle, const std::vector<double>& before) {
  for (auto last = before.rbegin(); last != before.rend(); ++last) {
    if (std::isfinite(*last)) return angle + kTurn * std::round((*last - angle) / kTurn);
  }
  return angle;
}

void append(const BodyMotion<double, 0>& body, BodyTrack& track) {
  const auto& [x, y] = body.origin[0];
  const double angle = std::atan2(body.direction.y, body.direction.x);
  const bool known = std::isfinite(x) && std::isfinite(y) && std::isfinite(angle);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  track.x.push_back(known ? x : kNone);
  track.y.push_back(known ? y : kNone);
  track.angle.push_back(known ? continued(angle, track.angle) : kNone);
}

}  // namespace

Vec2d place(const BodyTrack& body, std::size_t k, const Vec2d& at) {
  const Vec2d direction{std::cos(body.angle[k]), std::sin(body.angle[k])};
  return Vec2d{body.x[k], body.y[k]} + direction * at;
}

MechanismPoses sample_poses(const Mechanism<double>& mechanism, double start, double end,
                            int count) {
  FollowedMotion<0> motion(mechanism, follow(mechanism, start, end));
  MechanismMotion<0> alone(mechanism);
  const auto driven = static_cast<std::size_t>(first_body(mechanism, 0));
  MechanismPoses poses;
  poses.drive = drive_samples(motion.assembly_ranges(), count);
  poses.bodies.resize(motion.bodies().size());
  for (const double drive : poses.drive) {
    const bool closes = motion.move_to(drive);
    if (!closes) alone.move_to(drive);
    for (std::size_t i = 0; i < poses.bodies.size(); ++i) {
      const bool placed_alone = !closes && i < driven;
      append(placed_alone ? alone.bodies()[i] : motion.bodies()[i], poses.bodies[i]);
    }
  }
  return poses;
}

}  // namespace cognate::app
