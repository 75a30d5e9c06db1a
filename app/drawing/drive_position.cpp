#include "app/drawing/drive_position.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/evaluation/drive_rows.hpp"

namespace cognate::app {
namespace {

/// `drive` plus whole turns, so that it lies in the sweep where it can.
double in_sweep(const LinkageScene& linkage, double drive) {
  const auto [low, high] = std::minmax(linkage.problem.drive.start, linkage.problem.drive.end);
  if (is_driven_by_slider(linkage) || (low <= drive && drive <= high)) return drive;
  const double least = drive + kTurn * std::ceil((low - drive) / kTurn);
  return least <= high ? least : drive;
}

}  // namespace

double shown_drive(const LinkageScene& linkage, double drive) {
  return is_driven_by_slider(linkage) ? drive : problems::degrees(drive);
}

std::optional<double> drive_position(const LinkageScene& linkage, std::optional<double> wanted,
                                     FollowedMotion<0>& motion) {
  if (wanted) {
    const double drive =
        in_sweep(linkage, is_driven_by_slider(linkage) ? *wanted : *wanted * kTurn / 360);
    return motion.move_to(drive) ? std::optional(drive) : std::nullopt;
  }
  for (const double station : linkage.stations) {
    const double drive = in_sweep(linkage, station);
    if (motion.move_to(drive)) return drive;
  }
  for (int row = 0; row < problems::row_count(linkage.problem.drive); ++row) {
    const double drive = problems::drive_at(linkage.problem.drive, row);
    if (motion.move_to(drive)) return drive;
  }
  return std::nullopt;
}

}  // namespace cognate::app
