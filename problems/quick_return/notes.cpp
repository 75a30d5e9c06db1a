
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/quick_return/designs.hpp"
#include "synthesis/exact/quick_return/guide.hpp"

namespace cognate::problems {
namespace {

using synthesis::LengthInterval;
using synthesis::PivotArc;
using synthesis::RockerDegeneracy;
using synthesis::SliderDegeneracy;

/// Digits that distinguish `length` from the ends of the intervals, at least six.
int digits_for(double length, const std::vector<LengthInterval>& intervals) {
  constexpr int kLeast = 6, kMost = 17;
  const auto is_distinct = [&](double end, int digits) {
    return end == length ||
           fmt::format("{:.{}g}", end, digits) != fmt::format("{:.{}g}", length, digits);
  };
  for (int digits = kLeast; digits < kMost; ++digits) {
    const bool all = std::ranges::all_of(intervals, [&](const LengthInterval& interval) {
      return is_distinct(interval.min, digits) && is_distinct(interval.max, digits);
    });
    if (all) return digits;
  }
  return kMost;
}

/// The ends are excluded but where they are one.
std::string in_words(const LengthInterval& interval, int digits) {
  if (interval.min == interval.max) return fmt::format("{:.{}g}", interval.min, digits);
  if (std::isinf(interval.max)) return fmt::format("more than {:.{}g}", interval.min, digits);
  return fmt::format("more than {:.{}g} and less than {:.{}g}", interval.min, digits, interval.max,
                     digits);
}

/// "more than 27.3 and less than 84.8 with …": the second interval is that of the far arc.
std::string in_words(const std::vector<LengthInterval>& intervals, int digits) {
  if (intervals.empty()) return "";
  std::string text = in_words(intervals[0], digits);
  if (intervals.size() == 1) return text;
  return text + " with the crank pivot on the rocker pivot's side of the limits, " +
         in_words(intervals[1], digits) + " with it beyond them";
}

/// Why a length has no linkage: it is outside of all intervals, or so near an end of one that the
/// linkage is not confirmed.
std::string not_possible(const std::string& what, double length,
                         const std::vector<LengthInterval>& intervals) {
  const int digits = digits_for(std::abs(length), intervals);
  const bool inside = std::ranges::any_of(intervals, [&](const LengthInterval& interval) {
    return std::abs(length) > interval.min && std::abs(length) < interval.max;
  });
  return inside ? fmt::format(
                      "{} of {} is so near the limit of what is possible that rounding errors "
                      "hide whether the linkage moves as required: it must be {}.",
                      what, length, in_words(intervals, digits))
                : fmt::format("{} of {} is not possible: it must be {}.", what, length,
                              in_words(intervals, digits));
}

/// The interval on each arc that has crank pivots.
std::vector<LengthInterval> intervals(const QuickReturnProblem& problem,
                                      LengthInterval synthesis::ArcLimits::*length) {
  std::vector<LengthInterval> found;
  for (const PivotArc arc : {PivotArc::near, PivotArc::far}) {
    const auto limits = arc_limits(rocker_task(problem), arc);
    if (limits && (arc == PivotArc::near || problem.time_ratio > 1)) {
      found.push_back((*limits).*length);
    }
  }
  return found;
}

bool gives_length(const Given& given) {
  return given.crank || given.coupler || given.frame;
}

std::string swing_excludes(const QuickReturnProblem& problem) {
  const double swing = *problem.swing;
  return fmt::format(
      "No crank-rocker has this time ratio with a swing of {:.6g} degrees: K is less than {:.6g}.",
      swing * 180 / kPi, (1.5 * kPi + 0.5 * swing) / (0.5 * kPi - 0.5 * swing));
}

/// Between which angles the rocker may stand at the limit given, in words.
std::string why_no_limit_angle(const QuickReturnProblem& problem) {
  const auto& [limit, angle] = *problem.limit_angle;
  const char* name = limit == synthesis::RockerLimit::outer ? "outer" : "inner";
  if (!problem.swing) {
    return fmt::format(
        "No crank-rocker of this time ratio, rocker and frame has its rocker at {:.6g} degrees at "
        "the {} limit; another angle, frame or time ratio is needed.",
        degrees(angle), name);
  }
  std::vector<LengthInterval> all;
  for (const PivotArc arc : {PivotArc::near, PivotArc::far}) {
    const auto range = limit_angle_range(rocker_task(problem), arc, limit);
    if (range && (arc == PivotArc::near || problem.time_ratio > 1)) {
      all.push_back({degrees(range->min), degrees(range->max)});
    }
  }
  return not_possible(fmt::format("An angle of the rocker at its {} limit", name), degrees(angle),
                      all);
}

std::string why_no_rocker(const QuickReturnProblem& problem,
                          const synthesis::RockerSolutions& found) {
  const Given& given = problem.given;
  if (!problem.swing) return why_no_limit_angle(problem);
  if (!arc_limits(rocker_task(problem), PivotArc::near)) return swing_excludes(problem);
  if (given.crank) {
    return not_possible("A crank", *given.crank, intervals(problem, &synthesis::ArcLimits::crank));
  }
  if (given.coupler) {
    return not_possible("A coupler", *given.coupler,
                        intervals(problem, &synthesis::ArcLimits::coupler));
  }
  if (given.frame) {
    return not_possible("A frame", *given.frame, intervals(problem, &synthesis::ArcLimits::frame));
  }
  if (problem.limit_angle) return why_no_limit_angle(problem);
  if (problem.crank_pivot_line && found.circuit_defects > 0) {
    return "Every crank pivot on the line lies between the limits of the rocker, or opposite to "
           "them: from there the two limits are on different circuits.";
  }
  if (problem.crank_pivot_line) return "The line does not meet the arcs of possible crank pivots.";
  return "No crank-rocker of this time ratio and swing has its lengths within the bounds.";
}

std::string best_of_each_arc(const synthesis::RockerSolutions& found) {
  if (found.degeneracy != RockerDegeneracy::none) {
    return "The design is the one with the largest minimum transmission angle within the "
           "constraints.";
  }
  return "Time ratio, rocker and swing leave a family of crank-rockers; the designs are those with "
         "the largest minimum transmission angle within the constraints, one for each arc of crank "
         "pivots.";
}

std::string chosen_coupler(const synthesis::SliderSolutions& found) {
  if (found.designs.empty()) return "give the coupler.";
  const SliderCrank& mechanism = found.designs[0].mechanism;
  return fmt::format("the design has one {:.6g} times as long. Give the coupler for another.",
                     mechanism.coupler / mechanism.crank);
}

std::string longest_coupler(const QuickReturnProblem& problem) {
  return fmt::format(
      "With K = 1 the least transmission angle grows with the coupler, towards {:.6g} degrees, so "
      "that no linkage is the best: the design has the longest coupler up to a link ratio of "
      "{:.6g}, or as the bounds and constraints allow. Give the coupler, the frame, a line for "
      "the crank pivot, or bounds for another.",
      90 - *problem.swing * 90 / kPi, synthesis::free_link_ratio(rocker_task(problem)));
}

}  // namespace

std::vector<std::string> rocker_notes(const QuickReturnProblem& problem,
                                      const synthesis::RockerSolutions& found) {
  std::vector<std::string> notes;
  switch (found.degeneracy) {
    case RockerDegeneracy::any_coupler:
      notes.emplace_back(
          "K = 1 fixes the crank, at the rocker times the sine of half the swing, and leaves the "
          "coupler free: every crank pivot on the line of the limits will do.");
      break;
    case RockerDegeneracy::line_is_the_arc:
      notes.emplace_back(
          "With K = 1 the crank pivots are the points of the line through the limits, which is the "
          "line given: every one of them will do.");
      break;
    case RockerDegeneracy::one_frame:
      notes.emplace_back(
          "The angle by which K differs from 1 is half the swing: on the rocker pivot's side every "
          "crank pivot is as far from it as the rocker is long, so that a frame of that length "
          "does not choose among them, and no other frame is possible there.");
      break;
    case RockerDegeneracy::none:
      break;
  }
  if (found.designs.empty()) notes.push_back(why_no_rocker(problem, found));
  const bool family =
      !gives_length(problem.given) && !problem.crank_pivot_line && !problem.limit_angle;
  const bool chosen = family || (found.degeneracy != RockerDegeneracy::none &&
                                 !found.designs.empty() && found.designs[0].arc == PivotArc::near);
  if (!found.designs.empty() && chosen) {
    notes.push_back(problem.time_ratio > 1 ? best_of_each_arc(found) : longest_coupler(problem));
  }
  if (!found.designs.empty() && found.circuit_defects > 0) {
    notes.push_back(fmt::format(
        "{} crank pivot{} on the line left out: from there the limits are on different circuits.",
        found.circuit_defects, found.circuit_defects == 1 ? " was" : "s were"));
  }
  return notes;
}

std::vector<std::string> slider_notes(const QuickReturnProblem& problem,
                                      const synthesis::SliderSolutions& found) {
  switch (found.degeneracy) {
    case SliderDegeneracy::any_coupler:
      return {
          "With K = 1 the slide line passes through the crank pivot, the crank is half the "
          "stroke, and every longer coupler will do: " +
          chosen_coupler(found)};
    case SliderDegeneracy::no_offset:
      return {
          "Without offset a slider-crank has K = 1: crank and coupler would be equal, with the "
          "crank pivot at a limit of the stroke. Give an offset, or remove it."};
    case SliderDegeneracy::no_quick:
      return {
          "K = 1 allows no offset: any offset makes one stroke quicker. Give offset = 0 and the "
          "coupler, or K > 1."};
    case SliderDegeneracy::none:
      break;
  }
  if (!found.designs.empty()) return {};
  if (problem.time_ratio >= 3) {
    return {
        "No slider-crank whose crank turns fully has a time ratio of 3 or more; a guide-bar or "
        "a shaper has."};
  }
  const auto limits = synthesis::slider_limits({problem.time_ratio, *problem.stroke});
  if (problem.given.crank) {
    return {not_possible("A crank", *problem.given.crank, {limits.crank})};
  }
  if (problem.given.coupler) {
    return {not_possible("A coupler", *problem.given.coupler, {limits.coupler})};
  }
  return {not_possible("An offset with a magnitude", std::abs(problem.offset.value_or(0)),
                       {limits.offset})};
}

std::string guide_note(const QuickReturnProblem& problem) {
  if (problem.time_ratio == 1) {
    return "With K = 1 the bar would not swing: the crank would have no length.";
  }
  if (problem.given.frame) {
    return fmt::format(
        "An offset of {:.6g} is not possible: with this frame and time ratio its magnitude is less "
        "than {:.6g}, beyond which the crank does not turn fully.",
        problem.offset.value_or(0),
        synthesis::guide_offset_limit(problem.time_ratio, *problem.given.frame));
  }
  return "With this crank and time ratio the offset is so great that the crank would not turn "
         "fully.";
}

std::string shaper_note(synthesis::ShaperOutcome outcome) {
  switch (outcome) {
    case synthesis::ShaperOutcome::no_swing:
      return "With K = 1 the bar would not swing: the crank would have no length.";
    case synthesis::ShaperOutcome::short_rod:
      return "The rod does not reach from the bar's end to the line of the ram in every position; "
             "a longer rod is needed, or another ram_height.";
    case synthesis::ShaperOutcome::overshoot:
      return "The rod leans so far that the ram turns back before the bar does: its stroke and "
             "time ratio would differ from those required. A longer rod, or another ram_height, is "
             "needed.";
    case synthesis::ShaperOutcome::solved:
      break;
  }
  return "The ram does not turn back at the ends of the bar's swing.";
}

}  // namespace cognate::problems
