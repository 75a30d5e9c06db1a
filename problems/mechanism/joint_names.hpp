/// @file The names of a mechanism's joints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/mechanism/joints.hpp"
#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::problems {

/// One name for each joint of joints(mechanism). A turning joint has that of the point named there,
/// on whichever of the bodies that it connects; without one, and for a sliding joint, the names of
/// its two bodies: "block-bar".
std::vector<std::string> joint_names(const NamedMechanism& mechanism);

/// The names of the turning joints, each once.
std::vector<std::string> pin_names(const NamedMechanism& mechanism);

/// A moving body on which both points are fixed, a pin being fixed on every body that it joins;
/// empty where there is none.
std::optional<int> common_body(const Mechanism<double>& mechanism, const Attached<double>& a,
                               const Attached<double>& b);

/// One name for each dyad: of RRR that of its inner joint, else of its second body (the slider, the
/// bar); in each place of a group that of its body with the most joints.
std::vector<std::string> dyad_names(const NamedMechanism& mechanism);

}  // namespace cognate::problems
