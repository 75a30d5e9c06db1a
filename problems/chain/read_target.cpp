#include "problems/chain/read_target.hpp"

#include <fmt/core.h>

#include <cmath>

#include "problems/path/read_curve.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kTimings[] = {"free", "prescribed"};

void check_neighbours(TableReader& target, const std::vector<std::optional<Two>>& points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!points[i] || points[i - 1] != points[i]) continue;
    target.faults().add(target.where("points", i),
                        fmt::format("point {} of target.points repeats point {}; neighbouring "
                                    "points must differ (only the last may repeat the first)",
                                    i + 1, i));
  }
}

/// Whether the last point of a closed path was the first again, which is then left out.
bool drop_repeated_end(ChainPathProblem& problem) {
  const auto& points = problem.points;
  const bool repeats = points.size() > 1 && norm(points.front() - points.back()) == 0;
  if (!problem.closed || !repeats) return false;
  problem.points.pop_back();
  return true;
}

/// Whether the last point was the first again and is left out.
bool read_point_list(TableReader& target, ChainPathProblem& problem) {
  constexpr std::string_view kKey = "points", kClosed = "closed";
  if (!target.has(kKey)) {
    target.fault(kKey,
                 "is missing; expected an array of 3 to 10000 points [x, y], or a closed curve as "
                 "curve, svg_path or svg");
  }
  const auto closed = target.boolean(kClosed);
  const auto points = target.each_two(kKey, kNumber, "[x, y]", {.min = 3, .of = "points"});
  check_neighbours(target, points);
  for (const Two& point : all_or_none(points).value_or(std::vector<Two>{})) {
    problem.points.push_back({point[0], point[1]});
  }
  if (problem.points.empty()) return false;
  const bool repeats = norm(problem.points.front() - problem.points.back()) == 0;
  problem.closed = closed.value_or(repeats);
  const bool dropped = drop_repeated_end(problem);
  if (problem.points.size() < 3) {
    target.fault(kKey, "are two different points; expected at least 3");
  }
  return dropped;
}

void check_angle_steps(TableReader& target, const std::vector<double>& degrees, bool closed) {
  const auto is_same = [&](std::size_t i, std::size_t k) {
    return std::abs(std::remainder(degrees[i] - degrees[k], 360.0)) <= 1e-9;
  };
  for (std::size_t i = 1; i < degrees.size(); ++i) {
    const bool is_end = closed && i + 1 == degrees.size();
    const std::size_t other = is_end && is_same(i, 0) ? 0 : i - 1;
    if (!is_same(i, other)) continue;
    target.faults().add(target.where("crank_deg", i),
                        fmt::format("entry {} of target.crank_deg, {}, is the same position of the "
                                    "crank as entry {}; neighbouring angles must differ by more "
                                    "than whole turns",
                                    i + 1, degrees[i], other + 1));
  }
}

std::vector<double> read_angles(TableReader& target, const TimedTargets& of) {
  constexpr std::string_view kKey = "crank_deg";
  auto degrees = target.numbers(kKey, kAngle, {.min = 1, .of = "angles"});
  if (!degrees || of.count == 0) return {};
  const std::size_t count = of.count + (of.drops_end ? 1 : 0);
  if (degrees->size() != count) {
    target.fault(kKey, fmt::format("has {} angles for {} {}s; expected one for each {}",
                                   degrees->size(), count, of.noun, of.noun));
    return {};
  }
  if (of.drops_end) {
    if (std::abs(std::remainder(degrees->back() - degrees->front(), 360.0)) > 1e-9) {
      target.fault(kKey,
                   fmt::format("ends at another position of the crank than it begins with, but the "
                               "last {} of the closed {} is the first; expected a whole turn "
                               "between them",
                               of.noun, of.whole));
    }
    degrees->pop_back();
  }
  check_angle_steps(target, *degrees, of.closed);
  std::vector<double> angles;
  for (const double angle : *degrees) angles.push_back(radians(angle));
  return angles;
}

void read_closed_curve(TableReader& target, const std::filesystem::path& folder,
                       ChainPathProblem& problem) {
  PathProblem path;
  read_curve(target, folder, path);
  problem.is_movable = path.curve && path.curve->place == CurvePlace::similar;
  for (const std::string_view key : {"closed"}) {
    if (!target.has(key) || target.boolean(key).value_or(true)) continue;
    target.fault(key, "is false for a closed curve; remove it, or give points");
  }
  problem.points = std::move(path.points);
  problem.closed = true;
}

/// Of points; a closed curve has read its own.
void read_place(TableReader& target, ChainPathProblem& problem) {
  constexpr std::string_view kPlace = "place";
  const auto place = target.choice<CurvePlace>(kPlace).value_or(CurvePlace::given);
  problem.is_movable = place == CurvePlace::similar;
  if (!problem.is_movable || (problem.closed && problem.crank_angles.empty())) return;
  target.fault(kPlace,
               "is \"similar\" for points that are open or timed; only a closed path with free "
               "timing may be moved");
}

/// Further keys of the path of a four-bar.
void refuse_four_bar_keys(TableReader& target) {
  for (const std::string_view key :
       {"weights", "order", "crank_sense", "crank_reference", "poses", "method"}) {
    if (!target.contains(key)) continue;
    target.know({key});
    target.fault(key,
                 "is for four-bars alone; remove it: points of a chain have equal weights, "
                 "cyclic order and differences of crank angles");
  }
}

}  // namespace

std::vector<double> read_chain_timing(TableReader& target, const TimedTargets& of) {
  constexpr std::string_view kTiming = "timing", kAngles = "crank_deg";
  const auto timing = target.choice_of(kTiming, kTimings);
  const bool angles = target.has(kAngles);
  if (timing == 0 && angles) {
    target.fault(kAngles, "is given with free timing; remove timing = \"free\" or crank_deg");
  } else if (timing == 1 && !angles) {
    target.fault(kTiming,
                 fmt::format("is \"prescribed\" without crank_deg; give one angle for each "
                             "{} in target.crank_deg, or timing = \"free\"",
                             of.noun));
  } else if (angles) {
    return read_angles(target, of);
  }
  return {};
}

void read_chain_target(TableReader& target, const std::filesystem::path& folder,
                       ChainPathProblem& problem) {
  if (has_curve(target, {"svg_id", "samples"})) {
    read_closed_curve(target, folder, problem);
    target.know({"timing", "order", "weights", "crank_deg", "crank_reference", "poses"});
    return;
  }
  refuse_four_bar_keys(target);
  const bool dropped = read_point_list(target, problem);
  problem.crank_angles =
      read_chain_timing(target, {problem.points.size(), problem.closed, dropped, "point", "path"});
  read_place(target, problem);
}

}  // namespace cognate::problems::reading
