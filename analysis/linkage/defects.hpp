/// @file Whether a linkage, driven by its crank, can pass through its positions as it should.
///
/// The configurations of a four-bar form one closed curve or two: its circuits. Positions on two
/// circuits are reached only by taking the linkage apart. A circuit through which the crank cannot
/// drive (its crank does not turn fully) consists of two branches, joined at dead points where
/// coupler and rocker are collinear: (D − B) × (C − B) is positive on one and negative on the
/// other. Chase & Mirth, "Circuits and branches of single-degree-of-freedom planar linkages", 1993.
#pragma once

#include <optional>
#include <span>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"

namespace cognate {

/// A configuration: the crank angle from the x axis and the side of B→D on which C lies.
struct CrankPosition {
  double crank_angle = 0;
  Assembly side = Assembly::open;
};

/// In which order positions are to be met.
enum class Sequence {
  any,        ///< in any order
  one_sense,  ///< in the order given, in one sense of the drive
  timed,      ///< in the order given, the crank turning from each to the next by the shorter way
};

/// What keeps a linkage from passing through its positions.
struct Defects {
  bool circuit = false;  ///< not all on one circuit, or one where the linkage does not close
  bool branch = false;   ///< the sign of (D − B) × (C − B) changes
  bool order = false;    ///< judged on one circuit alone: without it there is no motion

  /// Whether both have the same.
  friend bool operator==(const Defects&, const Defects&) = default;
};

/// The defects of `linkage` at the crank angles given, from the x axis, in its own assembly.
///
/// `one_sense`: a crank that turns fully may start anywhere in its cycle, and the last position may
/// repeat the first; one that does not must move monotonically. `timed` cannot fail for a crank
/// that turns fully; any other must not be asked to cross where the linkage does not close.
///
/// Crank angles closer than 1e-7 rad count as equal, and as much is allowed beyond a dead point.
Defects find_defects(const FourBar& linkage, std::span<const double> crank_angles,
                     Sequence sequence);

/// As above for positions each with its own side, regardless of `linkage.assembly`. Where a circuit
/// has positions on both branches `one_sense` means once round the circuit at most.
Defects find_defects(const FourBar& linkage, std::span<const CrankPosition> positions,
                     Sequence sequence);

/// The range of the crank, counted from A→D, from the first to the last of the angles it takes;
/// empty where they are not all in one range in which the linkage closes.
std::optional<CrankRange> range_between(const FourBar& linkage,
                                        std::span<const double> crank_angles);

/// The position in which the joints stand: crank angle from `b`, side from (D − B) × (C − B).
CrankPosition position_of(const FourBar& linkage, const Vec2d& b, const Vec2d& c);

}  // namespace cognate
