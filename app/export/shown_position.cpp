#include "app/export/shown_position.hpp"

#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/evaluation/drive_rows.hpp"

namespace cognate::app {
namespace {

constexpr std::size_t kMostRanges = 6;  // that a message lists

double written(const ResultLinkage& linkage, double drive) {
  return is_driven_by_slider(linkage) ? drive : problems::degrees(drive);
}

/// `drive` plus whole turns, so that it lies in the sweep where it can.
double in_sweep(const ResultLinkage& linkage, double drive) {
  const auto [low, high] = std::minmax(linkage.problem.drive.start, linkage.problem.drive.end);
  if (is_driven_by_slider(linkage) || (low <= drive && drive <= high)) return drive;
  const double least = drive + kTurn * std::ceil((low - drive) / kTurn);
  return least <= high ? least : drive;
}

/// Where the linkage can be assembled: "10 to 80 or 100 to 170".
std::string ranges(const ResultLinkage& linkage, const Course& course) {
  std::string text;
  for (std::size_t i = 0; i < std::min(course.runs.size(), kMostRanges); ++i) {
    const CourseRun& run = course.runs[i];
    text += fmt::format("{}{:.6g} to {:.6g}", i > 0 ? " or " : "", written(linkage, run.from),
                        written(linkage, run.to));
  }
  return text + (course.runs.size() > kMostRanges ? " or further on" : "");
}

}  // namespace

tl::expected<ShownPosition, std::string> shown_position(const ResultLinkage& linkage,
                                                        std::optional<double> wanted,
                                                        FollowedMotion<0>& motion) {
  const auto shown = [&](double drive) { return ShownPosition{drive, written(linkage, drive)}; };
  if (wanted) {
    const double drive =
        in_sweep(linkage, is_driven_by_slider(linkage) ? *wanted : *wanted * kTurn / 360);
    if (motion.move_to(drive)) return shown(drive);
    return tl::unexpected(
        fmt::format("--position: at {} the linkage cannot be shown; allowed is {}", *wanted,
                    motion.course().runs.empty() ? "another linkage, as this one can be assembled "
                                                   "nowhere"
                                                 : ranges(linkage, motion.course())));
  }
  for (const double station : linkage.stations) {
    const double drive = in_sweep(linkage, station);
    if (motion.move_to(drive)) return shown(drive);
  }
  for (int row = 0; row < problems::row_count(linkage.problem.drive); ++row) {
    const double drive = problems::drive_at(linkage.problem.drive, row);
    if (motion.move_to(drive)) return shown(drive);
  }
  return tl::unexpected(std::string(
      "the linkage can be assembled nowhere on the way of its drive; one that can be is wanted"));
}

}  // namespace cognate::app
