#include "problems/machine/drive_gaps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/numbers/constants.hpp"
#include "problems/mechanism/drive_angle.hpp"

namespace cognate::problems {
namespace {

/// Ranges of the drive no farther apart than this meet.
constexpr double kSlack = 1e-9;

double degrees_of(double phi) {
  const double degrees = phi * 360 / kTurn;
  return std::abs(degrees) < kSlack ? 0 : degrees;
}

std::string undetermined_in_words(const AssemblyRange& run) {
  const auto change = std::ranges::find(run.changes, false, &Change::determined);
  if (change == run.changes.end()) return {};
  return fmt::format(
      "the drive does not hold the mechanism at {:.6g}°, where two joints coincide and its "
      "position "
      "is not determined",
      degrees_of(in_period(change->drive, kTurn)));
}

}  // namespace

std::string gap_in_words(const AssemblyRanges& assembly_ranges) {
  if (assembly_ranges.runs.empty())
    return "the mechanism cannot be assembled at any angle of its drive";
  std::vector<AssemblyRange> runs = assembly_ranges.runs;
  const bool closes = runs.front().from <= assembly_ranges.start + kSlack &&
                      runs.back().to >= assembly_ranges.end - kSlack &&
                      runs.front().from_dyad < 0 && runs.back().to_dyad < 0;
  if (closes && runs.size() == 1) return undetermined_in_words(runs.front());
  if (closes) {
    runs.front().from = runs.back().from - kTurn;
    runs.pop_back();
  }
  std::string ranges;
  for (const AssemblyRange& run : runs) {
    ranges += fmt::format("{}from {:.6g}° to {:.6g}°", ranges.empty() ? "" : " and ",
                          degrees_of(run.from), degrees_of(run.to));
  }
  return fmt::format("the drive cannot turn fully: the mechanism can be assembled {}", ranges);
}

std::vector<double> walls(const AssemblyRanges& assembly_ranges) {
  std::vector<double> found;
  const double period = assembly_ranges.end - assembly_ranges.start;
  for (std::size_t i = 0; i < assembly_ranges.runs.size(); ++i) {
    const AssemblyRange& run = assembly_ranges.runs[i];
    const bool is_last = i + 1 == assembly_ranges.runs.size();
    const AssemblyRange& next = assembly_ranges.runs[is_last ? 0 : i + 1];
    const double gap = next.from + (is_last ? period : 0) - run.to;
    const bool ends = run.to_dyad >= 0 || next.from_dyad >= 0;
    if (ends && gap <= kSlack) found.push_back(in_period(run.to, period));
    for (const Change& change : run.changes) {
      if (!change.determined) found.push_back(in_period(change.drive, period));
    }
  }
  return found;
}

}  // namespace cognate::problems
