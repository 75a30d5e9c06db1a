/// @file Closed curves as targets of paths.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string_view>

#include "problems/path/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Whether `target` has a closed curve, rightly or wrongly given; faults `keys`, those that only a
/// curve has, without one.
bool has_curve(TableReader& target,
               std::initializer_list<std::string_view> keys = {"svg_id", "samples", "place"});

/// `target.curve`, `svg_path` or `svg` with `svg_id`, `samples` and `place` into the problem's
/// curve and points, and faults where keys of single points stand beside them. Drawings are looked
/// for in `folder`; without one they are refused.
void read_curve(TableReader& target, const std::filesystem::path& folder, PathProblem& problem);

/// `constraints.no_extra_loop`, and faults for what a closed curve excludes: classes and lengths
/// whose crank cannot turn fully, and, of a curve that may be moved and enlarged, what fixes points
/// of the plane or of the coupler.
void finish_curve(TableReader& mechanism, TableReader& bounds, TableReader& constraints,
                  PathProblem& problem);

}  // namespace cognate::problems::reading
