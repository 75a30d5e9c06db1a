#include "problems/evaluation/motion_notes.hpp"

#include <fmt/core.h>

#include <variant>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {

std::vector<std::string> motion_notes(const AnalysisProblem& problem,
                                      const MotionSummary& summary) {
  std::vector<std::string> notes;
  if (summary.ranges > 1) {
    const auto& drive = problem.mechanism.mechanism.drive;
    const bool slides = std::holds_alternative<DrivingSlider<double>>(drive);
    const double unit = slides ? 1 : 180 / kPi;
    notes.push_back(fmt::format(
        "the drive crosses {} separate ranges of the mechanism; its stroke or swing is that of the "
        "first, from {:.6g} to {:.6g}, its transmission and pressure angles are the extremes of "
        "all",
        summary.ranges, unit * summary.from + 0.0, unit * summary.to + 0.0));
  }
  if (!summary.endless.empty()) {
    notes.push_back(fmt::format(
        "the stroke of {} has no end: it grows without bound where guides become parallel",
        summary.endless));
  }
  return notes;
}

}  // namespace cognate::problems
