#include "app/drawing/linkage_paths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/segment.hpp"

namespace cognate::app {
namespace {

constexpr int kFewestPieces = 24;  // of a range of the drive
constexpr int kMostHalvings = 24;

/// Follows one point.
class PathMaker {
 public:
  PathMaker(FollowedMotion<0>& motion, const Attached<double>& point, double tolerance)
      : motion_(motion), point_(point), tolerance_(tolerance) {}

  /// The point's places from `from` to `to`, within one range; none where there is no motion.
  std::vector<Vec2d> follow(double from, double to) {
    corners_.clear();
    constexpr double kHair = 1e-9;  // beside a dead point, where rounding decides
    if (!append(from) && !append(std::lerp(from, to, kHair))) return {};
    for (int i = 0; i < kFewestPieces; ++i) {
      refine(std::lerp(from, to, static_cast<double>(i) / kFewestPieces),
             std::lerp(from, to, (i + 1.0) / kFewestPieces), kMostHalvings);
    }
    return std::move(corners_);
  }

 private:
  bool at(double drive, Vec2d& place) {
    if (!motion_.move_to(drive)) return false;
    place = motion_.point(point_)[0];
    return std::isfinite(place.x) && std::isfinite(place.y);
  }

  bool append(double drive) {
    Vec2d place;
    const bool found = at(drive, place);
    if (found) corners_.push_back(place);
    return found;
  }

  /// Appends what lies between `from`, whose place is the last corner, and `to`, which is the last
  /// corner afterwards.
  void refine(double from, double to, int halvings) {
    const Vec2d first = corners_.back();
    Vec2d last;
    const double middle = std::midpoint(from, to);
    if (corners_.size() > kMostPathCorners) return;
    if (!at(to, last)) return;
    if (halvings > 0 && !is_flat(from, to, first, last)) {
      refine(from, middle, halvings - 1);
      refine(middle, to, halvings - 1);
      return;
    }
    corners_.push_back(last);
  }

  bool is_flat(double from, double to, const Vec2d& first, const Vec2d& last) {
    return std::ranges::all_of(std::array{0.25, 0.5, 0.75}, [&](double share) {
      Vec2d place;
      return !at(std::lerp(from, to, share), place) ||
             distance_to_segment(place, first, last) <= tolerance_;
    });
  }

  FollowedMotion<0>& motion_;
  Attached<double> point_;
  double tolerance_;
  std::vector<Vec2d> corners_;
};

bool moves(const std::vector<Vec2d>& corners, double tolerance) {
  return std::ranges::any_of(
      corners, [&](const Vec2d& corner) { return norm(corner - corners.front()) > tolerance; });
}

bool is_closed(const std::vector<Vec2d>& corners, double tolerance) {
  return corners.size() > 3 && norm(corners.front() - corners.back()) <= tolerance;
}

/// The point's places over what is drawn of `run`: one turn, and where that does not close (as in
/// an antiparallelogram) the second, after which every path repeats itself.
std::vector<Vec2d> drawn_way(PathMaker& maker, const AssemblyRange& run, bool slides,
                             double tolerance) {
  if (slides || run.to - run.from <= kTurn) return maker.follow(run.from, run.to);
  std::vector<Vec2d> corners = maker.follow(run.from, run.from + kTurn);
  if (is_closed(corners, tolerance)) return corners;
  return maker.follow(run.from, std::min(run.to, run.from + 2 * kTurn));
}

/// Whether `run` is one of the first turn again, one or more turns later.
bool is_repeated(const AssemblyRanges& assembly_ranges, const AssemblyRange& run) {
  return run.from >= assembly_ranges.runs.front().from + kTurn;
}

}  // namespace

std::optional<std::vector<PointPath>> linkage_paths(const LinkageScene& linkage,
                                                    const AssemblyRanges& assembly_ranges,
                                                    double tolerance) {
  FollowedMotion<0> motion(linkage.problem.mechanism.mechanism, assembly_ranges);
  std::vector<PointPath> paths;
  const bool slides = is_driven_by_slider(linkage);
  std::size_t total = 0;
  for (const auto& point : linkage.problem.mechanism.points) {
    if (point.at.body == 0) continue;
    PathMaker maker(motion, point.at, tolerance);
    for (const AssemblyRange& run : assembly_ranges.runs) {
      if (!slides && is_repeated(assembly_ranges, run)) continue;
      std::vector<Vec2d> corners = drawn_way(maker, run, slides, tolerance);
      total += corners.size();
      if (total > kMostPathCorners) return std::nullopt;
      if (!moves(corners, tolerance)) continue;
      const bool closed = is_closed(corners, tolerance);
      if (closed) corners.pop_back();
      paths.push_back({point.name, std::move(corners), closed});
    }
  }
  return paths;
}

}  // namespace cognate::app
