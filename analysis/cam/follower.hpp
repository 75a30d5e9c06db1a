/// @file Cam followers and their dimensions.
#pragma once

namespace cognate::cam {

/// What touches the cam, and how it is guided.
enum class FollowerType {
  translating_roller,
  translating_flat,  ///< its face square to its travel
  translating_knife,
  oscillating_roller,
  oscillating_flat,
  oscillating_knife  ///< an edge on a swinging arm
};

/// How an oscillating follower's arm lies to the motion of the cam's surface below it: `trailing`,
/// drawn along from its pivot to the contact, or `leading`, pushed against.
enum class ArmSide { trailing, leading };

/// What presses follower and cam together.
enum class Closure {
  force,            ///< a spring or a weight
  groove,           ///< the roller runs between two walls of one cam
  conjugate,        ///< a second cam on the shaft drives a second roller of the follower
  constant_breadth  ///< two parallel faces of one follower touch the cam on both sides
};

/// Whether the follower swings about a pivot.
constexpr bool is_oscillating(FollowerType type) {
  return type == FollowerType::oscillating_roller || type == FollowerType::oscillating_flat ||
         type == FollowerType::oscillating_knife;
}

/// Whether an arm carries a roller or a knife edge about a pivot.
constexpr bool has_arm(FollowerType type) {
  return type == FollowerType::oscillating_roller || type == FollowerType::oscillating_knife;
}

/// Whether an edge touches the cam: a roller of radius 0, whose pitch curve is the profile.
constexpr bool is_knife(FollowerType type) {
  return type == FollowerType::translating_knife || type == FollowerType::oscillating_knife;
}

/// Whether a flat face touches the cam.
constexpr bool is_flat(FollowerType type) {
  return type == FollowerType::translating_flat || type == FollowerType::oscillating_flat;
}

/// +1 where the arm trails, −1 where it leads.
constexpr int sign_of(ArmSide side) {
  return side == ArmSide::trailing ? 1 : -1;
}

/// Lengths of a cam and its follower; those that the follower has no use for are 0.
template <class T>
struct CamDimensions {
  /// Least distance of the cam's centre from the roller's centre, of a flat face from the face.
  T base_radius{};
  /// Of a translating follower's line from the cam's centre; positive where it lowers the pressure
  /// angle of the rise.
  T offset{};
  T roller_radius{};    ///< 0: a knife edge
  T centre_distance{};  ///< of an oscillating follower's pivot from the cam's centre
  T arm{};              ///< from that pivot to the roller's centre or the edge
  T face_offset{};      ///< by how much a swinging face lies nearer to the cam than its pivot
};

/// A follower on its cam. Of the two senses of rotation the kernel knows one: the cam turns
/// counter-clockwise; a cam that turns the other way is its mirror image.
template <class T>
struct CamFollower {
  FollowerType type = FollowerType::translating_roller;
  ArmSide side = ArmSide::trailing;
  CamDimensions<T> dimensions{};
};

}  // namespace cognate::cam
