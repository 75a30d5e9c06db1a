/// @file The way of a gear's tip through the tooth space of its mate.
#pragma once

#include "analysis/gear/line_of_action.hpp"

namespace cognate::gear {

/// How far the corner of the other gear's tip stays from the fillet of gear `own` (0 or 1) on that
/// flank which touches, as an arc around the centre of `own`: least over the fillet. Negative: the
/// tip digs into the fillet. Infinite where it reaches none of it.
double tip_room(const SpurPair& pair, const LineOfAction& line, int own);

}  // namespace cognate::gear
