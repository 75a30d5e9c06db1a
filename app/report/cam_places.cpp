#include "app/report/cam_places.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::app {
namespace {

/// More pieces than this have no rows of their own: their borders cannot be distinguished.
constexpr std::size_t kManyPieces = 200;

}  // namespace

std::vector<cam::TurnPlace> cam_places(const cam::MotionProgramme& programme, std::size_t steps) {
  const auto& pieces = programme.pieces();
  const bool borders = pieces.size() <= kManyPieces;
  const double step = kTurn / static_cast<double>(steps);
  std::vector<cam::TurnPlace> places;
  std::size_t next = 1;  // of the even steps
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& piece = pieces[i];
    const int index = static_cast<int>(i);
    const double end = piece.begin + piece.span;
    if (borders || i == 0) places.push_back({piece.begin, index, 0});
    for (; next < steps && static_cast<double>(next) * step < end; ++next) {
      const double angle = static_cast<double>(next) * step;
      if (angle <= piece.begin) continue;
      places.push_back({angle, index, std::min(1.0, (angle - piece.begin) / piece.span)});
    }
    if (borders || i + 1 == pieces.size()) places.push_back({std::min(end, kTurn), index, 1});
  }
  return places;
}

std::vector<CamStroke> cam_strokes(const cam::MotionProgramme& programme) {
  std::vector<CamStroke> strokes;
  for (const cam::StrokePart& part : programme.stroke_parts()) {
    const auto& piece = programme.pieces()[static_cast<std::size_t>(part.piece)];
    const double to = piece.begin + part.to * piece.span;
    if (strokes.empty() || strokes.back().stroke != part.stroke) {
      strokes.push_back({piece.begin + part.from * piece.span, to, part.stroke});
    } else {
      strokes.back().to = to;
    }
  }
  return strokes;
}

}  // namespace cognate::app
