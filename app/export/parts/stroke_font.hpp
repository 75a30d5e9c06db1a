/// @file Letters of single strokes, as an engraver draws them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/vec2.hpp"

namespace cognate::app {

/// The strokes of one line of text of this height of its capitals, from the lower left corner of
/// the first at the origin. ASCII has letters of its own; any other character is a box.
std::vector<std::vector<Vec2d>> strokes_of(std::string_view text, double height);

/// How wide that text is.
double stroke_width(std::string_view text, double height);

/// How far letters hang below the line, as a share of the height of capitals.
inline constexpr double kStrokeDescent = 1.0 / 3;

}  // namespace cognate::app
