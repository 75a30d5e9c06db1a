/// @file Proof that roots are true, real and distinct.
///
/// With an approximate inverse Y of the Jacobian at z, T(w) = w − Y F(w) maps the polydisc of radii
/// r σᵢ about z into its own inside and contracts it if
///
///     ‖Y F(z)‖ + r κ < r,  κ ≥ ‖I − Y F′(w)‖ < 1 for every w of the polydisc,
///
/// in the maximum norm weighted by 1/σᵢ: it then holds exactly one zero of F, a simple one (R.
/// Krawczyk, Computing 4, 1969; S. M. Rump, Acta Numerica 19, 2010, § 13; for what certificates are
/// good for J. D. Hauenstein & F. Sottile, "alphaCertified", ACM TOMS 38, 2012, who use Smale's α
/// instead). F(z) is evaluated with 113 bits and the Jacobian over the whole polydisc in double, or
/// with 113 bits as well where that does not suffice, all by balls that contain every rounding
/// error, so that what is certified is a theorem on the PathSystem as it stands: its displacements
/// as the doubles they are, their bars the conjugates.
///
/// Conjugation carries zeros of real data into zeros. Where it carries the zero into the polydisc
/// in which there is but one, the zero is its own conjugate: a linkage of the real plane.
#pragma once

#include <array>
#include <complex>
#include <span>
#include <vector>

#include "synthesis/exact/nine_point/nine_point.hpp"
#include "synthesis/exact/nine_point/side_condition.hpp"

namespace cognate::synthesis {

/// What is proved of a root. All numbers are relative: of an unknown z they mean so much times
/// 1 + |z|.
struct RootCertificate {
  bool certified = false;    ///< there is a true root within `radius` of `refined`
  bool real = false;         ///< and it is real
  double radius = 0;         ///< the true root is no farther than this from `refined`
  double distance = 0;       ///< and no farther than this from the root that was to be proved
  double unique_within = 0;  ///< and there is no other within this of `refined`
  PathRoot refined;          ///< corrected with 113 bits and rounded to double
};

/// Corrects `root` by Newton's method and proves it. A root farther off than the polydisc of
/// uniqueness and than a thousand roundings times its condition is refused, though it may lead to a
/// true one. `conditions`: equations beside the positions; with
/// them there are as many unknowns as equations, and bars are again the conjugates.
RootCertificate certify(const PathSystem& system, const PathRoot& root,
                        std::span<const SideCondition> conditions = {});

/// Which solutions are one and the same design.
enum class RootSymmetry {
  none,
  swapped_dyads,  ///< two solutions, which of the dyads is the first
  cognates,       ///< six: Roberts' three cognates, each with its dyads swapped
};

/// The pairs of certified roots that are not proved to be distinct designs: none of the invariants
/// of the symmetry separates their balls. Indices i < k into `roots`.
std::vector<std::array<int, 2>> overlapping(std::span<const RootCertificate> roots,
                                            RootSymmetry symmetry);

/// The number of certified roots that are proved to be distinct from one another: each group of
/// overlapping ones counts once.
int count_distinct(std::span<const RootCertificate> roots, RootSymmetry symmetry);

}  // namespace cognate::synthesis
