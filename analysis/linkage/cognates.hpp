/// @file Roberts' cognates: the two other four-bars whose coupler point traces the same curve.
///
/// With z = (P − B)/(C − B) as a complex number, the three share the pivots A, D and E = A + z(D −
/// A):
///
///     A–D: B − A (crank), C − B (coupler), C − D (rocker)
///     E–D: (1 − z)(B − A) crank, −(1 − z)(C − D) coupler, −(1 − z)(C − B) rocker
///     A–E: z(C − B) crank, z(B − A) coupler, z(C − D) rocker
///
/// so the crank of the second turns with that of the first, and the crank of the third with its
/// coupler. Hartenberg & Denavit, Kinematic Synthesis of Linkages, 1964, chapter 6.
#pragma once

#include <optional>

#include "analysis/linkage/four_bar.hpp"

namespace cognate {

/// The cognate E–D, which keeps the timing: its crank angle counted from E→D is that of `linkage`
/// counted from A→D. Its assembly is the other one throughout, and its own timed cognate is
/// `linkage`. Empty without a coupler point, and where that falls on C (the cognate shrinks to the
/// point D).
std::optional<FourBar> timed_cognate(const FourBar& linkage);

/// A linkage in one of its positions; the crank angle counts from the x axis.
struct CognateAt {
  FourBar linkage;
  double crank_angle = 0;
};

/// The cognate A–E where it stands when the crank of `linkage` is at `crank_angle` (from the x
/// axis). Its crank angle is the angle of `linkage`'s coupler plus arg z. Its assembly is the sign
/// of (B − A) × (C − D), which one motion may change: it passes its dead points there. Applied
/// twice it gives back `linkage`. Empty without a coupler point, where that falls on B (the cognate
/// shrinks to the point A), and where `linkage` does not close.
std::optional<CognateAt> coupler_cognate(const FourBar& linkage, double crank_angle);

/// The same linkage seen from its other end: crank and rocker, A and D change places. `crank_angle`
/// is that of `linkage`; the crank angle returned is that of D→C. Empty where it does not close.
std::optional<CognateAt> from_other_end(const FourBar& linkage, double crank_angle);

}  // namespace cognate
