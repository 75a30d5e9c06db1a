/// @file The smallest cam whose lengths lie on a raster, by trying every combination that may be
/// it.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/cam/cam.hpp"
#include "problems/cam/problem.hpp"
#include "problems/cam/result.hpp"
#include "synthesis/raster/values.hpp"

namespace cognate::problems {

/// Combinations of all lengths but the base radius, each of which may be tried at each base radius.
inline constexpr double kMostCamCombinations = 20'000;

/// The values of a length that is free but for the raster.
struct CamRasterAxis {
  CamDimension dimension = CamDimension::base_radius;
  synthesis::RasterValues values;
};

/// An axis for each free length, in the order of `CamDimension`. Without end only where the file
/// bounds neither the length nor its list; of a base radius, which ends where no cam is, never.
std::vector<CamRasterAxis> cam_raster_axes(const CamProblem& problem);

/// How many combinations of the axes other than the base radius there are.
double combinations_beside_base(const std::vector<CamRasterAxis>& axes);

/// `problem` without a raster, each free length between the least and the greatest of its values.
CamProblem between_raster_values(const CamProblem& problem);

/// What was tried, and the smallest cams that keep every limit.
struct CamRasterAnswer {
  std::vector<cam::CamDimensions<double>> best;  ///< smallest first
  double combinations = 0;
  double covered = 0;           ///< tried, excluded by half planes, or larger than the best
  std::uint64_t evaluated = 0;  ///< tried
  bool is_complete = false;     ///< all are covered
};

/// The smallest cams on the raster, `problem.solve.designs` of them at most: base radii in
/// ascending order, each with every combination of the other lengths whose lower bound of the base
/// radius (half planes, curvature of a face) it reaches. No limit need be monotone in the base
/// radius. Of cams of one size that with the largest roller comes first, then that with the least
/// pressure angle. `problem` has the preload that it needs.
CamRasterAnswer search_cam_raster(const CamProblem& problem, const cam::MotionProgramme& programme,
                                  const Run& run, const Deadline& deadline);

/// The cam of these lengths.
cam::Cam cam_of(const CamProblem& problem, const cam::MotionProgramme& programme,
                const cam::CamDimensions<double>& dimensions);

/// Facts and sentences of `answer` beside the best cam between the values, where there is one.
void tell_cam_raster(const CamProblem& problem, const cam::MotionProgramme& programme,
                     const CamRasterAnswer& answer, const CamDesign* between, CamResult& result);

}  // namespace cognate::problems
