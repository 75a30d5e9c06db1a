/// @file The keys of cams that hold one number.
#pragma once

#include "problems/cam/problem.hpp"
#include "problems/cam/rules.hpp"
#include "problems/toml/keys.hpp"

namespace cognate::problems::reading {

/// `[constraints]`, of the pressure angle.
inline constexpr Key<CamConstraints> kPressureAngleKeys[] = {
    key<&CamConstraints::pressure_angle_max>("pressure_angle_deg_max", "of either sign, everywhere",
                                             kPressureLimit),
    key<&CamConstraints::pressure_angle_max_rise>(
        "pressure_angle_deg_max_rise", "of either sign, in the rises, their ends included",
        kPressureLimit),
    key<&CamConstraints::pressure_angle_max_return>(
        "pressure_angle_deg_max_return", "of either sign, in the returns, their ends included",
        kPressureLimit),
    key<&CamConstraints::pressure_angle_max_rise_working>(
        "pressure_angle_deg_max_rise_working",
        "in the rises, only on the side to which the cam pushes", kPressureLimit),
    key<&CamConstraints::pressure_angle_max_return_working>(
        "pressure_angle_deg_max_return_working", "in the returns, only on the other side",
        kPressureLimit)};

inline constexpr std::string_view kConcave = "concave_radius_min", kFace = "face_width_max",
                                  kLeast = "profile_radius_min", kGreatest = "profile_radius_max",
                                  kForce = "contact_force_max", kTorque = "torque_max",
                                  kStress = "contact_stress_max";

/// `[constraints]`, of the profile other than undercut, and of the forces.
inline constexpr Key<CamConstraints> kProfileKeys[] = {
    key<&CamConstraints::concave_radius_min>(
        kConcave, "of the profile where it is concave (not flat faces)", kLinkLength),
    key<&CamConstraints::face_width_max>(kFace, "flat faces", kLinkLength),
    key<&CamConstraints::profile_radius_min>(kLeast, "of the profile from the cam's centre",
                                             kLinkLength),
    key<&CamConstraints::profile_radius_max>(kGreatest, "of the profile from the cam's centre",
                                             kLinkLength),
    key<&CamConstraints::contact_force_max>(
        kForce, "with masses, spring or load; not of rollers of constant breadth", kPositive),
    key<&CamConstraints::torque_max>(
        kTorque, "that drives the cam, of either sense; with masses, spring or load", kPositive),
    key<&CamConstraints::contact_stress_max>(
        kStress, "requires [contact]; not with constant breadth", kPositive)};

}  // namespace cognate::problems::reading
