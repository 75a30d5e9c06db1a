#include <algorithm>

#include "analysis/numbers/constants.hpp"
#include "problems/guidance/dimensions.hpp"
#include "problems/guidance/model.hpp"

namespace cognate::problems {
namespace {

using namespace motion_dimensions;
using synthesis::DyadKind;

/// Links without a bound of the file are at most so many units long; beyond, a link is a slide.
constexpr double kLongestLink = 1000;
constexpr double kShortestLink = 1e-6;

/// What both allow; `b` where they exclude each other, which the checks of the design then report.
Range intersect(const Range& a, const std::optional<Range>& b) {
  if (!b) return a;
  const Range both{std::max(a.min, b->min), std::min(a.max, b->max)};
  return both.min <= both.max ? both : *b;
}

std::optional<Box> intersect(const std::optional<Box>& a, const std::optional<Box>& b) {
  if (!a || !b) return a ? a : b;
  const Range x = intersect({a->min.x, a->max.x}, Range{b->min.x, b->max.x});
  const Range y = intersect({a->min.y, a->max.y}, Range{b->min.y, b->max.y});
  return Box{{x.min, y.min}, {x.max, y.max}};
}

}  // namespace

void MotionModel::add_variable(int dimension, std::optional<double> given, Range range,
                               const char* name) {
  if (given) {
    fixed_[static_cast<std::size_t>(dimension)] = *given;
    return;
  }
  free_.push_back(dimension);
  variables_.push_back({name, range.min, range.max, 1});
}

void MotionModel::add_point(int dimension, const std::optional<Vec2d>& given,
                            const std::optional<Box>& box, const char* name) {
  const Box limits = box.value_or(Box{{-kInfinity, -kInfinity}, {kInfinity, kInfinity}});
  std::optional<double> x, y;
  if (given) {
    x = given->x;
    y = given->y;
  }
  add_variable(dimension, x, {limits.min.x, limits.max.x}, name);
  add_variable(dimension + 1, y, {limits.min.y, limits.max.y}, name);
}

void MotionModel::list_variables() {
  const Bounds& bounds = problem_.bounds;
  const auto& region = problem_.constraints.pivot_region;
  const auto fixed = [&](DyadRole role) {
    return given_pivot(problem_, problem_.fixed_pivots, role);
  };
  const auto moving = [&](DyadRole role) {
    return given_pivot(problem_, problem_.moving_pivots, role);
  };
  constexpr DyadRole kFirst = DyadRole::first, kOther = DyadRole::second;
  const Range length{kShortestLink, kLongestLink}, anywhere{-kInfinity, kInfinity};
  add_point(kMoving1, moving(kFirst), problem_.moving_bounds[0], "moving pivot of crank");
  add_point(kFixed1, fixed(kFirst), intersect(bounds.pivot_a, region), "fixed pivot of crank");
  add_variable(kLength1, problem_.crank, intersect(length, bounds.crank), "crank");
  const auto d = intersect(bounds.pivot_d, region);
  if (form_.second != DyadKind::rp) {
    add_point(kMoving2, moving(kOther), problem_.moving_bounds[1], "second moving pivot");
  } else {
    add_point(kSecond, fixed(kOther), d, "second fixed pivot");
  }
  if (form_.second == DyadKind::rr) {
    add_point(kFixed2, fixed(kOther), d, "second fixed pivot");
    add_variable(kLength2, problem_.rocker, intersect(length, bounds.rocker), "rocker");
  } else {
    add_variable(kFixed2, std::nullopt, anywhere, "angle of the normal");
    add_variable(kFixed2 + 1, std::nullopt, anywhere, "distance of the line");
    add_variable(kLength2, 0, anywhere, "");
  }
}

/// Limits of coupler and frame, which are distances of points.
void MotionModel::list_distance_limits() {
  const auto add = [&](int from, int to, const std::optional<Range>& range) {
    if (!range) return;
    if (range->min > 0) distance_limits_.push_back({from, to, 1, range->min});
    if (std::isfinite(range->max)) distance_limits_.push_back({from, to, -1, range->max});
  };
  const bool is_block = form_.second == DyadKind::rp;
  if (!is_block) add(kMoving1, kMoving2, problem_.bounds.coupler);
  if (form_.second != DyadKind::pr) {
    add(kFixed1, is_block ? kSecond : kFixed2, problem_.bounds.frame);
  }
}

}  // namespace cognate::problems
