/// What a path model hands to the fit in SIMD lanes, and takes back.
#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/path/model.hpp"

namespace cognate::problems {
namespace {

// The lanes' kernel counts the unknowns as the model does.
static_assert(int(PathModel::crank) == synthesis::path_crank &&
              int(PathModel::frame) == synthesis::path_frame &&
              int(PathModel::point_u) == synthesis::path_point_u &&
              int(PathModel::anchor_x) == synthesis::path_anchor_x &&
              int(PathModel::angle) == synthesis::path_frame_angle &&
              int(PathModel::phase) == synthesis::path_phase);

/// `angle` and whole turns, as near to `near` as can be.
double turned_near(double angle, double near) {
  return near + std::remainder(angle - near, kTurn);
}

}  // namespace

synthesis::PathFit PathModel::lane_fit() const {
  synthesis::PathFit fit;
  for (std::size_t j = 0; j < problem_.points.size(); ++j) {
    fit.x.push_back(problem_.points[j].x);
    fit.y.push_back(problem_.points[j].y);
  }
  fit.root_weight = root_weight_;
  fit.free = free_;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    fit.lower.push_back(variables_[i].lower);
    fit.upper.push_back(variables_[i].upper);
  }
  for (std::size_t j = 0; j < problem_.points.size(); ++j) fit.is_timed.push_back(is_timed(j));
  fit.counted_from_x = problem_.crank_reference == CrankReference::global;
  fit.anchored_at_d = anchor_is_d_;
  const auto limits = linkage_constraints_.limits();
  fit.limits.assign(limits.begin(), limits.end());
  const Box& box = other_pivot_box_;
  fit.box = {box.min.x, box.max.x, box.min.y, box.max.y};
  if (const auto limits_on_the_way = transmission_on_the_way()) {
    fit.transmission_cosines = {std::cos(limits_on_the_way->max), std::cos(limits_on_the_way->min)};
  }
  return fit;
}

synthesis::PathFitState PathModel::lane_state(std::span<const double> x) const {
  const Full v = full(x);
  synthesis::PathFitState state;
  for (std::size_t i = 0; i < state.value.size(); ++i) state.value[i] = v[i];
  state.frame_x = std::cos(v[angle]);
  state.frame_y = std::sin(v[angle]);
  const double offset = timing_offset(v);
  state.half_phase_x = std::cos(0.5 * offset);
  state.half_phase_y = std::sin(0.5 * offset);
  state.assembly = assembly_;
  for (std::size_t j = 0; j < problem_.points.size(); ++j) {
    const double half = 0.5 * (is_timed(j) ? increment_[j] : local_angle(x, j));
    state.crank_half.push_back(std::cos(half));
    state.crank_half.push_back(std::sin(half));
  }
  return state;
}

std::vector<double> PathModel::variables_of(const synthesis::PathFitState& state,
                                            std::span<const double> near) const {
  std::vector<double> x(near.begin(), near.end());
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (free_[i] == angle) {
      x[i] = turned_near(std::atan2(state.frame_y, state.frame_x), near[i]);
    } else if (free_[i] == phase) {
      x[i] = turned_near(2 * std::atan2(state.half_phase_y, state.half_phase_x), near[i]);
    } else {
      x[i] = state.value[free_[i]];
    }
  }
  for (std::size_t j = 0; j < local_.size(); ++j) {
    if (is_timed(j)) continue;
    const std::size_t i = free_.size() + static_cast<std::size_t>(local_[j]);
    const double there = 2 * std::atan2(state.crank_half[2 * j + 1], state.crank_half[2 * j]);
    x[i] = turned_near(there, near[i]);
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::clamp(x[i], variables_[i].lower, variables_[i].upper);
  }
  return x;
}

}  // namespace cognate::problems
