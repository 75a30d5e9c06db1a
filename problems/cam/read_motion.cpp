#include "problems/cam/read_motion.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "problems/cam/read_segment.hpp"
#include "problems/toml/number_rules.hpp"

namespace cognate::problems::reading {
namespace {

using cam::MotionLaw;

constexpr std::string_view kMotion = "motion";
constexpr std::size_t kMostSegments = 200'000;
constexpr double kTurn = 360;
// Of sums of decimal fractions, far above their rounding.
constexpr double kSame = 1e-9;

std::vector<CamSegment> read_segments(TableReader& document, bool oscillating) {
  std::vector<CamSegment> segments;
  const std::size_t before = document.faults().size();
  auto tables = document.tables(kMotion, {1, kMostSegments, "segments"});
  segments.reserve(tables.size());
  for (TableReader& table : tables) {
    if (document.faults().size() - before >= FaultList::kMost) break;
    auto segment = read_cam_segment(table, oscillating);
    if (!segment) continue;
    for (FreeMotionParameter& share : segment->free_shares) share.segment = segments.size();
    segments.push_back(*std::move(segment));
  }
  return segments;
}

void check_angles(TableReader& document, const std::vector<CamSegment>& segments) {
  double least = 0, most = 0;
  for (const CamSegment& segment : segments) {
    least += segment.over_deg.min;
    most += segment.over_deg.max;
  }
  const double rounding = kSame * static_cast<double>(segments.size());
  if (most < kTurn - rounding) {
    document.fault(kMotion, fmt::format("has angles that add up to {}{:.12g} degrees, {:.12g} are "
                                        "missing; expected a whole turn of 360",
                                        least < most ? "at most " : "", most, kTurn - most));
  } else if (least > kTurn + rounding) {
    document.fault(kMotion, fmt::format("has angles that add up to {}{:.12g} degrees, {:.12g} too "
                                        "many; expected a whole turn of 360",
                                        least < most ? "at least " : "", least, least - kTurn));
  }
}

// All ranges take the same part of their width, so that the angles make a turn.
void share_out_turn(std::vector<CamSegment>& segments) {
  double least = 0, most = 0;
  for (const CamSegment& segment : segments) {
    least += segment.over_deg.min;
    most += segment.over_deg.max;
  }
  if (!(least < most)) return;
  const double part = std::clamp((kTurn - least) / (most - least), 0.0, 1.0);
  for (CamSegment& segment : segments) {
    const auto& [min, max] = segment.over_deg;
    if (segment.is_free()) segment.segment.over = radians(min + part * (max - min));
  }
}

struct Unit {
  std::string_view key, suffix;
};

Unit unit_of(bool oscillating) {
  return oscillating ? Unit{"rise_deg", " degrees"} : Unit{"rise", ""};
}

void check_rises(TableReader& document, const std::vector<CamSegment>& segments, const Unit& unit) {
  double place = 0, largest = 0;
  for (const CamSegment& segment : segments) {
    place += segment.rise;
    largest = std::max({largest, std::abs(place), std::abs(segment.rise)});
  }
  if (std::abs(place) <= kSame * largest) return;
  document.fault(kMotion, fmt::format("ends {:.12g}{} {} its beginning; a {} of {} = {:.12g} is "
                                      "missing, the rises of a turn add up to 0",
                                      std::abs(place), unit.suffix, place > 0 ? "above" : "below",
                                      place > 0 ? "return" : "rise", unit.key, -place));
}

void check_base_circle(TableReader& document, const std::vector<CamSegment>& segments,
                       const Unit& unit) {
  double place = 0, largest = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    place += segments[i].rise;
    largest = std::max({largest, std::abs(place), std::abs(segments[i].rise)});
    if (place >= -kSame * largest) continue;
    document.faults().add(
        document.where(kMotion, i),
        fmt::format("motion[{}].{} takes the follower {:.12g}{} below its beginning; the motion "
                    "begins on the base circle, as low as the follower goes",
                    i + 1, unit.key, -place, unit.suffix));
    return;
  }
}

// A spline or a polynomial without rise may still move the follower.
void check_moves(TableReader& document, const std::vector<CamSegment>& segments) {
  const auto rests = [](const CamSegment& s) { return s.segment.law == MotionLaw::dwell; };
  if (!std::ranges::all_of(segments, rests)) return;
  document.fault(kMotion,
                 "has dwells only, and a round disc would do; expected a rise and a return");
}

void check_periodic(TableReader& document, const std::vector<CamSegment>& segments) {
  if (segments.size() < 2) return;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!segments[i].segment.ends.periodic) continue;
    document.faults().add(document.where(kMotion, i),
                          fmt::format("motion[{}].periodic is true beside other segments; a "
                                      "periodic spline is the one segment of the turn",
                                      i + 1));
  }
}

}  // namespace

void read_cam_motion(TableReader& document, CamProblem& problem) {
  const bool oscillating = is_oscillating(problem.follower);
  if (!document.has(kMotion)) {
    document.fault(kMotion,
                   "is missing; expected tables [[motion]], each with law, over_deg and rise");
    return;
  }
  const std::size_t before = document.faults().size();
  auto segments = read_segments(document, oscillating);
  if (document.faults().size() > before) return;  // sums of what is not whole say nothing
  const Unit unit = unit_of(oscillating);
  check_moves(document, segments);
  check_angles(document, segments);
  check_rises(document, segments, unit);
  check_base_circle(document, segments, unit);
  check_periodic(document, segments);
  share_out_turn(segments);
  problem.motion.reserve(segments.size());
  for (CamSegment& read : segments) {
    const std::size_t index = problem.motion.size();
    if (read.is_free()) {
      problem.free_motion.push_back(
          {index, MotionParameter::over, {radians(read.over_deg.min), radians(read.over_deg.max)}});
    }
    problem.free_motion.insert(problem.free_motion.end(), read.free_shares.begin(),
                               read.free_shares.end());
    problem.motion.push_back(std::move(read.segment));
  }
}

double greatest_rise(const std::vector<cam::MotionSegment>& motion) {
  double place = 0, greatest = 0;
  for (const cam::MotionSegment& segment : motion) {
    place += segment.rise;
    greatest = std::max(greatest, place);
  }
  return greatest;
}

}  // namespace cognate::problems::reading
