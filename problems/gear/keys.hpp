/// @file The keys of gears that hold one number or one truth.
#pragma once

#include "problems/gear/rules.hpp"
#include "problems/toml/keys.hpp"

namespace cognate::problems::reading {

/// `[rack]`.
inline constexpr Key<gear::BasicRack> kRackKeys[] = {
    key<&gear::BasicRack::pressure_angle>(
        "pressure_angle_deg", "of the rack that cuts, of the normal section (default 20)",
        kRackAngle),
    key<&gear::BasicRack::addendum>("addendum", "below the pitch line, in modules (default 1)",
                                    kRackAddendum),
    key<&gear::BasicRack::clearance>(
        "clearance", "by how much its rounded tip is deeper, in modules (default 0.25)",
        kRackClearance),
    key<&gear::BasicRack::corner_radius>(
        "tip_radius",
        "of the tip's corners, in modules (default clearance/(1 - sin a), or less: the full round)",
        kRackTipRadius)};

/// `[constraints]` of a pair, of the mesh, which is not known of worms.
inline constexpr Key<GearConstraints> kMeshKeys[] = {
    key<&GearConstraints::contact_ratio_min>(
        "contact_ratio_min", "1 (default) or more; of helical gears with the overlap",
        kContactRatio),
    key<&GearConstraints::no_interference>(
        "no_interference", "true (default): no tip digs into the fillet or root of the other gear"),
    key<&GearConstraints::hunting>(
        "hunting", "true: the numbers of teeth have no common divisor (default false)"),
    key<&GearConstraints::sliding_max>(
        "sliding_max", "of the magnitude of specific sliding at the ends of the flanks", kSliding),
    key<&GearConstraints::tip_clearance_min>(
        "tip_clearance_min", "from each tip to the other root, in modules (default 0)", kModules)};

/// The same of each gear.
inline constexpr Key<GearConstraints> kToothKeys[] = {
    key<&GearConstraints::tip_thickness_min>(
        "tip_thickness_min", "of each gear, in modules, across helical teeth (default 0)",
        kModules),
    key<&GearConstraints::no_undercut>("no_undercut", "true (default)")};

}  // namespace cognate::problems::reading
