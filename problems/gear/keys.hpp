/// @file The keys of gears that hold one number or one truth.
#pragma once

#include "problems/gear/rules.hpp"
#include "problems/toml/keys.hpp"

namespace cognate::problems::reading {

/// `[rack]`.
inline constexpr Key<gear::BasicRack> kRackKeys[] = {
    {"pressure_angle_deg", "of the rack that cuts, of the normal section (default 20)",
     &gear::BasicRack::pressure_angle, kRackAngle},
    {"addendum", "below the pitch line, in modules (default 1)", &gear::BasicRack::addendum,
     kRackAddendum},
    {"clearance", "by how much its rounded tip is deeper, in modules (default 0.25)",
     &gear::BasicRack::clearance, kRackClearance},
    {"tip_radius",
     "of the tip's corners, in modules (default clearance/(1 - sin a), or less: the full round)",
     &gear::BasicRack::corner_radius, kRackTipRadius}};

/// `[constraints]` of a pair, of the mesh, which is not known of worms.
inline constexpr Key<GearConstraints> kMeshKeys[] = {
    {"contact_ratio_min", "1 (default) or more; of helical gears with the overlap",
     &GearConstraints::contact_ratio_min, kContactRatio},
    {"no_interference", "true (default): no tip digs into the fillet or root of the other gear",
     &GearConstraints::no_interference},
    {"hunting", "true: the numbers of teeth have no common divisor (default false)",
     &GearConstraints::hunting},
    {"sliding_max", "of the magnitude of specific sliding at the ends of the flanks",
     &GearConstraints::sliding_max, kSliding},
    {"tip_clearance_min", "from each tip to the other root, in modules (default 0)",
     &GearConstraints::tip_clearance_min, kModules}};

/// The same of each gear.
inline constexpr Key<GearConstraints> kToothKeys[] = {
    {"tip_thickness_min", "of each gear, in modules, across helical teeth (default 0)",
     &GearConstraints::tip_thickness_min, kModules},
    {"no_undercut", "true (default)", &GearConstraints::no_undercut}};

}  // namespace cognate::problems::reading
