#include "problems/guidance/toleranced_model.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/guidance/dimensions.hpp"

namespace cognate::problems {
namespace {

using namespace motion_dimensions;

void add_to(std::span<double> v, int dimension, const Vec2d& way) {
  const auto at = static_cast<std::size_t>(dimension);
  v[at] += way.x;
  v[at + 1] += way.y;
}

Vec2d pair_of_slopes(std::span<const double> row, int dimension) {
  const auto at = static_cast<std::size_t>(dimension);
  return {row[at], row[at + 1]};
}

}  // namespace

/// The variables of the nominal model for what is made.
struct TolerancedMotionModel::Moved {
  /// A distance of two points, its direction, and how a point moves that goes with the latter.
  struct Bar {
    double length = 0;
    Vec2d along, across;  ///< across: a quarter turn from along

    Bar(const Vec2d& from, const Vec2d& to) : length(norm(to - from)) {
      along = (1 / length) * (to - from);
      across = perp(along);
    }
  };

  std::vector<double> x;
  Bar coupler, frame;        ///< nominal
  Vec2d first, second, far;  ///< how far the moving pivots and D have gone, along and across
};

TolerancedMotionModel::TolerancedMotionModel(const MotionProblem& problem, MotionForm form)
    : nominal_(problem, std::move(form)) {
  const auto all = nominal_.variables();
  variables_.assign(all.begin(), all.begin() + nominal_.global_count());
  for (const char* name : {"crank", "coupler", "rocker", "frame", "point u", "point v"}) {
    variables_.push_back({std::string("change of ") + name, -kInfinity, kInfinity, 1});
  }
  variables_.insert(variables_.end(), all.begin() + nominal_.global_count(), all.end());
}

std::vector<double> TolerancedMotionModel::without_changes(std::span<const double> x) const {
  std::vector<double> nominal(x.begin(), x.end());
  const auto first = nominal.begin() + static_cast<std::ptrdiff_t>(before_changes());
  nominal.erase(first, first + changes);
  return nominal;
}

std::vector<double> TolerancedMotionModel::with_no_changes(std::span<const double> nominal) const {
  std::vector<double> x(nominal.begin(), nominal.end());
  x.insert(x.begin() + static_cast<std::ptrdiff_t>(before_changes()), changes, 0.0);
  return x;
}

std::optional<TolerancedMotionModel::Moved> TolerancedMotionModel::moved(
    std::span<const double> x) const {
  const auto change = [&](Change of) { return x[variable_of(of)]; };
  const Vec2d point{-change(point_u), -change(point_v)};
  Moved at{without_changes(x),
           {pair_of_slopes(x, kMoving1), pair_of_slopes(x, kMoving2)},
           {pair_of_slopes(x, kFixed1), pair_of_slopes(x, kFixed2)},
           point,
           point + Vec2d{change(coupler), 0},
           {change(frame), 0}};
  add_to(at.x, kMoving1, at.first.x * at.coupler.along + at.first.y * at.coupler.across);
  add_to(at.x, kMoving2, at.second.x * at.coupler.along + at.second.y * at.coupler.across);
  add_to(at.x, kFixed2, at.far.x * at.frame.along);
  at.x[kLength1] += change(crank);
  at.x[kLength2] += change(rocker);
  const bool is_made = at.coupler.length > 0 && at.coupler.length + change(coupler) > 0 &&
                       at.frame.length > 0 && at.frame.length + change(frame) > 0 &&
                       at.x[kLength1] > 0 && at.x[kLength2] > 0;
  return is_made ? std::optional(std::move(at)) : std::nullopt;
}

/// A row of derivatives by the variables of this model from that by the moved ones: nominal pivots
/// turn coupler and frame, and with them the changes.
void TolerancedMotionModel::turn_back(const Moved& at, std::span<const double> by_moved,
                                      std::span<double> row) {
  const std::size_t count = by_moved.size();
  std::ranges::copy(by_moved, row.begin());
  const Vec2d by_first = pair_of_slopes(by_moved, kMoving1);
  const Vec2d by_second = pair_of_slopes(by_moved, kMoving2);
  const Vec2d by_far = pair_of_slopes(by_moved, kFixed2);
  const auto& [along, across] = std::pair(at.coupler.along, at.coupler.across);
  const double by_coupler_turn = dot(by_first, at.first.x * across - at.first.y * along) +
                                 dot(by_second, at.second.x * across - at.second.y * along);
  const double by_frame_turn = dot(by_far, at.far.x * at.frame.across);
  const Vec2d of_second = (by_coupler_turn / at.coupler.length) * across;
  const Vec2d of_far = (by_frame_turn / at.frame.length) * at.frame.across;
  add_to(row, kMoving2, of_second);
  add_to(row, kMoving1, -of_second);
  add_to(row, kFixed2, of_far);
  add_to(row, kFixed1, -of_far);
  row[count + crank] = by_moved[kLength1];
  row[count + coupler] = dot(by_second, along);
  row[count + rocker] = by_moved[kLength2];
  row[count + frame] = dot(by_far, at.frame.along);
  row[count + point_u] = -dot(by_first + by_second, along);
  row[count + point_v] = -dot(by_first + by_second, across);
}

bool TolerancedMotionModel::residuals(std::span<const double> x, std::span<double> r,
                                      std::span<double> jacobian, std::span<double> local) const {
  const auto at = moved(x);
  if (!at) return false;
  if (jacobian.empty()) return nominal_.residuals(at->x, r, {}, local);
  const std::size_t narrow = before_changes(), wide = narrow + changes;
  thread_local std::vector<double> by_moved;
  by_moved.resize(narrow * r.size());
  if (!nominal_.residuals(at->x, r, by_moved, local)) return false;
  for (std::size_t row = 0; row < r.size(); ++row) {
    turn_back(*at, std::span(by_moved).subspan(row * narrow, narrow),
              jacobian.subspan(row * wide, wide));
  }
  return true;
}

void TolerancedMotionModel::constraints(std::span<const double> x, std::span<double> c,
                                        std::span<double> jacobian) const {
  const std::vector<double> nominal = without_changes(x);
  if (jacobian.empty()) return nominal_.constraints(nominal, c, {});
  const std::size_t narrow = before_changes(), wide = narrow + changes;
  std::vector<double> by_nominal(narrow * c.size());
  nominal_.constraints(nominal, c, by_nominal);
  std::ranges::fill(jacobian, 0.0);
  for (std::size_t row = 0; row < c.size(); ++row) {
    std::copy_n(by_nominal.begin() + static_cast<std::ptrdiff_t>(row * narrow), narrow,
                jacobian.begin() + static_cast<std::ptrdiff_t>(row * wide));
  }
}

}  // namespace cognate::problems
