/// @file Directions of straight guides, as a file gives them.
#pragma once

#include <optional>
#include <string_view>

#include "analysis/numbers/vec2.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The unit vector at `degrees` from the first axis, exact at multiples of a right angle.
Vec2d unit_vector_at_degrees(double degrees);

/// The angle under `key`, in degrees; `otherwise` where there is none or a wrong one.
double read_degrees(TableReader& table, std::string_view key, double otherwise);

/// Whether lines in the directions of the unit vectors `a` and `b` are parallel, but for rounding.
bool are_parallel(Vec2d a, Vec2d b);

}  // namespace cognate::problems::reading
