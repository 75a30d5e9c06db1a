/// @file The places of a group of bodies along a range of the drive, followed from where it is
/// drawn.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "analysis/mechanism/attached.hpp"
#include "analysis/mechanism/mechanism.hpp"
#include "analysis/mechanism/motion_state.hpp"

namespace cognate {

struct AssemblyRange;

/// Positions of a group from one end of a range to the other, so close together that between them
/// a cubic is near enough for Newton's method to find the group's own position, and no other.
class GroupTrack {
 public:
  /// Bodies at a position of the drive. At an end where their rates are infinite the places between
  /// it and its neighbour go with the root of the distance.
  struct Node {
    double drive = 0;
    std::vector<BodyMotion<double, 1>> bodies;
    bool is_dead = false;
  };

  /// A position of the group on the other side of its dead point.
  struct Beyond {
    double drive = 0;
    std::vector<Placement> bodies;
  };
  /// At the lesser and the greater end, where these are dead points of the group.
  using BothBeyond = std::array<std::optional<Beyond>, 2>;

  /// `first`: the number of the group's first body; `nodes` in ascending order.
  GroupTrack(std::size_t first, std::vector<Node> nodes, BothBeyond beyond)
      : first_(first), nodes_(std::move(nodes)), beyond_(std::move(beyond)) {}

  double from() const { return nodes_.front().drive; }
  double to() const { return nodes_.back().drive; }
  const BothBeyond& beyond() const { return beyond_; }

  /// Writes the places of the group's bodies at `drive` to all `bodies` of the mechanism.
  template <class T, int Order>
  void place(double drive, std::span<BodyMotion<T, Order>> bodies) const {
    for (std::size_t i = 0; i < nodes_.front().bodies.size(); ++i) {
      const auto [origin, direction] = placement(drive, i);
      bodies[first_ + i].origin[0] = {T(origin.x), T(origin.y)};
      bodies[first_ + i].direction = {T(direction.x), T(direction.y)};
    }
  }

 private:
  Placement placement(double drive, std::size_t body) const;

  std::size_t first_;
  std::vector<Node> nodes_;
  BothBeyond beyond_;
};

/// A mechanism whose dyads before a group are assembled along `run`, and the scale of its drive.
struct TrackedRun {
  const Mechanism<double>& mechanism;
  const AssemblyRange& run;
  double scale = 1;
};

/// Follows the group at `dyad` from the drive's position `drawn`, where it stands as drawn, to both
/// sides: to the ends of the run, or to its dead points, which are known to rounding. Empty where
/// it cannot be assembled near what is drawn, or `stop` says so.
std::optional<GroupTrack> track_group(const TrackedRun& along, int dyad, double drawn,
                                      const std::function<bool()>& stop);

}  // namespace cognate
