/// @file What a problem file asks of a cam. Angles are in radians, lengths in the file's unit.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/cam/follower.hpp"
#include "analysis/cam/motion_law.hpp"
#include "analysis/cam/operation.hpp"
#include "problems/basics/kind.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/raster/raster.hpp"
#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {

/// The lengths that a file may give or leave free, in the order of cam::CamDimensions.
enum class CamDimension { base_radius, offset, roller_radius, centre_distance, arm, face_offset };
inline constexpr int kCamDimensions = 6;

/// A length: given, or found within its bounds.
struct CamLength {
  bool used = false;  ///< whether the follower has it
  std::optional<double> given;
  Range bounds{};  ///< sides may be infinite
};

/// What of a motion segment may be a variable of the design: its angle, or the shares of the
/// universal law.
enum class MotionParameter { over, sine, constant, cosine };

/// A number of a segment that the file gives as a range. The segment holds a value within it.
struct FreeMotionParameter {
  std::size_t segment = 0;
  MotionParameter parameter = MotionParameter::over;
  Range range;
};

/// What of a cam is to be least. `size` is the base radius.
enum class CamObjective { size, pressure_angle, contact_force, torque, contact_stress };

/// `[constraints]` of a cam. A rise or a return has its ends, where the follower still stands.
struct CamConstraints {
  /// Of either sign, at every position.
  std::optional<double> pressure_angle_max;
  /// Of either sign, over the rises; over the returns.
  std::optional<double> pressure_angle_max_rise, pressure_angle_max_return;
  /// Only on the side to which the cam pushes in a rise, over the rises; on the other, over the
  /// returns.
  std::optional<double> pressure_angle_max_rise_working, pressure_angle_max_return_working;
  /// Of the profile where it is convex; 0 (no undercut) unless switched off.
  std::optional<double> curvature_radius_min = 0.0;
  std::optional<double> concave_radius_min;  ///< of the profile where it is concave
  std::optional<double> face_width_max;      ///< that a flat face needs
  std::optional<double> profile_radius_min;  ///< least distance of the profile from the centre
  std::optional<double> profile_radius_max;  ///< greatest
  std::optional<double> contact_force_max;
  std::optional<double> torque_max;  ///< of either sense
  std::optional<double> contact_stress_max;
  bool no_separation = true;  ///< force closed, with a preload given: the follower never lifts off
};

/// The follower's second contact where it is form closed.
struct SecondContact {
  cam::Closure closure = cam::Closure::force;
  /// Translating conjugate rollers and parallel faces: distance of the two; empty: that which makes
  /// both cams' base radii equal. Oscillating: the angle between the arms is `arms_angle`.
  std::optional<double> breadth;
  std::optional<double> arms_angle;
};

/// `[contact]`: what `Operation::modulus_sum` is made of, of the cam and of its follower.
struct ContactMaterials {
  std::array<double, 2> elasticity{};  ///< Young's moduli
  std::array<double, 2> poisson{0.3, 0.3};
};

/// `kind = "cam"`.
struct CamProblem {
  std::string title;
  std::optional<LengthUnit> length_unit{};
  cam::FollowerType follower = cam::FollowerType::translating_roller;
  cam::ArmSide side = cam::ArmSide::trailing;
  SecondContact second;
  bool clockwise = false;
  std::vector<cam::MotionSegment> motion;  ///< over one turn, from the base circle and back to it
  std::vector<FreeMotionParameter> free_motion;
  CamLength lengths[kCamDimensions];
  cam::Operation operation;
  bool has_operation = false;  ///< whether forces and torque are known
  bool has_contact = false;    ///< whether contact stress is known
  std::optional<ContactMaterials> materials;
  std::optional<double> preload;  ///< empty: the least that keeps contact
  CamConstraints constraints;
  CamObjective objective = CamObjective::size;
  Solve solve;
  std::optional<Tolerances> tolerances{};
  std::optional<Raster> raster{};  ///< every free length has a value of it

  /// What the file says of one of the lengths.
  const CamLength& length(CamDimension d) const { return lengths[static_cast<int>(d)]; }
  CamLength& length(CamDimension d) { return lengths[static_cast<int>(d)]; }

  /// Whether that length of a cam that is made may be off: a knife edge has no roller, and where a
  /// flat face's line is does not matter.
  bool has_tolerance(CamDimension d) const {
    const bool no_roller = d == CamDimension::roller_radius && is_knife(follower);
    const bool no_line =
        d == CamDimension::offset && follower == cam::FollowerType::translating_flat;
    return length(d).used && !no_roller && !no_line;
  }
};

template <>
struct KindTraits<CamProblem> {
  static constexpr std::string_view kWord = "cam";
  static CamProblem read(reading::TableReader& document, const std::filesystem::path& folder);
  static reading::Written written(const CamProblem& problem);
  static tl::expected<CamProblem, std::vector<std::string>> checked(const CamProblem& problem);
};

template <>
std::span<const Named<cam::FollowerType>> names<cam::FollowerType>();
template <>
std::span<const Named<cam::ArmSide>> names<cam::ArmSide>();
template <>
std::span<const Named<cam::Closure>> names<cam::Closure>();
template <>
std::span<const Named<cam::MotionLaw>> names<cam::MotionLaw>();
template <>
std::span<const Named<CamDimension>> names<CamDimension>();
template <>
std::span<const Named<MotionParameter>> names<MotionParameter>();
template <>
std::span<const Named<CamObjective>> names<CamObjective>();

}  // namespace cognate::problems
