/// @file The keys of cams that hold one number.
#pragma once

#include "problems/cam/problem.hpp"
#include "problems/cam/rules.hpp"
#include "problems/toml/keys.hpp"

namespace cognate::problems::reading {

/// `[constraints]`, of the pressure angle.
inline constexpr Key<CamConstraints> kPressureAngleKeys[] = {
    {"pressure_angle_deg_max", "of either sign, everywhere", &CamConstraints::pressure_angle_max,
     kPressureLimit},
    {"pressure_angle_deg_max_rise", "of either sign, in the rises, their ends included",
     &CamConstraints::pressure_angle_max_rise, kPressureLimit},
    {"pressure_angle_deg_max_return", "of either sign, in the returns, their ends included",
     &CamConstraints::pressure_angle_max_return, kPressureLimit},
    {"pressure_angle_deg_max_rise_working",
     "in the rises, only on the side to which the cam pushes",
     &CamConstraints::pressure_angle_max_rise_working, kPressureLimit},
    {"pressure_angle_deg_max_return_working", "in the returns, only on the other side",
     &CamConstraints::pressure_angle_max_return_working, kPressureLimit}};

inline constexpr std::string_view kConcave = "concave_radius_min", kFace = "face_width_max",
                                  kLeast = "profile_radius_min", kGreatest = "profile_radius_max",
                                  kForce = "contact_force_max", kTorque = "torque_max",
                                  kStress = "contact_stress_max";

/// `[constraints]`, of the profile besides undercut and of the forces.
inline constexpr Key<CamConstraints> kProfileKeys[] = {
    {kConcave, "of the profile where it is concave (not flat faces)",
     &CamConstraints::concave_radius_min, kLinkLength},
    {kFace, "flat faces", &CamConstraints::face_width_max, kLinkLength},
    {kLeast, "of the profile from the cam's centre", &CamConstraints::profile_radius_min,
     kLinkLength},
    {kGreatest, "of the profile from the cam's centre", &CamConstraints::profile_radius_max,
     kLinkLength},
    {kForce, "with masses, spring or load; not of rollers of constant breadth",
     &CamConstraints::contact_force_max, kPositive},
    {kTorque, "that drives the cam, of either sense; with masses, spring or load",
     &CamConstraints::torque_max, kPositive},
    {kStress, "with [contact] besides; not with constant breadth",
     &CamConstraints::contact_stress_max, kPositive}};

}  // namespace cognate::problems::reading
