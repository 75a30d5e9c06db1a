/// @file What tolerances do to a design: every figure of one mechanism.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/forces.hpp"
#include "analysis/tolerance/response.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/tolerance/result.hpp"
#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {

/// A quantity of a mechanism at each station.
struct ToleranceQuantity {
  std::string name;
  Response response;
  bool judged = false;         ///< the error that yield, quantiles and allocation are about
  std::vector<double> offset;  ///< its nominal error at each station, radians or length; empty: 0
  std::vector<Vec2d> target;   ///< of a point, at each station; empty: its nominal place
  /// Of a point of which only the deviation along these unit vectors counts, one for each station:
  /// where it is free along a curve, the curve's normals. `offset` is then its nominal error.
  std::vector<Vec2d> normal;

  /// Whether the error is a distance of a point, else a number of either sign.
  bool is_distance() const { return response.type == ResponseType::point && normal.empty(); }
  /// The scalar response at a station.
  Response scalar(std::size_t station) const;
};

/// What is asked of a design.
struct ToleranceQuestion {
  std::vector<double> drive;      ///< radians, or the slide's length
  std::vector<Station> stations;  ///< one for each
  std::size_t left_out = 0;       ///< positions that must be met and have no station
  std::vector<ToleranceQuantity> quantities;
  /// Positions between which the mechanism must move: dead points are looked for there, too.
  std::vector<Station> motion;
  std::vector<double> motion_drive;
  /// Reactions at each station, by which loaded pins touch; empty without loads.
  std::vector<Forces> reactions;
};

/// How figures are computed.
struct ToleranceRun {
  std::uint64_t seed = 1;
  int threads = 0;
  std::function<bool()> stop{};
};

/// Positions of the drive at which the mechanism can be assembled, with their sides; drives that
/// are on a change point, or where it cannot be, are left out of both.
void add_stations(const Mechanism<double>& mechanism, const AssemblyRanges& ranges,
                  std::span<const double> drives, std::vector<double>& kept,
                  std::vector<Station>& stations);

/// The response that is the travel of body `body`: the angle of one that turns, the displacement of
/// one that slides.
Response travel_response(const Mechanism<double>& mechanism, int body);

/// Every figure. What stands in the way (a change point, a length without a tolerance in its
/// standard) is said in `refused`.
ToleranceResult tolerance_figures(const NamedMechanism& mechanism, const Tolerances& tolerances,
                                  std::optional<LengthUnit> unit, const ToleranceQuestion& question,
                                  const ToleranceRun& run);

}  // namespace cognate::problems
