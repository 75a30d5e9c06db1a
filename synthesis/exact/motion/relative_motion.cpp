#include "synthesis/exact/motion/relative_motion.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "synthesis/exact/motion/five_poses.hpp"

namespace cognate::synthesis {
namespace {

/// Times the condition of a dyad, and the frame: what a pivot may be off its centre by rounding.
constexpr double kPoleRounding = 64 * std::numeric_limits<double>::epsilon();

Pose crank_pose(const AnglePair& pair, double frame) {
  const Vec2d output = unit_vector(pair.output);
  return {-frame * conj(output), pair.input - pair.output};
}

}  // namespace

std::vector<Pose> crank_seen_from_rocker(std::span<const AnglePair> pairs, double frame) {
  std::vector<Pose> poses;
  poses.reserve(pairs.size());
  for (const AnglePair& pair : pairs) poses.push_back(crank_pose(pair, frame));
  return poses;
}

std::optional<FunctionLinkage> function_linkage(const GuidingDyad& coupler, double frame) {
  if (coupler.kind != DyadKind::rr) return std::nullopt;
  const double crank = norm(coupler.in_body), rocker = norm(coupler.fixed);
  const double nothing = kPoleRounding * coupler.condition * frame;
  if (!(crank > nothing) || !(rocker > nothing) || !(coupler.length > nothing)) return std::nullopt;
  return FunctionLinkage{{crank, coupler.length, rocker, frame},
                         std::atan2(coupler.in_body.y, coupler.in_body.x),
                         std::atan2(coupler.fixed.y, coupler.fixed.x)};
}

std::vector<FunctionLinkage> function_linkages(std::span<const AnglePair, 5> pairs, double frame) {
  std::array<Pose, 5> poses;
  for (std::size_t j = 0; j < poses.size(); ++j) poses[j] = crank_pose(pairs[j], frame);
  std::vector<FunctionLinkage> linkages;
  const DyadSolutions couplers = dyads_of_five_poses(poses);
  for (const GuidingDyad& dyad : couplers.dyads()) {
    if (const auto linkage = function_linkage(dyad, frame)) linkages.push_back(*linkage);
  }
  return linkages;
}

}  // namespace cognate::synthesis
