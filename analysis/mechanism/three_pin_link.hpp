/// @file All assemblies of the simplest group of class III: a link with three pins, each held by a
/// leg.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "analysis/mechanism/attached.hpp"
#include "analysis/mechanism/group.hpp"

namespace cognate {

/// Pins of the link, which is body `body`, in its own axes, the pivots of their legs where these
/// stand, and the legs' lengths.
struct ThreePinLink {
  int body = 0;
  std::array<Vec2d, 3> pins;
  std::array<Vec2d, 3> pivots;
  std::array<double, 3> legs{};
};

/// Where the link may stand, six places at most, by ascending angle in (−π, π]. Two that meet but
/// for rounding are one, or none.
///
/// With u = e^{iφ} and the first pin and pivot as origins, p from there to the link's first pin,
/// a_k = u b_k − O_k and r_k = (l_k² − l₁² − |a_k|²)/2 the circles of legs 2 and 3 are p·a_k = r_k,
/// linear in p; what is left of the first, |r₂a₃ − r₃a₂|² = l₁² (a₂ × a₃)², is a trigonometric
/// polynomial of degree 3 in φ (Gosselin, Sefrioui & Richard 1992), so that its values at seven
/// angles give a polynomial of degree 6 in u, and that its roots (Aberth 1973). Centred and scaled,
/// so that places and sizes do not matter.
std::vector<Placement> assemblies(const ThreePinLink& link);

/// `group`, whose first body is `first`, with the bodies before it as in `bodies`; empty where it
/// is another group.
std::optional<ThreePinLink> as_three_pin_link(const Group& group, int first,
                                              std::span<const Placement> bodies);

}  // namespace cognate
