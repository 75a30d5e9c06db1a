#include "problems/linkage/drive_span.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

/// How far a driving slider is moved beyond its outermost stations, in parts of their distance.
constexpr double kBeyond = 0.25;

/// The same of what turns, so that whoever follows the motion comes upon the ends of its range.
constexpr double kHair = 1e-6;

template <class Ranges, class Holds>
auto most_held(std::span<const double> stations, const Ranges& ranges, const Holds& holds) {
  return std::ranges::max_element(ranges, {}, [&](const auto& range) {
    return std::ranges::count_if(stations, [&](double at) { return holds(range, at); });
  });
}

std::optional<DriveSpan> span_of_turning(const Mechanism<double>& mechanism,
                                         std::span<const double> stations) {
  const auto ranges = ranges_over_a_turn(mechanism);
  if (ranges.empty()) return std::nullopt;
  const auto held = [](const DriveRange& range, double at) {
    const double half = 0.5 * (range.to - range.from);
    return std::abs(std::remainder(at - range.from - half, kTurn)) <= half + 1e-7;
  };
  const auto best = most_held(stations, ranges, held);
  const bool round = best->to - best->from >= kTurn * (1 - 1e-12);
  const double beyond = round ? 0 : kHair * (best->to - best->from);
  return DriveSpan{best->from - beyond, best->to + beyond, round};
}

std::optional<DriveSpan> span_of_sliding(const Mechanism<double>& mechanism,
                                         std::span<const double> stations) {
  if (stations.size() < 2) return std::nullopt;
  const auto [least, greatest] = std::ranges::minmax(stations);
  const double beyond = kBeyond * (greatest - least);
  if (!(beyond > 0)) return std::nullopt;
  const AssemblyRanges assembly_ranges = follow(mechanism, least - beyond, greatest + beyond);
  if (assembly_ranges.runs.empty()) return std::nullopt;
  const auto held = [](const AssemblyRange& run, double at) {
    return run.from <= at && at <= run.to;
  };
  const auto best = most_held(stations, assembly_ranges.runs, held);
  return DriveSpan{best->from, best->to, false};
}

}  // namespace

std::optional<DriveSpan> drive_span(const Mechanism<double>& mechanism,
                                    std::span<const double> stations) {
  const bool slides = driven_by_length(mechanism.drive);
  return slides ? span_of_sliding(mechanism, stations) : span_of_turning(mechanism, stations);
}

}  // namespace cognate::problems
