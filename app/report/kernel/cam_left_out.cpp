/// @file What the kernel of the pages leaves out of cams: searches, which have nothing to find
/// where all is given, and tolerances, which take longer than an edit may.
#include "problems/cam/raster.hpp"
#include "problems/cam/read_raster.hpp"
#include "problems/cam/read_tolerances.hpp"
#include "problems/cam/search.hpp"
#include "problems/cam/tolerance_figures.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {

/// The page's problem has just been read.
tl::expected<CamProblem, std::vector<std::string>> KindTraits<CamProblem>::checked(
    const CamProblem& problem) {
  return problem;
}

// NOLINTBEGIN(performance-unnecessary-value-param): as it is declared
std::optional<CamCandidate> search_cam(const CamVariables& /*variables*/,
                                       std::vector<double> /*start*/, synthesis::Solver /*solver*/,
                                       const Deadline& /*deadline*/, Work& /*work*/) {
  return std::nullopt;
}
// NOLINTEND(performance-unnecessary-value-param)

void reading::read_cam_raster(TableReader& /*document*/, CamProblem& /*problem*/) {}

void reading::check_cam_raster(TableReader& /*document*/, const CamProblem& /*problem*/) {}

CamProblem between_raster_values(const CamProblem& problem) {
  return problem;
}

CamRasterAnswer search_cam_raster(const CamProblem& /*problem*/,
                                  const cam::MotionProgramme& /*programme*/, const Run& /*run*/,
                                  const Deadline& /*deadline*/) {
  return {};
}

cam::Cam cam_of(const CamProblem& /*problem*/, const cam::MotionProgramme& /*programme*/,
                const cam::CamDimensions<double>& /*dimensions*/) {
  return {};
}

void tell_cam_raster(const CamProblem& /*problem*/, const cam::MotionProgramme& /*programme*/,
                     const CamRasterAnswer& /*answer*/, const CamDesign* /*between*/,
                     CamResult& /*result*/) {}

std::optional<Tolerances> reading::read_tolerances(TableReader& /*document*/,
                                                   const ToleranceScope& /*scope*/) {
  return std::nullopt;
}

void reading::check_cam_tolerances(TableReader& /*document*/, const CamProblem& /*problem*/) {}

void add_tolerances(const CamProblem& /*problem*/, const Run& /*run*/, const Deadline& /*deadline*/,
                    CamResult& /*result*/) {}

}  // namespace cognate::problems
