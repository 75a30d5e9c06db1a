#include "problems/path/curve/outline.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/toml/number_rules.hpp"

namespace cognate::problems::reading {
namespace {

/// Chords of all curved segments together, and the fewest and most of one.
constexpr std::size_t kChords = 65'536, kFewestChords = 16, kMostChords = 4'096;
/// Ends this near, relative to the extent, meet.
constexpr double kMeet = 1e-6;
/// The least extent relative to the coordinates: below it, the points differ in too few digits.
constexpr double kLeastExtent = 1e-9;

/// Width or height of what holds all of `points`, whichever is greater.
double extent(const std::vector<Vec2d>& points) {
  const auto [left, right] = std::ranges::minmax(points, {}, &Vec2d::x);
  const auto [low, high] = std::ranges::minmax(points, {}, &Vec2d::y);
  return std::max(right.x - left.x, high.y - low.y);
}

double greatest_coordinate(const std::vector<Vec2d>& points) {
  double greatest = 0;
  for (const Vec2d& p : points) greatest = std::max({greatest, std::abs(p.x), std::abs(p.y)});
  return greatest;
}

/// The subpath from its beginning to its end in chords, y upwards.
std::vector<Vec2d> chords(const Subpath& path) {
  const auto curved =
      static_cast<std::size_t>(std::ranges::count_if(path.segments, [](const PathSegment& segment) {
        return segment.kind != PathSegment::Kind::line;
      }));
  const std::size_t each =
      curved == 0 ? 1 : std::clamp(kChords / curved, kFewestChords, kMostChords);
  std::vector<Vec2d> vertices{path.start};
  for (const PathSegment& segment : path.segments) {
    const std::size_t count = segment.kind == PathSegment::Kind::line ? 1 : each;
    for (std::size_t k = 1; k < count; ++k)
      vertices.push_back(segment.at(double(k) / double(count)));
    vertices.push_back(segment.to);
  }
  for (Vec2d& p : vertices) p = conj(p);
  return vertices;
}

}  // namespace

tl::expected<ClosedCurve, std::string> closed_polyline(const std::vector<Vec2d>& vertices) {
  std::vector<Vec2d> kept;
  for (const Vec2d& p : vertices) {
    if (kept.empty() || !(kept.back() == p)) kept.push_back(p);
  }
  while (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
  const bool two_alone =
      std::ranges::all_of(kept, [&](const Vec2d& p) { return p == kept.front() || p == kept[1]; });
  if (kept.size() < 3 || two_alone) {
    return tl::unexpected<std::string>(
        "has fewer than 3 different points; expected a closed curve with an extent");
  }
  const double size = extent(kept), farthest = greatest_coordinate(kept);
  if (!is_positive_magnitude(size) || size < kLeastExtent * farthest) {
    return tl::unexpected(fmt::format(
        "is {} wide at a distance of up to {} from the origin; expected a width of at least "
        "1e-9 of that and "
        "from 1e-100 to 1e100",
        size, farthest));
  }
  return ClosedCurve(std::move(kept));
}

tl::expected<ClosedCurve, PathDataFault> closed_outline(std::string_view path_data) {
  const auto subpaths = parse_path_data(path_data);
  if (!subpaths) return tl::unexpected(subpaths.error());
  if (subpaths->size() != 1) {
    return tl::unexpected(PathDataFault{
        0, subpaths->empty()
               ? "draws nothing; expected one closed curve"
               : fmt::format("draws {} curves; expected one closed curve", subpaths->size())});
  }
  const Subpath& path = subpaths->front();
  std::vector<Vec2d> vertices = chords(path);
  const double gap = norm(vertices.back() - vertices.front());
  const bool meets = gap <= kMeet * extent(vertices);
  if (!path.closed && !meets) {
    return tl::unexpected(PathDataFault{
        path_data.size(), fmt::format("ends {} from its beginning; expected a closed curve, ended "
                                      "by Z",
                                      gap)});
  }
  if (meets) vertices.pop_back();
  return closed_polyline(vertices).map_error([](const std::string& message) {
    return PathDataFault{0, message};
  });
}

}  // namespace cognate::problems::reading
