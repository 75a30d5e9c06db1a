/// @file Rectangles packed on sheets.
#pragma once

#include <optional>
#include <vector>

#include "analysis/numbers/vec2.hpp"

namespace cognate::app {

/// What is to be packed: a rectangle in one of several sizes, of which one is chosen.
struct NestItem {
  std::vector<Vec2d> sizes;
};

struct NestPlace {
  int sheet = 0;           ///< from 0
  std::size_t choice = 0;  ///< which of the sizes
  Vec2d corner{};          ///< lower left
};

struct Nesting {
  std::vector<NestPlace> places;  ///< of each item
  int sheets = 0;
};

/// All `items` on sheets of size `sheet`, at least `gap` apart: on as few sheets as any of some
/// orders and rules gives (maximal free rectangles: Jylänki, A Thousand Ways to Pack the Bin,
/// 2010), and of those the lowest on the last sheet. Empty where an item is larger than the sheet.
std::optional<Nesting> nest(const std::vector<NestItem>& items, const Vec2d& sheet, double gap);

/// Whether a rectangle of that size lies in the sheet, to rounding.
bool fits_sheet(const Vec2d& size, const Vec2d& sheet);

}  // namespace cognate::app
