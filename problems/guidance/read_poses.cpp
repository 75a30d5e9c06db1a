#include "problems/guidance/read_poses.hpp"

#include <fmt/core.h>

#include <cmath>

#include "problems/basics/degrees.hpp"
#include "problems/mechanism/quantity_rules.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kPoses = "poses";
constexpr std::string_view kSegments = "segments";
constexpr std::size_t kMostPoses = 10000;

// Relative difference of the segments' lengths beyond which they are not one body: far above what
// printed digits leave, and named in the message.
constexpr double kSameLength = 1e-6;

void read_pose_rows(TableReader& target, const Count& count, GivenPoses& given) {
  const auto rows = target.each_row(kPoses, 3, kQuantity, "[x, y, angle_deg]", count);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i] || kAngle.accepts((*rows[i])[2])) continue;
    target.faults().add(target.where(kPoses, i),
                        fmt::format("pose {} of target.poses has the angle {}; expected {}", i + 1,
                                    (*rows[i])[2], kAngle.allowed));
  }
  for (const auto& row : all_or_none(rows).value_or(std::vector<std::vector<double>>{})) {
    given.poses.push_back({{row[0], row[1]}, radians(row[2])});
  }
}

// Rigid bodies keep their lengths.
void check_lengths(TableReader& target, const GivenPoses& given) {
  std::vector<double> lengths;
  for (const auto& [first, second] : given.segments) lengths.push_back(norm(second - first));
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double difference = lengths[i] - lengths[0];
    if (lengths[i] > 0 && std::abs(difference) <= kSameLength * lengths[0]) continue;
    target.faults().add(
        target.where(kSegments, i),
        lengths[i] > 0
            ? fmt::format("segment {} of target.segments is {} long and the first {}, a "
                          "difference of {}; two points of a rigid body keep their "
                          "distance, to a part in 1e6",
                          i + 1, lengths[i], lengths[0], difference)
            : fmt::format("segment {} of target.segments has no length; expected two different "
                          "points of the body",
                          i + 1));
    if (lengths[0] <= 0) return;
  }
}

void read_segments(TableReader& target, const Count& count, GivenPoses& given) {
  const auto read = target.each_segment(kSegments, kQuantity, "[[x1, y1], [x2, y2]]", count);
  const auto segments = all_or_none(read);
  if (!segments) return;
  std::vector<Vec2d> firsts, seconds;
  for (const auto& [first, second] : *segments) {
    firsts.push_back({first[0], first[1]});
    seconds.push_back({second[0], second[1]});
    given.segments.push_back({firsts.back(), seconds.back()});
  }
  check_lengths(target, given);
  const auto body = synthesis::poses_of_segment(firsts, seconds);
  given.poses = body.poses;
}

}  // namespace

GivenPoses read_poses(TableReader& target, std::size_t least) {
  const Count count{.min = least, .max = kMostPoses, .of = "poses"};
  const bool has_poses = target.has(kPoses), has_segments = target.has(kSegments);
  if (has_poses && has_segments) {
    target.fault(kSegments, "is given beside target.poses; give one of the two");
  } else if (!has_poses && !has_segments) {
    target.fault(kPoses, fmt::format("is missing; expected {} poses or more, [x, y, angle_deg], or "
                                     "target.segments, the places [[x1, y1], [x2, y2]] of two "
                                     "points of the body",
                                     least == 2 ? "two" : "three"));
  }
  GivenPoses given;
  if (has_poses) read_pose_rows(target, count, given);
  if (has_segments && !has_poses) read_segments(target, count, given);
  return given;
}

}  // namespace cognate::problems::reading
