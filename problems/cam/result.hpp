/// @file What solving a cam problem gives.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/cam/cam.hpp"
#include "problems/cam/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// A cam position that proves a lower bound of the base radius: a limit of the pressure angle that
/// no smaller cam can keep.
struct BindingPosition {
  double angle = 0;   ///< of the cam
  std::string limit;  ///< the constraint's key
  double bound = 0;   ///< its value as the file has it: degrees for an angle
};

/// Why no cam of these limits on the pressure angle can be smaller: the half planes of one or two
/// positions keep the design at least this far away.
struct SizeProof {
  double base_radius_least = 0;
  std::vector<BindingPosition> positions;
  std::string within;  ///< what of the file it takes for granted: "offset = 3"; empty: nothing
};

/// A cam that was found, or given, with all that is known of it.
struct CamDesign {
  cam::Cam cam;                    ///< counter-clockwise; of a clockwise one the mirror image
  std::optional<cam::Cam> second;  ///< of conjugate cams the other, in its own upright position
  std::vector<cam::MotionSegment> motion;
  cam::Operation operation;  ///< with the preload that was found, where none is given
  std::vector<Quantity> metrics;
  std::vector<ConstraintCheck> constraints;
  std::string origin;
  std::optional<SizeProof> proof;
  std::optional<ToleranceResult> tolerance{};  ///< where the file has tolerances
};

/// Peak factors of a segment of the motion and the handbook's.
struct SegmentQuantities {
  cam::PeakFactors factors;
  std::optional<cam::PeakFactors> handbook;
};

/// The cams found, and what holds of the motion whichever is taken.
struct CamResult {
  Status status = Status::no_solution;
  std::vector<CamDesign> designs;  ///< best first
  std::vector<SegmentQuantities> segments;
  std::vector<cam::Jump> jumps;  ///< of velocity and acceleration
  Work work;
  std::vector<std::string> notes;
  std::vector<Quantity> quantities{};  ///< of a search on a raster
};

/// The best cams for `problem`; with all dimensions given, what the one given is like.
CamResult solve(const CamProblem& problem, const Run& run);

}  // namespace cognate::problems
