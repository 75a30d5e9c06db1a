#include "app/study/front.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

namespace cognate::app {
namespace {

bool nowhere_worse(const StudyFront::Point& a, const StudyFront::Point& b) {
  return std::ranges::equal(a.objectives, b.objectives, std::less_equal());
}

/// With one or two objectives the points are a descending staircase, and neighbours decide.
bool is_staircase(const StudyFront::Point& point) {
  return point.objectives.size() <= 2;
}

}  // namespace

bool StudyFront::is_dominated(const Point& point, std::set<Point>::const_iterator next) const {
  if (is_staircase(point)) {
    return next != points_.begin() && nowhere_worse(*std::prev(next), point);
  }
  return std::any_of(points_.begin(), next,
                     [&](const Point& other) { return nowhere_worse(other, point); });
}

bool StudyFront::add(const Point& point, std::vector<std::int64_t>& left) {
  auto next = points_.lower_bound(point);
  if (is_dominated(point, next)) return false;
  while (next != points_.end()) {
    if (nowhere_worse(point, *next)) {
      left.push_back(next->id);
      next = points_.erase(next);
    } else if (is_staircase(point)) {
      break;
    } else {
      ++next;
    }
  }
  points_.insert(point);
  return true;
}

}  // namespace cognate::app
