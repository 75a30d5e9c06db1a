#include "synthesis/exact/function/slider_crank_function.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/vec2.hpp"
#include "synthesis/exact/binary_form.hpp"
#include "synthesis/exact/function/slider_equation.hpp"
#include "synthesis/exact/null_plane.hpp"
#include "synthesis/exact/polish.hpp"

namespace cognate::synthesis {
namespace {

/// The share of a unit vector of the null space by which it may miss h = 0 and R = 0 and still be
/// a Scotch yoke's, and by which other roots differ from it: that root is double, so rounding
/// splits it by its square root.
constexpr double kYokeShare = 1e-11;
constexpr double kYokeNeighbourhood = 1e-5;

/// The equations in r, w, c and those starts that are to be found.
template <int N>
class SliderEquations {
 public:
  SliderEquations(const SliderRows& rows, const GivenStart& start) : rows_(rows), start_(start) {}

  Linearised<N> operator()(const Unknowns<N>& x) const {
    const auto [phi, origin] = start_of(x);
    const Vec2d e = unit_vector(phi);
    const double r = x[0], w = x[1], c = x[2];
    Linearised<N> result;
    for (int i = 0; i < N; ++i) {
      const SliderRow& row = rows_[static_cast<std::size_t>(i)];
      const Vec2d d = row.u * e, sd = (row.su + origin * row.u) * e;
      const double square = row.square + origin * (2 * row.s + origin * row.constant);
      const double scale = std::abs(row.square) + 2 * std::abs(origin * row.s) +
                           origin * origin * row.constant + 2 * std::abs(r) * norm1(sd) +
                           2 * std::abs(w) * norm1(d) + std::abs(c) * row.constant;
      result.value[i] = (square - 2 * r * sd.x - 2 * w * d.y + c * row.constant) / scale;
      result.slope(i, 0) = -2 * sd.x / scale;
      result.slope(i, 1) = -2 * d.y / scale;
      result.slope(i, 2) = row.constant / scale;
      const double by_input = 2 * (r * sd.y - w * d.x);
      const double by_output = 2 * (row.s + origin * row.constant - r * d.x);
      if constexpr (N == 4) result.slope(i, 3) = (start_.input ? by_output : by_input) / scale;
      if constexpr (N == 5) {
        result.slope(i, 3) = by_input / scale;
        result.slope(i, 4) = by_output / scale;
      }
    }
    return result;
  }

  Unknowns<N> unknowns(const SliderCoefficients& c) const {
    Unknowns<N> x;
    x[0] = c.r / c.h;
    x[1] = c.w / c.h;
    x[2] = c.c / c.h;
    if constexpr (N == 4) x[3] = start_.input ? c.output_start : c.input_start;
    if constexpr (N == 5) {
      x[3] = c.input_start;
      x[4] = c.output_start;
    }
    return x;
  }

  SliderCoefficients coefficients(const Unknowns<N>& x) const {
    const auto [phi, origin] = start_of(x);
    return {1, x[0], x[1], x[2], phi, origin};
  }

 private:
  /// The start displacement counts from the scaled origin, which is the foot where it is given.
  std::array<double, 2> start_of(const Unknowns<N>& x) const {
    if constexpr (N == 5) return {x[3], x[4]};
    if constexpr (N == 4) {
      return start_.input ? std::array{*start_.input, x[3]} : std::array{x[3], 0.0};
    }
    return {*start_.input, 0.0};
  }

  const SliderRows& rows_;
  const GivenStart& start_;
};

/// The solution that `c` leads to, unless it is none.
template <int N>
void add_solution(const SliderSetting& setting, const SliderCoefficients& c,
                  SliderCrankFunctions& result) {
  const SliderEquations<N> equations(setting.rows, setting.start);
  const Root<N> root = polish<N>(equations, equations.unknowns(c));
  if (!(root.residual <= kAcceptedSliderResidual)) return;
  SliderCrankFunction found = slider_linkage(equations.coefficients(root.x), setting);
  found.residual = root.residual;
  found.condition = root.condition;
  result.solutions.push_back(found);
}

/// A Scotch yoke s = s₀ + Re(Qu)/p: no square and no S cos θ in its equation.
void add_yoke(double q, double p, const SliderSetting& setting, SliderCrankFunctions& result) {
  if (std::abs(p) > kInfiniteSliderRatio) {
    add_slider_limit(SliderCrankOutcome::scotch_yoke, setting.scale.unit * q / std::abs(p), result);
  } else {
    add_slider_limit(SliderCrankOutcome::infinite_links, 0, result);
  }
}

/// The size of the parts of `x` that vanish for a Scotch yoke.
template <class Vector, std::size_t Count>
double yoke_share(const Vector& x, const std::array<int, Count>& vanishing) {
  double square = 0;
  for (const int i : vanishing) square += x[i] * x[i];
  return std::sqrt(square);
}

/// The direction in the plane of u and v in which the parts that vanish for a Scotch yoke are
/// least.
template <class Vector, std::size_t Count>
Vector nearest_yoke(const Vector& u, const Vector& v, const std::array<int, Count>& vanishing) {
  double uu = 0, uv = 0, vv = 0;
  for (const int i : vanishing) {
    uu += u[i] * u[i];
    uv += u[i] * v[i];
    vv += v[i] * v[i];
  }
  const Vec2d t = unit_vector(0.5 * std::atan2(2 * uv, uu - vv) + kRightAngle);
  return t.x * u + t.y * v;
}

/// The roots of the form on the plane of u and v, as vectors of it; where a Scotch yoke is among
/// them it is left out, and `yoke` is its vector.
template <class Vector>
struct PlaneRoots {
  InPlaceVector<Vector, 3> roots;
  std::optional<Vector> yoke;
};

template <class Vector, std::size_t Count, std::size_t Degree>
PlaneRoots<Vector> plane_roots(const Vector& u, const Vector& v,
                               const std::array<double, Degree>& form,
                               const std::array<int, Count>& vanishing) {
  PlaneRoots<Vector> result;
  const Vector yoke = nearest_yoke(u, v, vanishing);
  if (yoke_share(yoke, vanishing) <= kYokeShare) result.yoke = yoke;
  for (const Vec2d& root : real_roots(form)) {
    const Vector x = root.x * u + root.y * v;
    const bool split = result.yoke && yoke_share(x, vanishing) <= kYokeNeighbourhood;
    if (!split) result.roots.push_back(x);
  }
  return result;
}

SliderCrankFunctions with_both_given(const SliderSetting& setting) {
  const Vec2d e = unit_vector(*setting.start.input);
  Eigen::Matrix<double, 3, 4> m;
  for (int i = 0; i < 3; ++i) {
    const SliderRow& row = setting.rows[static_cast<std::size_t>(i)];
    m.row(i) << row.square, -2 * (row.su * e).x, -2 * (row.u * e).y, row.constant;
  }
  SliderCrankFunctions result;
  const auto basis = null_basis<1>(m);
  result.dependent = !basis;
  if (!basis) return result;
  const auto& v = (*basis)[0];
  const auto outcome = infinite_slider_part(v[0], v[1]);
  if (outcome == SliderCrankOutcome::linkage) {
    add_solution<3>(setting, {v[0], v[1], v[2], v[3], *setting.start.input, 0}, result);
  } else {
    add_slider_limit(outcome, 0, result);
  }
  return result;
}

/// Unknown in addition to the lengths: the start displacement p/h. Columns s², s, s cos θ, cos θ,
/// sin θ, 1 with coefficients h, 2p, −2r, −2q, −2w, c; q·h = p·r.
SliderCrankFunctions with_input_given(const SliderSetting& setting) {
  const Vec2d e = unit_vector(*setting.start.input);
  Eigen::Matrix<double, 4, 6> m;
  for (int i = 0; i < 4; ++i) {
    const SliderRow& row = setting.rows[static_cast<std::size_t>(i)];
    const Vec2d d = row.u * e;
    m.row(i) << row.square, 2 * row.s, -2 * (row.su * e).x, -2 * d.x, -2 * d.y, row.constant;
  }
  SliderCrankFunctions result;
  const auto basis = null_basis<2>(m);
  result.dependent = !basis;
  if (!basis) return result;
  using Vector = Eigen::Matrix<double, 6, 1>;
  const auto products_differ = [](const Vector& a, const Vector& b) {
    return a[3] * b[0] - a[1] * b[2];
  };
  const auto& [u, v] = *basis;
  const auto found = plane_roots(u, v, quadratic_form(products_differ, u, v), std::array{0, 2});
  if (found.yoke)
    add_yoke(std::hypot((*found.yoke)[3], (*found.yoke)[4]), (*found.yoke)[1], setting, result);
  for (const Vector& x : found.roots) {
    const auto outcome = infinite_slider_part(x[0], x[2]);
    if (outcome != SliderCrankOutcome::linkage) {
      add_slider_limit(outcome, 0, result);
      continue;
    }
    const double origin = x[1] / x[0];
    // C of the file's comment holds s₀², the equation's own constant does not: r² + e² − l².
    const double c = x[5] - origin * x[1];
    add_solution<4>(setting, {x[0], x[2], x[4], c, *setting.start.input, origin}, result);
  }
  return result;
}

/// Unknown in addition to the lengths: the start angle. Columns S², −2Su, −2u, 1 with coefficients
/// h, R, Q and c; Re(Q conj R) = 0.
SliderCrankFunctions with_output_given(const SliderSetting& setting) {
  Eigen::Matrix<double, 4, 6> m;
  for (int i = 0; i < 4; ++i) {
    const SliderRow& row = setting.rows[static_cast<std::size_t>(i)];
    m.row(i) << row.square, -2 * row.su.x, 2 * row.su.y, -2 * row.u.x, 2 * row.u.y, row.constant;
  }
  SliderCrankFunctions result;
  const auto basis = null_basis<2>(m);
  result.dependent = !basis;
  if (!basis) return result;
  using Vector = Eigen::Matrix<double, 6, 1>;
  const auto along = [](const Vector& a, const Vector& b) { return a[3] * b[1] + a[4] * b[2]; };
  const auto& [u, v] = *basis;
  for (const Vec2d& root : real_roots(quadratic_form(along, u, v))) {
    const Vector x = root.x * u + root.y * v;
    const Vec2d r{x[1], x[2]}, q{x[3], x[4]};
    const auto outcome = infinite_slider_part(x[0], norm(r));
    if (outcome != SliderCrankOutcome::linkage) {
      add_slider_limit(outcome, 0, result);
      continue;
    }
    // Q = −ie·R.
    const double phi = angle_of(r);
    const double w = -(q * unit_vector(-phi)).y;
    add_solution<4>(setting, {x[0], norm(r), w, x[5], phi, 0}, result);
  }
  return result;
}

SliderCrankFunctions with_none_given(const SliderSetting& setting) {
  Eigen::Matrix<double, 5, 7> m;
  for (int i = 0; i < 5; ++i) {
    const SliderRow& row = setting.rows[static_cast<std::size_t>(i)];
    m.row(i) << row.square, 2 * row.s, -2 * row.su.x, 2 * row.su.y, -2 * row.u.x, 2 * row.u.y,
        row.constant;
  }
  SliderCrankFunctions result;
  const auto basis = null_basis<2>(m);
  result.dependent = !basis;
  if (!basis) return result;
  using Vector = Eigen::Matrix<double, 7, 1>;
  // h·Re(Q conj R) − p|R|².
  const auto starts_differ = [](const Vector& a, const Vector& b, const Vector& c) {
    return a[0] * (b[4] * c[2] + b[5] * c[3]) - a[1] * (b[2] * c[2] + b[3] * c[3]);
  };
  const auto& [u, v] = *basis;
  const auto found = plane_roots(u, v, cubic_form(starts_differ, u, v), std::array{0, 2, 3});
  if (found.yoke)
    add_yoke(norm(Vec2d{(*found.yoke)[4], (*found.yoke)[5]}), (*found.yoke)[1], setting, result);
  for (const Vector& x : found.roots) {
    const Vec2d r{x[2], x[3]}, q{x[4], x[5]};
    const auto outcome = infinite_slider_part(x[0], norm(r));
    if (outcome != SliderCrankOutcome::linkage) {
      add_slider_limit(outcome, 0, result);
      continue;
    }
    const double phi = angle_of(r);
    const double origin = x[1] / x[0];
    const double w = -(q * unit_vector(-phi)).y;
    add_solution<5>(setting, {x[0], norm(r), w, x[6] - origin * x[1], phi, origin}, result);
  }
  return result;
}

}  // namespace

SliderCrankFunctions slider_crank_functions(std::span<const PrecisionPoint> points,
                                            const GivenStart& start) {
  assert(condition_count(points) ==
         static_cast<std::size_t>(3 + int{!start.input} + int{!start.output}));
  const SliderScale scale = slider_scale(points, start);
  const SliderRows rows = slider_rows(points, scale);
  const SliderSetting setting{rows, start, scale};
  if (start.input && start.output) return with_both_given(setting);
  if (start.input) return with_input_given(setting);
  return start.output ? with_output_given(setting) : with_none_given(setting);
}

}  // namespace cognate::synthesis
