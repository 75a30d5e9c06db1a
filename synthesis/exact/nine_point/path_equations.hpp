/// @file The equations of a four-bar through points and poses, for every complex number type.
///
/// In isotropic coordinates, the reference position of the coupler point being the origin: a dyad
/// has its moving pivot at x and its fixed pivot at a; where the coupler has turned by t and its
/// point has moved by d, the moving pivot is at x t + d, and the link keeps its length if
///
///     f = u v − (x − a)(x̄ − ā) = 0,  u = x t + d − a,  v = x̄/t + d̄ − ā.
///
/// The barred letters are the conjugates of the plain ones in a real linkage, and independent
/// unknowns here (Wampler, Morgan & Sommese, J. Mech. Des. 114, 1992, in other letters). Two dyads
/// share the rotations, which stay in the equations: eliminating them gives polynomials of degree 7
/// and costs half the digits.
#pragma once

namespace cognate::synthesis {

/// A dyad: its moving pivot at the reference and its fixed pivot, with their conjugates.
template <class C>
struct Dyad {
  C moving, moving_bar, fixed, fixed_bar;
};

/// How the coupler got to a position: its rotation t with 1/t, its displacement d with its
/// conjugate.
template <class C>
struct CouplerMove {
  C t, inverse_t, d, d_bar;
};

/// f and its partial derivatives; `log_t` is t ∂f/∂t.
template <class C>
struct DyadEquation {
  C value, moving, moving_bar, fixed, fixed_bar, log_t, d, d_bar;
};

template <class C>
DyadEquation<C> dyad_equation(const Dyad<C>& dyad, const CouplerMove<C>& to) {
  const C link = dyad.moving - dyad.fixed, link_bar = dyad.moving_bar - dyad.fixed_bar;
  const C turned = dyad.moving * to.t, turned_bar = dyad.moving_bar * to.inverse_t;
  const C u = turned + (to.d - dyad.fixed), v = turned_bar + (to.d_bar - dyad.fixed_bar);
  DyadEquation<C> f;
  f.value = u * v - link * link_bar;
  f.moving = to.t * v - link_bar;
  f.moving_bar = to.inverse_t * u - link;
  f.fixed = link_bar - v;
  f.fixed_bar = link - u;
  f.log_t = turned * v - turned_bar * u;
  f.d = v;
  f.d_bar = u;
  return f;
}

}  // namespace cognate::synthesis
