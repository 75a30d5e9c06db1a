#include "problems/path/curve/closed_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cognate::problems {
namespace {

/// Sides looked at one by one.
constexpr std::size_t kLeaf = 8;

double square_to_box(const Vec2d& p, const Vec2d& min, const Vec2d& max) {
  const double x = std::max({min.x - p.x, 0.0, p.x - max.x});
  const double y = std::max({min.y - p.y, 0.0, p.y - max.y});
  return x * x + y * y;
}

double square_to_side(const Vec2d& p, const Vec2d& from, const Vec2d& to) {
  const Vec2d along = to - from, away = p - from;
  const double share = (along.x * away.x + along.y * away.y) / squared_norm(along);
  return squared_norm(away - std::clamp(share, 0.0, 1.0) * along);
}

}  // namespace

ClosedCurve::ClosedCurve(std::vector<Vec2d> vertices) : vertices_(std::move(vertices)), at_{0} {
  for (std::size_t side = 0; side < vertices_.size(); ++side) {
    const Vec2d step = end_of(side) - vertices_[side];
    at_.push_back(at_.back() + std::hypot(step.x, step.y));
  }
  add_node(0, vertices_.size());
}

std::vector<Vec2d> ClosedCurve::equally_spaced(int count) const {
  std::vector<Vec2d> points;
  std::size_t side = 0;
  for (int k = 0; k < count; ++k) {
    const double at = length() * k / count;
    while (side + 1 < vertices_.size() && at_[side + 1] <= at) ++side;
    const double share = (at - at_[side]) / (at_[side + 1] - at_[side]);
    points.push_back(vertices_[side] + share * (end_of(side) - vertices_[side]));
  }
  return points;
}

std::size_t ClosedCurve::add_node(std::size_t begin, std::size_t end) {
  Node node{vertices_[begin], vertices_[begin], begin, end, 0};
  for (std::size_t side = begin; side < end; ++side) {
    for (const Vec2d& p : {vertices_[side], end_of(side)}) {
      node.min = {std::min(node.min.x, p.x), std::min(node.min.y, p.y)};
      node.max = {std::max(node.max.x, p.x), std::max(node.max.y, p.y)};
    }
  }
  const std::size_t index = nodes_.size();
  nodes_.push_back(node);
  if (end - begin > kLeaf) {
    const std::size_t middle = begin + (end - begin) / 2;
    add_node(begin, middle);
    nodes_[index].second = add_node(middle, end);
  }
  return index;
}

/// Lowers `square` to the squared distance of the sides under `node`, where that is less.
void ClosedCurve::lower(const Vec2d& point, std::size_t node, double& square) const {
  const Node& here = nodes_[node];
  if (here.second == 0) {
    for (std::size_t side = here.begin; side < here.end; ++side) {
      square = std::min(square, square_to_side(point, vertices_[side], end_of(side)));
    }
    return;
  }
  const auto to_box = [&](std::size_t child) {
    return square_to_box(point, nodes_[child].min, nodes_[child].max);
  };
  std::size_t near = node + 1, far = here.second;
  if (to_box(far) < to_box(near)) std::swap(near, far);
  if (to_box(near) < square) lower(point, near, square);
  if (to_box(far) < square) lower(point, far, square);
}

double ClosedCurve::distance(const Vec2d& point) const {
  double square = std::numeric_limits<double>::infinity();
  lower(point, 0, square);
  return std::sqrt(square);
}

}  // namespace cognate::problems
