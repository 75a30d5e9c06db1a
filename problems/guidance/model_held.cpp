#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/guidance/dimensions.hpp"
#include "problems/guidance/model.hpp"

namespace cognate::problems {
namespace {

using namespace motion_dimensions;
using synthesis::DyadKind;

/// Of the sum of all slopes of a station held: less is what an unfinished refinement leaves.
constexpr double kLeastPressure = 1e-6;
/// How far before its dead point a station that is held no longer begins.
constexpr double kReleasedFromDead = 0.02;

bool is_held(const std::optional<HeldDeadPoint>& point) {
  return point.has_value();
}

}  // namespace

std::optional<MotionForm> MotionModel::with_held(std::span<const double> x, double angle) const {
  if (form_.second != DyadKind::rr || driven_range_.count() > 0) return std::nullopt;
  const Full v = full(x);
  const Vec2d coupler = point(v, kMoving2) - point(v, kMoving1);
  const double links = norm(coupler) * v[kLength2];
  double least = links * std::sin(angle);
  std::optional<std::pair<std::size_t, HeldDeadPoint>> nearest;
  for (std::size_t j = 0; j < problem_.poses.size(); ++j) {
    const std::size_t k = station_of(j);
    if (held(k)) continue;
    const auto at = station(v, j, x[variable_of_station_[k]]);
    if (!at) return std::nullopt;
    const Vec2d arm = at->turn * coupler, link = point(v, kFixed2) - at->pin - arm;
    const double area = std::abs(cross(arm, link));
    const HeldDeadPoint dead = nearest_dead_point(v, at->pin);
    if (area > least || !dead_station(v, dead, form_.sides[j])) continue;
    least = area;
    nearest = {k, dead};
  }
  if (!nearest) return std::nullopt;
  MotionForm form = form_;
  form.held.resize(station_count());
  form.held[nearest->first] = nearest->second;
  return form;
}

std::optional<MotionForm> MotionModel::kept_closed(std::span<const double> x, double share) const {
  if (form_.second != DyadKind::rr || driven_range_.count() > 0) return std::nullopt;
  const Full v = full(x);
  const Vec2d frame = point(v, kFixed2) - point(v, kFixed1);
  const std::vector<double> angles = station_angles(x);
  const auto way_of = [&](double sense) {
    double way = 0;
    for (std::size_t i = 1; i < angles.size(); ++i) {
      way += in_one_turn(sense * (angles[i] - angles[i - 1]));
    }
    return way;
  };
  const double sense = way_of(1) <= way_of(-1) ? 1 : -1, way = way_of(sense);
  MotionForm form = form_;
  for (const bool towards : {true, false}) {
    const double line = angle_of(towards ? frame : -frame);
    const ClosingSlack slack = closing_slack(v, towards);
    if (slack.value > share * slack.links) continue;
    if (in_one_turn(sense * (line - angles.front())) > way) continue;
    (towards ? form.closes_towards : form.closes_away) = true;
  }
  const bool is_new =
      form.closes_towards != form_.closes_towards || form.closes_away != form_.closes_away;
  return is_new ? std::optional(std::move(form)) : std::nullopt;
}

std::optional<std::size_t> MotionModel::pressed_inwards(std::span<const double> x) const {
  const Full v = full(x);
  std::vector<double> slopes(station_count()), sizes(station_count());
  for (std::size_t j = 0; j < problem_.poses.size(); ++j) {
    const std::size_t k = station_of(j);
    const auto at = station_of_pose(x, v, j);
    if (!held(k) || !at) continue;
    const Vec2d arm = at->turn * point(v, kMoving1);
    const Vec2d miss = at->pin - arm - problem_.poses[j].at;
    const double turned = angle_of(at->turn * conj(unit_vector(problem_.poses[j].angle)));
    const double weight = problem_.angle_weight * problem_.angle_weight;
    const double way = -dot(miss, perp(arm)), rest = weight * turned;
    const double leaving = turn_leaving(v, *held(k), form_.sides[j]);
    slopes[k] += leaving * (way + rest);
    sizes[k] += std::abs(leaving) * (std::abs(way) + std::abs(rest));
  }
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    if (slopes[k] < -kLeastPressure * sizes[k]) return k;
  }
  return std::nullopt;
}

std::optional<MotionForm> MotionModel::released(std::span<const double> x, std::size_t station,
                                                std::vector<double>& angles) const {
  const Full v = full(x);
  for (std::size_t j = 0; j < problem_.poses.size(); ++j) {
    if (station_of(j) != station) continue;
    const auto before = dead_station(v, *held(station), form_.sides[j], kReleasedFromDead);
    if (!before) return std::nullopt;
    angles[station] = before->crank_angle;
    break;
  }
  MotionForm form = form_;
  form.held[station].reset();
  if (std::ranges::none_of(form.held, is_held)) form.held.clear();
  return form;
}

}  // namespace cognate::problems
