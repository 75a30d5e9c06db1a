/// @file The assembly ranges of a motion: where along its drive a mechanism can be assembled, and
/// how it gets from one position to the next.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "analysis/mechanism/group_track.hpp"
#include "analysis/mechanism/mechanism.hpp"

namespace cognate {

/// What happens at a special position of the drive.
enum class SpecialPositionKind {
  /// A range of the drive ends: the links of a dyad are in line, or a slide stands across.
  dead_point,
  /// Two assemblies of a dyad meet, and the drive goes on. The motion goes on smoothly, which is
  /// with the other sign of the root.
  change_point,
  /// A change point at which the drive does not hold the dyad: its outer points coincide, and it
  /// may turn about them.
  undetermined,
  /// A range ends because two guides are parallel, their crossing at infinity.
  parallel_guides
};

/// A special position: what happens there, and to which dyad.
struct SpecialPosition {
  SpecialPositionKind kind = SpecialPositionKind::dead_point;
  int dyad = 0;
  double drive = 0;  ///< radians, or a length for a driving slider
};

/// Where a dyad passes from one assembly to the other.
struct Change {
  double drive = 0;
  int dyad = 0;
  bool determined = true;
};

/// A range of the drive over which every dyad can be assembled, `from` ≤ `to`. `sides` are the
/// signs of the assemblies at `anchor`; each of the `changes`, in ascending order, flips one.
struct AssemblyRange {
  double from = 0;
  double to = 0;
  double anchor = 0;
  std::vector<double> sides;
  std::vector<Change> changes;
  int from_dyad = -1;  ///< the dyad that ends the range at `from`; −1: the motion starts or ends
  int to_dyad = -1;
  std::vector<std::shared_ptr<const GroupTrack>> tracks;  ///< of its groups, in their order
};

/// The signs of the assemblies at a position in `run`, one for each dyad.
std::vector<double> sides_at(const AssemblyRange& run, double drive);

/// The same, written to `sides`.
void sides_at(const AssemblyRange& run, double drive, std::span<double> sides);

/// The same, but 0 (neither assembly) of a dyad whose dead point ends `run` at `drive`: the root of
/// what rounding leaves there would be half of the digits, in all that moves with the dyad.
void sides_or_none_at(const AssemblyRange& run, double drive, std::span<double> sides);

/// Puts the bodies of the groups of `run` where they stand at `drive` but for a small error, from
/// which `evaluate` closes them.
template <class T, int Order>
void place_groups(const AssemblyRange& run, double drive, std::span<BodyMotion<T, Order>> bodies) {
  for (const auto& track : run.tracks) track->place(drive, bodies);
}

/// Whether the groups of `mechanism` stand with the drive at `at_a` in `a` as at `at_b` in `b`: a
/// crank that comes round may find a group in another assembly, and turn on. Always where there are
/// none.
bool groups_stand_alike(const Mechanism<double>& mechanism, const AssemblyRange& a, double at_a,
                        const AssemblyRange& b, double at_b);

/// The motion from `start` to `end` of the drive (`end` may be the less): with the described
/// assemblies at `start`, and through change points smoothly. Beyond a gap the dyads that could not
/// be assembled in it are as described again; a group has the ranges that hold positions in which
/// it is drawn, one in each turn.
struct AssemblyRanges {
  double start = 0;
  double end = 0;
  double scale = 1;                     ///< of the drive coordinate: 1 rad, or a length
  std::vector<AssemblyRange> runs;      ///< ascending
  std::vector<SpecialPosition> points;  ///< in the order of the motion; `start` and `end` are none

  /// Over how many places of `run` the motion is looked at: 720 in a turn.
  int cells(const AssemblyRange& run) const;

  /// The run that holds `drive`; null where the mechanism cannot be assembled there.
  const AssemblyRange* range_at(double drive) const;
};

/// Follows `mechanism` from `start` to `end`. Ends of ranges are refined to rounding from a change
/// of sign of a dyad's discriminant, change points from one of its derivative. What lies closer
/// together than a 720th of a turn (of the whole path for a driving slider) may be missed, and two
/// ranges count as one that meets in a change point where no more than rounding parts them. The
/// work grows with the square of the number of dyads; once `stop`, which is asked at every place,
/// says so, it ends with ranges that are incomplete.
AssemblyRanges follow(const Mechanism<double>& mechanism, double start, double end,
                      const std::function<bool()>& stop = {});

/// The ranges of a crank or a floating link over a whole turn, as (from, to) with 0 ≤ from < 2π; a
/// range that holds the angle 0 runs beyond 2π. One range (0, 2π) where it turns fully.
struct DriveRange {
  double from = 0;
  double to = 0;
};
std::vector<DriveRange> ranges_over_a_turn(const Mechanism<double>& mechanism);

}  // namespace cognate
