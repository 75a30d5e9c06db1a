/// @file A mechanism's masses and loads reduced to its drive.
#pragma once

#include <span>

#include "analysis/machine/machine.hpp"
#include "analysis/mechanism/forces.hpp"
#include "analysis/mechanism/motion_state.hpp"

namespace cognate::machine {

/// J = Σ m v′² + J_S φ′² and dJ/dφ = 2 Σ (m v′·v″ + J_S φ′ φ″), with primes the derivatives by the
/// drive's coordinate: the slope from accelerations, not from differences (Li & Xu 2011, 6.2).
/// `inertias`: one for each body, or none where no body has mass; the frame's is not used.
EquivalentInertia equivalent_inertia(std::span<const BodyMotion<double, 2>> bodies,
                                     std::span<const Inertia> inertias);

/// Σ m g·v′ of the weights.
double weight_torque(std::span<const BodyMotion<double, 2>> bodies,
                     std::span<const Inertia> inertias, const Vec2d& gravity);

/// Σ F·v′ + M φ′ of the loads.
double load_torque(std::span<const BodyMotion<double, 2>> bodies, std::span<const Load> loads);

}  // namespace cognate::machine
