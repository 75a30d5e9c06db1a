/// @file The tolerances of designs that a synthesis found.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "problems/basics/length_unit.hpp"
#include "problems/linkage/result.hpp"
#include "problems/tolerance/figures.hpp"

namespace cognate::problems {

/// A question about a design at crank angles (radians), with the range of its crank that holds them
/// as its motion: the whole turn of a crank that turns fully. Angles at which it cannot be
/// assembled in its own assembly are left out: `kept` says which are there.
struct DesignQuestion {
  ToleranceQuestion question;
  std::vector<std::size_t> kept;  ///< of each station the index of its crank angle
};
DesignQuestion question_at(const NamedMechanism& mechanism, const std::vector<double>& angles);

/// The point of the mechanism called `name`; empty where there is none.
std::optional<Response> point_response(const NamedMechanism& mechanism, std::string_view name);

/// Unit normals of the path of a point at stations, and its nominal places.
struct PathFrame {
  std::vector<Vec2d> place, normal;
};
PathFrame path_frame(const NamedMechanism& mechanism, const ToleranceQuestion& question,
                     const Response& point);

/// The error of the point called `name` at crank angles, one for each of `targets`. `timed`: at
/// these very angles it is the distance of the point from its target; else the crank may follow,
/// and the error counts along the path's normals, to first order in how far it follows.
std::optional<ToleranceQuestion> error_at_targets(const NamedMechanism& mechanism,
                                                  std::string_view name,
                                                  const std::vector<double>& angles,
                                                  const std::vector<Vec2d>& targets, bool timed);

/// The travel of the output over the motion, as what is judged.
std::optional<ToleranceQuestion> output_over_motion(const NamedMechanism& mechanism,
                                                    const std::vector<double>& angles);

/// Adds the transmission angle of each dyad that has dead points.
void add_transmissions(const NamedMechanism& mechanism, ToleranceQuestion& question);

/// Sets the tolerances of every design, and adds their figures to its metrics; of many the first
/// ten. A design of which there is no question has none.
void add_tolerances(
    const std::optional<Tolerances>& tolerances, std::optional<LengthUnit> unit, const Run& run,
    const std::function<std::optional<ToleranceQuestion>(const Design&)>& question_of,
    Result& result);

/// The figures of the judged quantity by which studies know them: "tolerance_exact_deg"…
std::vector<Quantity> tolerance_quantities(const ToleranceResult& result);

}  // namespace cognate::problems
