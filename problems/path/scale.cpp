#include "problems/path/scale.hpp"

#include <algorithm>
#include <cmath>

#include "problems/linkage/similarity.hpp"

namespace cognate::problems {

PathScale::PathScale(const PathProblem& problem) : given_(problem.given) {
  const auto weight = [&](std::size_t j) {
    return problem.weights.empty() ? 1 : problem.weights[j];
  };
  double total = 0;
  for (std::size_t j = 0; j < problem.points.size(); ++j) total += weight(j);
  for (std::size_t j = 0; j < problem.points.size(); ++j) {
    centre = centre + (weight(j) / total) * problem.points[j];
  }
  // The largest distance is taken out first, so that squares neither overflow nor vanish.
  double largest = 0;
  for (const Vec2d& p : problem.points) {
    largest = std::max(largest, std::hypot(p.x - centre.x, p.y - centre.y));
  }
  double squares = 0;
  for (std::size_t j = 0; j < problem.points.size(); ++j) {
    squares += weight(j) / total * squared_norm((1 / largest) * (problem.points[j] - centre));
  }
  size = largest * std::sqrt(squares);
}

PathProblem PathScale::into(PathProblem problem) const {
  const Similarity similarity{centre, size};
  for (Vec2d& p : problem.points) p = similarity.point(p);
  similarity.move(problem.given);
  similarity.move(problem.bounds);
  similarity.move(problem.constraints);
  problem.solve.loss_scale /= size;
  return problem;
}

FourBar PathScale::into(const FourBar& linkage) const {
  const Similarity similarity{centre, size};
  FourBar moved = linkage;
  moved.pivot_a = similarity.point(linkage.pivot_a);
  moved.pivot_d = similarity.point(linkage.pivot_d);
  moved.crank /= size;
  moved.coupler /= size;
  moved.rocker /= size;
  if (moved.coupler_point) moved.coupler_point = (1 / size) * *linkage.coupler_point;
  return moved;
}

FourBar PathScale::out_of(const FourBar& linkage) const {
  FourBar moved = linkage;
  moved.pivot_a = centre + size * linkage.pivot_a;
  moved.pivot_d = centre + size * linkage.pivot_d;
  moved.crank *= size;
  moved.coupler *= size;
  moved.rocker *= size;
  if (moved.coupler_point) moved.coupler_point = size * *linkage.coupler_point;
  moved.crank = given_.crank.value_or(moved.crank);
  moved.coupler = given_.coupler.value_or(moved.coupler);
  moved.rocker = given_.rocker.value_or(moved.rocker);
  moved.pivot_a = given_.pivot_a.value_or(moved.pivot_a);
  moved.pivot_d = given_.pivot_d.value_or(moved.pivot_d);
  if (given_.coupler_point) moved.coupler_point = given_.coupler_point;
  return moved;
}

}  // namespace cognate::problems
