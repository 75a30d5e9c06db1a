/// @file What an exact synthesis of paths found, as quantities and in words.
#pragma once

#include <span>

#include "problems/linkage/result.hpp"
#include "problems/path/exact_designs.hpp"
#include "synthesis/exact/nine_point/nine_point.hpp"

namespace cognate::problems {

/// Where the number of solutions over the complex numbers comes from: from theory for problems
/// without given parts; else counted by monodromy, whose last loops found no more if it `settled`.
struct Expectation {
  bool by_theory = true;
  bool settled = true;
};

/// Adds the counts of a complete solution: how many solutions there are over the complex numbers,
/// at infinity, lost, proved, and real.
void tell_counts(const synthesis::ExactPathSolutions& solutions, const ExactRoots& roots,
                 const Expectation& expected, Result& result);

/// Adds why there is nothing to tell of solutions: positions that coincide or are no numbers,
/// conditions that are not independent, no time.
void tell_status(const synthesis::ExactPathSolutions& solutions, Result& result);

/// Tells of more points on one line or circle than the path of a four-bar has there, a tricircular
/// curve of order six: six. Only degenerate linkages meet them all. False where there are no more;
/// four on a line or five on a circle are told of all the same.
bool tell_points_on_a_circle(std::span<const Vec2d> points, Result& result);

/// Tells of three poses or more without a turn between them, which only parallelograms and sliders
/// give a body.
void tell_equal_angles(std::span<const double> angles, Result& result);

/// Adds what the designs are worth: how many are sound, and what the others miss by.
void tell_designs(const std::vector<TracedDesign>& designs, Result& result);

}  // namespace cognate::problems
