/// @file Curves of an atlas as starts of a search for a closed curve.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/coupler_curve/fourier_descriptors.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "problems/linkage/result.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {

/// A linkage whose crank turns fully, and the descriptors of its coupler curve.
struct AtlasCurve {
  FourBar linkage;
  FourierDescriptors descriptors;
};

/// A linkage moved, turned, enlarged and perhaps mirrored, and its crank angles, from the x axis,
/// at the points of the problem.
struct CurvePose {
  FourBar linkage;
  std::vector<double> crank_angles;
  double error = 0;  ///< sum of squares between curve and target at equal steps of both
};

/// `linkage` where its curve lies on the closed target of `problem` best.
CurvePose place_on_target(const PathProblem& problem, const FourBar& linkage);

/// The `most` curves of `atlas` that are nearest to the problem's closed target by their
/// descriptors, each placed on it; the best placed first.
std::vector<Design> atlas_starts(const PathProblem& problem, std::span<const AtlasCurve> atlas,
                                 std::size_t most);

}  // namespace cognate::problems
