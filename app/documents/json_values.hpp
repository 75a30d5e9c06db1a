/// @file The small values that results are made of, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

#include "analysis/numbers/vec2.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/quantity.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/toml/document.hpp"

namespace cognate::app {

using problems::degrees;

/// [x, y].
nlohmann::ordered_json to_json(const Vec2d& point);

/// [min, max]. A side that is infinite has no JSON number, so the range is then an object with the
/// other side alone: {"min": 1}.
nlohmann::ordered_json to_json(const problems::Range& range);

/// As `to_json`, with both sides turned from radians into degrees.
nlohmann::ordered_json to_json_deg(const problems::Range& range);

/// [[xmin, ymin], [xmax, ymax]]; where a side is infinite, {"x": range, "y": range}.
nlohmann::ordered_json to_json(const problems::Box& box);

/// The tables of a problem file, their arrays of two numbers or two points as `to_json` writes
/// ranges and boxes.
nlohmann::ordered_json to_json(const problems::reading::Table& document);

/// Each quantity under its name in `table`; one named "a.b" in its table "a" under "b".
void add_quantities(nlohmann::ordered_json& table, std::span<const problems::Quantity> quantities);

/// The path (/designs/0/error/rms) of the first number in `document` that is NaN or infinite, which
/// JSON cannot hold; empty when every number is finite.
std::optional<std::string> find_non_finite(const nlohmann::ordered_json& document);

}  // namespace cognate::app
