/// @file Where on its turn a cam is drawn and tabulated.
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/cam/turn_extremes.hpp"

namespace cognate::app {

/// Places of `programme` in order of the cam angle, from 0 to a whole turn: `steps` equal steps
/// and, unless there are very many pieces, both sides of each piece's border.
std::vector<cam::TurnPlace> cam_places(const cam::MotionProgramme& programme, std::size_t steps);

/// A stretch of the cam angle, rad, with one sense of motion.
struct CamStroke {
  double from = 0;
  double to = 0;
  cam::Stroke stroke = cam::Stroke::dwell;
};

/// The strokes of `programme` in order, neighbours of one sense joined.
std::vector<CamStroke> cam_strokes(const cam::MotionProgramme& programme);

}  // namespace cognate::app
