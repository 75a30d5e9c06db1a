#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <span>

#include "analysis/mechanism/assembly_fault.hpp"
#include "problems/evaluation/drive_rows.hpp"
#include "problems/evaluation/motion_quantities.hpp"
#include "problems/mechanism/joint_names.hpp"

namespace cognate::problems {
namespace {

/// By how much the mechanism cannot be assembled.
double missing(const AssemblyFault& fault) {
  switch (fault.kind) {
    case AssemblyFaultKind::too_far_apart:
      return fault.distance - (fault.first + fault.second);
    case AssemblyFaultKind::too_near:
      return fault.first - fault.second - fault.distance;
    case AssemblyFaultKind::guide_too_far:
      return fault.distance - fault.first;
    case AssemblyFaultKind::inside_offset:
      return fault.first - fault.distance;
    case AssemblyFaultKind::parallel_guides:
    case AssemblyFaultKind::parallel_supports:
    case AssemblyFaultKind::group_open:
      break;
  }
  return 0;
}

std::string reason(const AssemblyFault& fault) {
  switch (fault.kind) {
    case AssemblyFaultKind::too_far_apart:
      return fmt::format(
          "its ends are {:.6g} apart, and its links, {:.6g} and {:.6g} long, reach {:.6g}",
          fault.distance, fault.first, fault.second, fault.first + fault.second);
    case AssemblyFaultKind::too_near:
      return fmt::format(
          "its ends are {:.6g} apart, and its links, {:.6g} and {:.6g} long, fold to {:.6g}",
          fault.distance, fault.first, fault.second, fault.first - fault.second);
    case AssemblyFaultKind::guide_too_far:
      return fmt::format(
          "its end is {:.6g} from the path of its slider, and its link is {:.6g} long",
          fault.distance, fault.first);
    case AssemblyFaultKind::inside_offset:
      return fmt::format("its ends are {:.6g} apart, less than its offset of {:.6g}",
                         fault.distance, fault.first);
    case AssemblyFaultKind::parallel_guides:
      return "its slides are parallel";
    case AssemblyFaultKind::parallel_supports:
      return "the guides of the driving link are parallel";
    case AssemblyFaultKind::group_open:
      return "";
  }
  return "";
}

std::string place_text(const AnalysisProblem& problem, int first, int last) {
  const bool slides = driven_by_length(problem.mechanism.mechanism.drive);
  const char* unit = slides ? "" : "°";
  const double from = drive_value(problem, first), to = drive_value(problem, last);
  const char* what = slides ? "slide" : "crank angle";
  if (first == last) return fmt::format("at {} {:.6g}{}", what, from, unit);
  return fmt::format("from {} {:.6g}{} to {:.6g}{}", what, from, unit, to, unit);
}

/// Rows with the same first open dyad.
struct OpenRange {
  int dyad = 0;
  int first = 0;
  int last = 0;
};

std::vector<OpenRange> open_ranges(std::span<const RowState> rows) {
  std::vector<OpenRange> ranges;
  for (int row = 0; row < static_cast<int>(rows.size()); ++row) {
    const int dyad = rows[static_cast<std::size_t>(row)].open_dyad;
    if (dyad == kNone) continue;
    const bool goes_on =
        !ranges.empty() && ranges.back().dyad == dyad && ranges.back().last == row - 1;
    if (goes_on) {
      ranges.back().last = row;
    } else {
      ranges.push_back({dyad, row, row});
    }
  }
  return ranges;
}

std::string note(const AnalysisProblem& problem, const AssemblyRanges& assembly_ranges,
                 const OpenRange& range) {
  const auto name = dyad_names(problem.mechanism)[static_cast<std::size_t>(range.dyad)];
  const auto where = place_text(problem, range.first, range.last);
  if (assembly_ranges.range_at(drive_at(problem.drive, range.first)) != nullptr) {
    return fmt::format(
        "{} the position is not determined: the ends of dyad {} coincide, and it "
        "may turn about them",
        where, name);
  }
  if (has_groups(problem.mechanism.mechanism)) {
    return fmt::format(
        "{} the motion does not reach: between there and where the mechanism is drawn {} comes to "
        "a dead point, or cannot be assembled",
        where, name);
  }
  std::optional<AssemblyFault> worst;
  for (int row = range.first; row <= range.last; ++row) {
    const auto fault = assembly_fault(problem.mechanism.mechanism, drive_at(problem.drive, row));
    if (fault && (!worst || missing(*fault) > missing(*worst))) worst = fault;
  }
  const std::string why = worst ? reason(*worst) : "the motion does not reach it";
  return fmt::format("{} the mechanism cannot be assembled: dyad {} does not close; {}{}", where,
                     name, range.first == range.last || !worst ? "" : "at worst ", why);
}

}  // namespace

std::vector<std::string> open_row_notes(const AnalysisProblem& problem, const Sweep& sweep) {
  constexpr std::size_t kMost = 8;
  const auto ranges = open_ranges(sweep.rows);
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < std::min(ranges.size(), kMost); ++i) {
    notes.push_back(note(problem, sweep.assembly_ranges, ranges[i]));
  }
  if (ranges.size() > kMost) {
    notes.push_back(fmt::format("and in {} more ranges", ranges.size() - kMost));
  }
  return notes;
}

}  // namespace cognate::problems
