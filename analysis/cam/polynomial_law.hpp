/// @file The polynomial of least degree that meets boundary conditions.
#pragma once

#include "analysis/cam/motion_law.hpp"

namespace cognate::cam {

/// `append_pieces` of a polynomial: one piece. False where a condition is given twice, lies outside
/// the segment, or where the conditions have no polynomial or many (Pólya's condition fails), told
/// by the condition number of their equations.
bool append_polynomial(const MotionSegment& segment, double begin, double start, int index,
                       std::vector<MotionPiece<double>>& pieces);

}  // namespace cognate::cam
