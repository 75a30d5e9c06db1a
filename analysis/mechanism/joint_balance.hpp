/// @file The equilibrium of a mechanism's bodies, solved joint by joint.
///
/// Each body of a dyad gives one equation free of its outer joint: the moment about its outer pin,
/// or the force along its outer guide. The two determine the inner joint; their determinant is the
/// sine of the dyad's transmission angle. So lengths are never weighed against pure numbers, the
/// unit of length does not matter, and precision is lost near dead points alone, as 1/sine. The
/// joints of a group are solved for together, by the transposed matrix of its closure: what closes
/// a joint is also what its force does work on.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/mechanism/forces.hpp"
#include "analysis/mechanism/mechanism.hpp"
#include "analysis/mechanism/motion_state.hpp"

namespace cognate {

/// A force at the origin of a body's axes and a moment about it.
struct Wrench {
  Vec2d force{};
  double moment = 0;
};

/// Where a body stands, and what all its joints (and the drive) must exert on it together.
struct LoadedBody {
  Vec2d direction{1, 0};
  Vec2d origin{};
  Wrench required{};
};

/// Solves for the joints of one mechanism; prepared once, allocates nothing after.
class JointBalance {
 public:
  explicit JointBalance(const Mechanism<double>& mechanism);

  /// To be filled before `solve`; the frame at 0, with nothing required.
  std::span<LoadedBody> bodies() { return bodies_; }

  /// From the last dyad to the drive. `forces` has room for all reactions. False where not all
  /// forces are numbers.
  bool solve(Forces& forces);

  /// How many joints there are.
  std::size_t joints() const;

 private:
  /// Where a dyad's body is joined to a body before it: by a pin at `on` in the axes of that body,
  /// which is the origin of its own; or by a slide through its own origin along its first axis.
  struct OuterJoint {
    std::size_t body = 0;
    bool slides = false;
    Vec2d on{};
  };
  /// The inner joint is a slide through the origin of the first body along its first axis, or a pin
  /// at the distance 1/`by_reach` from the origin of each body that has an outer pin, along its
  /// first axis, and at the origin of one that slides.
  struct DyadJoints {
    bool inner_slides = false;
    std::array<OuterJoint, 2> outer{};
    std::array<double, 2> by_reach{};
  };
  struct DyadJointsOf;
  /// A group, its number among the dyads, and room for the places of its bodies and those before.
  struct GroupJoints {
    Group group;
    std::size_t dyad = 0;
    std::vector<BodyMotion<double, 0>> bodies;
  };

  Reaction inner_reaction(const DyadJoints& dyad, const LoadedBody& first,
                          const LoadedBody& second) const;
  Reaction outer_pin(const OuterJoint& joint, const Vec2d& force);
  Reaction outer_slide(const OuterJoint& joint, const LoadedBody& body, const Vec2d& force,
                       double moment);
  void solve_dyad(const DyadJoints& dyad, const LoadedBody& first, const LoadedBody& second,
                  std::span<Reaction, 3> reactions);
  void solve_group(GroupJoints& group, std::span<Reaction> reactions);
  double solve_drive(const Crank<double>& crank, std::span<Reaction> reactions);
  double solve_drive(const DrivingSlider<double>& slider, std::span<Reaction> reactions);
  double solve_drive(const FloatingLink<double>& link, std::span<Reaction> reactions);
  double solve_drive(const DrivingRod<double>& rod, std::span<Reaction> reactions);

  /// A floating link has its two pins and its two guides.
  std::size_t drive_joints() const { return drive_bodies_ == 3 ? 4 : 1; }

  /// Whether the drive's joints and those of the first dyad are solved together.
  bool drives_cylinder() const { return std::holds_alternative<DrivingRod<double>>(drive_); }

  Drive<double> drive_;
  std::size_t drive_bodies_;
  std::vector<DyadJoints> dyads_;
  std::vector<GroupJoints> groups_;
  std::vector<LoadedBody> bodies_;
};

}  // namespace cognate
