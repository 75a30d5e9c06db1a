/// @file The dyads that guide a body from the frame: two turning joints, or one and a slide.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "synthesis/exact/motion/pose.hpp"

namespace cognate::synthesis {

/// The two joints of a dyad, from the frame to the body.
///
///     rr  a link: a point of the body stays on a circle about a fixed pivot
///     pr  a slider on the frame: a point of the body stays on a straight line (fixed pivot at
///         infinity)
///     rp  a block that turns about a fixed pivot and slides on the body: a straight line of the
///         body passes through the fixed pivot (moving pivot at infinity)
enum class DyadKind { rr, pr, rp };

/// A dyad that guides a body through poses, in the unit of these.
struct GuidingDyad {
  DyadKind kind = DyadKind::rr;
  Vec2d in_body;          ///< rr, pr: moving pivot; rp: the point of the body's line that lies at
                          ///< the fixed pivot at the first pose. Body axes
  Vec2d moving;           ///< `in_body` at the first pose, in the fixed frame
  Vec2d fixed;            ///< rr, rp: fixed pivot; pr: `moving`, a point of the slide line
  Vec2d direction{1, 0};  ///< pr: unit vector of the slide line, in the fixed frame; rp: of the
                          ///< body's line, in body axes
  double length = 0;      ///< rr: of the link, the mean over the poses
  double residual = 0;    ///< see guidance_residual
  double condition = 1;   ///< of the normalised equations that were solved: relative errors of the
                          ///< poses come back at most so much larger in the pivots
};

/// The greatest distance of the body's origin at a pose from that at the first.
double extent(std::span<const Pose> poses);

/// How far `dyad` is from guiding the body through `poses`: the greatest difference from the first
/// pose of the pivots' distance (rr), of the moving pivot's distance from the slide line (pr), or
/// of the fixed pivot's from the body's line (rp). Relative to the extent of the poses; where that
/// is 0 to the dyad's length, and absolute where both are. Computed from displacements, so that
/// links much longer than the extent cost no digits.
double guidance_residual(const GuidingDyad& dyad, std::span<const Pose> poses);

/// Dyads by their pivots, all else filled in for `poses` (at least one).
GuidingDyad rr_dyad(std::span<const Pose> poses, const Vec2d& in_body, const Vec2d& fixed);
/// `direction`: unit vector of the slide line, in the fixed frame.
GuidingDyad pr_dyad(std::span<const Pose> poses, const Vec2d& in_body, const Vec2d& direction);
/// `direction`: unit vector of the body's line, in body axes.
GuidingDyad rp_dyad(std::span<const Pose> poses, const Vec2d& fixed, const Vec2d& direction);

/// How a search for dyads ended.
enum class GuidanceStatus {
  found,             ///< these are all the dyads
  none,              ///< no real dyad does it
  out_of_reach,      ///< a link of the requested length is too short
  coincident_poses,  ///< two of the poses are one: a condition is missing
  pivot_at_rest,     ///< the pivot given is a pole: it does not move, and any partner will do
  same_line,         ///< the locus of the partner is the very line given: all its points will do
  translation,       ///< no pose is turned against another: a moving pivot and its fixed pivot may
                     ///< be moved together anywhere
  rotation,          ///< all poses are turns about one point: a pin there
  family,            ///< infinitely many dyads; those given are examples
  not_finite,        ///< a number of the input is not finite
};

/// One sentence for a user.
std::string_view sentence(GuidanceStatus status);

/// At most six dyads, and why they are what they are. Dyads may be there with any status: then they
/// do guide the body, and the status says what is special.
struct DyadSolutions {
  GuidanceStatus status = GuidanceStatus::none;
  std::array<GuidingDyad, 6> storage{};
  int count = 0;

  /// The dyads found.
  std::span<const GuidingDyad> dyads() const& {
    return std::span(storage).first(static_cast<std::size_t>(count));
  }
  /// A loop over the dyads of a temporary would outlive it.
  std::span<const GuidingDyad> dyads() && = delete;
  void add(const GuidingDyad& dyad) { storage[static_cast<std::size_t>(count++)] = dyad; }
};

}  // namespace cognate::synthesis
