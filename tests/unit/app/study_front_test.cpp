/// @file The Pareto front of scattered and coinciding points against its definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "app/study/front.hpp"

namespace cognate::app::study_front_test {
namespace {

using Point = StudyFront::Point;

/// Ids of the points that no other dominates, of equal ones the lowest: by the definition.
std::set<std::int64_t> front_by_definition(const std::vector<Point>& points) {
  const auto beats = [](const Point& a, const Point& b) {
    bool better = false;
    for (std::size_t i = 0; i < a.objectives.size(); ++i) {
      if (a.objectives[i] > b.objectives[i]) return false;
      better = better || a.objectives[i] < b.objectives[i];
    }
    return better || a.id < b.id;
  };
  std::set<std::int64_t> ids;
  for (const auto& point : points) {
    const bool beaten = std::ranges::any_of(
        points, [&](const Point& other) { return other.id != point.id && beats(other, point); });
    if (!beaten) ids.insert(point.id);
  }
  return ids;
}

/// Whole numbers below `levels`, so that many coincide in some or all objectives.
std::vector<Point> coarse_points(std::size_t objectives, int levels, std::mt19937& random) {
  std::vector<Point> points(300);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].id = static_cast<std::int64_t>(i);
    for (std::size_t k = 0; k < objectives; ++k) {
      points[i].objectives.push_back(static_cast<double>(random() % levels));
    }
  }
  return points;
}

TEST(StudyFront, IsThatOfTheDefinitionInAnyOrder) {
  std::mt19937 random(1);
  for (const std::size_t objectives : {1U, 2U, 3U, 5U}) {
    for (const int levels : {2, 5, 1000}) {
      auto points = coarse_points(objectives, levels, random);
      const auto expected = front_by_definition(points);
      for (int order = 0; order < 5; ++order) {
        std::ranges::shuffle(points, random);
        StudyFront front;
        std::set<std::int64_t> kept;
        for (const auto& point : points) {
          std::vector<std::int64_t> left;
          if (front.add(point, left)) kept.insert(point.id);
          for (const auto id : left) EXPECT_EQ(kept.erase(id), 1U);
        }
        EXPECT_EQ(kept, expected) << objectives << " objectives, " << levels << " levels";
        EXPECT_EQ(front.points().size(), expected.size());
      }
    }
  }
}

}  // namespace
}  // namespace cognate::app::study_front_test
