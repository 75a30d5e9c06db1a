/// @file The Pareto front of a study, kept while its rows come in any order.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace cognate::app {

/// Points none of which is dominated: no other is as good in every objective and better in one. Of
/// points that are equal in all objectives the one with the lowest id stays, so that the front does
/// not depend on the order in which its points came.
class StudyFront {
 public:
  struct Point {
    std::vector<double> objectives;  ///< less is better; all points have equally many
    std::int64_t id = 0;
    /// By objectives, one after the other, then by id: what is dominated comes later.
    auto operator<=>(const Point&) const = default;
  };

  /// Adds `point` unless it is dominated, and takes out what it dominates; whether it was added.
  /// The ids taken out are appended to `left`.
  bool add(const Point& point, std::vector<std::int64_t>& left);

  const std::set<Point>& points() const { return points_; }

 private:
  bool is_dominated(const Point& point, std::set<Point>::const_iterator next) const;

  std::set<Point> points_;
};

}  // namespace cognate::app
