#include "synthesis/exact/function/four_bar_function.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/vec2.hpp"
#include "synthesis/exact/binary_form.hpp"
#include "synthesis/exact/null_plane.hpp"
#include "synthesis/exact/polish.hpp"

namespace cognate::synthesis {
namespace {

/// A coefficient below this share of the largest makes a link infinite: what cannot be
/// distinguished from zero by rounding times condition, or no length anybody could mean.
double infinite_ratio(double condition) {
  return std::clamp(16 * std::numeric_limits<double>::epsilon() * condition, 1e-12, 1e-8);
}

/// A vector of the null space solves the equations to within rounding; what a double root that is
/// none leaves behind does not.
constexpr double kAcceptedResidual = 1e-11;

/// One condition, Re(X·input) + Re(Y·output) + K₃·constant = Re(Z·difference): series coefficients
/// of e^{iφ}, e^{iψ}, 1 and e^{i(φ−ψ)}.
struct Row {
  Vec2d input, output;
  double constant = 0;
  Vec2d difference;
};
using Rows = InPlaceVector<Row, kMostConditions>;

Rows rows_of(std::span<const PrecisionPoint> points) {
  Rows rows;
  for (const PrecisionPoint& point : points) {
    const std::size_t count = point.multiplicity;
    const RealSeries psi = output_series(point);
    RealSeries phi{point.input, 1};
    RealSeries delta{point.input - psi[0], 1 - psi[1]};
    for (std::size_t k = 2; k < count; ++k) delta[k] = -psi[k];
    const ComplexSeries a = direction_series(phi, count);
    const ComplexSeries b = direction_series(psi, count);
    const ComplexSeries c = direction_series(delta, count);
    for (std::size_t k = 0; k < count; ++k) rows.push_back({a[k], b[k], k == 0 ? 1.0 : 0.0, c[k]});
  }
  return rows;
}

/// The equation's coefficients up to a common factor, and the start angles that go with them:
/// k₁ cos θ₁ + k₂ cos θ₃ + k₃ = k₄ cos(θ₁ − θ₃).
struct Coefficients {
  std::array<double, 4> k{};
  double input_start = 0, output_start = 0;
};

/// The equations in K₁, K₂, K₃ and those start angles that are to be found.
template <int N>
class Equations {
 public:
  Equations(const Rows& rows, const GivenStart& start) : rows_(rows), start_(start) {}

  Linearised<N> operator()(const Unknowns<N>& x) const {
    const auto [phi, psi] = start_of(x);
    const Vec2d e1 = unit_vector(phi), e3 = unit_vector(psi);
    Linearised<N> result;
    for (int i = 0; i < N; ++i) {
      const Row& row = rows_[static_cast<std::size_t>(i)];
      const Vec2d a = row.input * e1, b = row.output * e3, c = row.difference * (e1 * conj(e3));
      const double scale = std::abs(x[0]) * norm1(a) + std::abs(x[1]) * norm1(b) +
                           std::abs(x[2]) * row.constant + norm1(c);
      const double by_input = c.y - x[0] * a.y, by_output = -c.y - x[1] * b.y;
      result.value[i] = (x[0] * a.x + x[1] * b.x + x[2] * row.constant - c.x) / scale;
      result.slope(i, 0) = a.x / scale;
      result.slope(i, 1) = b.x / scale;
      result.slope(i, 2) = row.constant / scale;
      if constexpr (N == 4) result.slope(i, 3) = (start_.input ? by_output : by_input) / scale;
      if constexpr (N == 5) {
        result.slope(i, 3) = by_input / scale;
        result.slope(i, 4) = by_output / scale;
      }
    }
    return result;
  }

  Unknowns<N> unknowns(const Coefficients& c) const {
    Unknowns<N> x;
    for (int i = 0; i < 3; ++i) x[i] = c.k[static_cast<std::size_t>(i)] / c.k[3];
    if constexpr (N == 4) x[3] = start_.input ? c.output_start : c.input_start;
    if constexpr (N == 5) {
      x[3] = c.input_start;
      x[4] = c.output_start;
    }
    return x;
  }

  Coefficients coefficients(const Unknowns<N>& x) const {
    const auto [phi, psi] = start_of(x);
    return {{x[0], x[1], x[2], 1}, phi, psi};
  }

 private:
  std::array<double, 2> start_of(const Unknowns<N>& x) const {
    if constexpr (N == 5) return {x[3], x[4]};
    if constexpr (N == 4) {
      return start_.input ? std::array{*start_.input, x[3]} : std::array{x[3], *start_.output};
    }
    return {*start_.input, *start_.output};
  }

  const Rows& rows_;
  const GivenStart& start_;
};

/// Which coefficient has vanished, if any.
FourBarOutcome infinite_part(const std::array<double, 4>& k, double condition) {
  double largest = 0;
  for (const double value : k) largest = std::max(largest, std::abs(value));
  const double least = infinite_ratio(condition) * largest;
  if (!(std::abs(k[3]) > least)) return FourBarOutcome::infinite_frame;
  const bool no_input = !(std::abs(k[0]) > least), no_output = !(std::abs(k[1]) > least);
  if (no_input && no_output) return FourBarOutcome::rigid;
  if (no_input) return FourBarOutcome::infinite_rocker;
  return no_output ? FourBarOutcome::infinite_crank : FourBarOutcome::linkage;
}

/// The links with their signs: negative ones point the other way.
struct SignedLinks {
  double crank = 1, rocker = 1, frame = 1;
};

SignedLinks signed_links(FourBarOutcome outcome, const std::array<double, 4>& k) {
  switch (outcome) {
    case FourBarOutcome::infinite_rocker:
      return {.rocker = 0, .frame = k[1] / k[3]};
    case FourBarOutcome::infinite_crank:
      return {.crank = 0, .frame = -k[0] / k[3]};
    default:
      return {.rocker = -k[1] / k[0], .frame = k[1] / k[3]};
  }
}

/// The coupler in the first position: no difference of squares enters.
double coupler_length(const SignedLinks& links, const Coefficients& c, const Row& first) {
  const Vec2d e1 = first.input * unit_vector(c.input_start);
  const Vec2d e3 = first.output * unit_vector(c.output_start);
  return norm(Vec2d{links.frame, 0} + links.rocker * e3 - e1);
}

/// Lengths made positive, links that come out negative turned by half a turn.
FourBarFunction as_linkage(const Coefficients& c, const Row& first, double condition) {
  FourBarFunction result;
  result.condition = condition;
  result.outcome = infinite_part(c.k, condition);
  if (result.outcome == FourBarOutcome::rigid || result.outcome == FourBarOutcome::infinite_frame) {
    return result;
  }
  const SignedLinks links = signed_links(result.outcome, c.k);
  result.links = {links.crank, 0, std::abs(links.rocker), std::abs(links.frame)};
  result.input_turned = links.frame < 0;
  result.output_turned = (links.frame < 0) != (links.rocker < 0);
  result.input_start = c.input_start + (result.input_turned ? kPi : 0);
  result.output_start = c.output_start + (result.output_turned ? kPi : 0);
  if (result.outcome == FourBarOutcome::infinite_rocker) {
    result.guide_offset = (result.output_turned ? -1 : 1) * c.k[2] / c.k[3];
  }
  if (result.outcome != FourBarOutcome::linkage) return result;
  result.links.coupler = coupler_length(links, c, first);
  const double size = std::max({1.0, result.links.rocker, result.links.frame});
  const bool none = !(result.links.coupler > infinite_ratio(condition) * size);
  if (none) result.outcome = FourBarOutcome::no_coupler;
  return result;
}

/// The solution that `c` leads to; nothing where it leads to none.
template <int N>
void add_solution(const Rows& rows, const GivenStart& start, Coefficients c,
                  FourBarFunctions& result) {
  double residual = 0, condition = 1;
  if (infinite_part(c.k, condition) != FourBarOutcome::infinite_frame) {
    const Equations<N> equations(rows, start);
    const Root<N> root = polish<N>(equations, equations.unknowns(c));
    if (!(root.residual <= kAcceptedResidual)) return;
    c = equations.coefficients(root.x);
    residual = root.residual;
    condition = root.condition;
  }
  FourBarFunction found = as_linkage(c, rows[0], condition);
  found.residual = residual;
  if (!start.input) found.input_turned = false;
  if (!start.output) found.output_turned = false;
  result.solutions.push_back(found);
}

FourBarFunctions with_both_given(const Rows& rows, const GivenStart& start) {
  const Vec2d e1 = unit_vector(*start.input), e3 = unit_vector(*start.output);
  Eigen::Matrix<double, 3, 4> m;
  for (int i = 0; i < 3; ++i) {
    const Row& row = rows[static_cast<std::size_t>(i)];
    m.row(i) << (row.input * e1).x, (row.output * e3).x, row.constant,
        -(row.difference * (e1 * conj(e3))).x;
  }
  FourBarFunctions result;
  const auto basis = null_basis<1>(m);
  result.dependent = !basis;
  if (!basis) return result;
  const auto& v = (*basis)[0];
  add_solution<3>(rows, start, {{v[0], v[1], v[2], v[3]}, *start.input, *start.output}, result);
  return result;
}

/// The unknowns are the coefficient of the link whose start angle is given, the complex one of the
/// other link, K₃, and W, Z without the given angle's part.
FourBarFunctions with_one_given(const Rows& rows, const GivenStart& start) {
  const bool input_given = start.input.has_value();
  const Vec2d e = unit_vector(input_given ? *start.input : *start.output);
  Eigen::Matrix<double, 4, 6> m;
  for (int i = 0; i < 4; ++i) {
    const Row& row = rows[static_cast<std::size_t>(i)];
    const double known = ((input_given ? row.input : row.output) * e).x;
    const Vec2d free = input_given ? row.output : row.input;
    const Vec2d w = row.difference * (input_given ? e : conj(e));
    m.row(i) << known, free.x, -free.y, row.constant, -w.x, w.y;
  }
  FourBarFunctions result;
  const auto basis = null_basis<2>(m);
  result.dependent = !basis;
  if (!basis) return result;
  using Vector = Eigen::Matrix<double, 6, 1>;
  // The other link's phase ψ₀ stands in Y as e^{iψ₀} and in W as e^{−iψ₀}; φ₀ in both as e^{iφ₀}.
  const auto phases_differ = [&](const Vector& a, const Vector& b) {
    return input_given ? a[1] * b[5] + a[2] * b[4] : a[2] * b[4] - a[1] * b[5];
  };
  const auto& [u, v] = *basis;
  for (const Vec2d& root : real_roots(quadratic_form(phases_differ, u, v))) {
    const Vector x = root.x * u + root.y * v;
    const Vec2d free{x[1], x[2]}, w{x[4], input_given ? -x[5] : x[5]};
    // W may be short where the frame is long, the link's own coefficient where the link is.
    const double other = squared_norm(w) >= squared_norm(free) ? angle_of(w) : angle_of(free);
    const Vec2d back = unit_vector(-other);
    const double known = x[0], found = (free * back).x;
    const Coefficients c{
        {input_given ? known : found, input_given ? found : known, x[3], (w * back).x},
        start.input.value_or(other),
        start.output.value_or(other)};
    add_solution<4>(rows, start, c, result);
  }
  return result;
}

FourBarFunctions with_none_given(const Rows& rows, const GivenStart& start) {
  Eigen::Matrix<double, 5, 7> m;
  for (int i = 0; i < 5; ++i) {
    const auto& [a, b, d, c] = rows[static_cast<std::size_t>(i)];
    m.row(i) << a.x, -a.y, b.x, -b.y, d, -c.x, c.y;
  }
  FourBarFunctions result;
  const auto basis = null_basis<2>(m);
  result.dependent = !basis;
  if (!basis) return result;
  using Vector = Eigen::Matrix<double, 7, 1>;
  // Im(X·conj Y·conj Z).
  const auto phases_differ = [](const Vector& x, const Vector& y, const Vector& z) {
    const Vec2d xy = Vec2d{x[0], x[1]} * Vec2d{y[2], -y[3]};
    return (xy * Vec2d{z[5], -z[6]}).y;
  };
  const auto& [u, v] = *basis;
  for (const Vec2d& root : real_roots(cubic_form(phases_differ, u, v))) {
    const Vector p = root.x * u + root.y * v;
    const Vec2d x{p[0], p[1]}, y{p[2], p[3]}, z{p[5], p[6]};
    // Of the three phases, one of which follows from the others, the two best determined.
    const double xx = squared_norm(x), yy = squared_norm(y), zz = squared_norm(z);
    const bool z_least = zz <= xx && zz <= yy;
    const double psi = !z_least && xx > yy ? angle_of(x) - angle_of(z) : angle_of(y);
    const double phi = z_least || xx > yy ? angle_of(x) : psi + angle_of(z);
    const Coefficients c{{(x * unit_vector(-phi)).x, (y * unit_vector(-psi)).x, p[4],
                          (z * unit_vector(psi - phi)).x},
                         phi,
                         psi};
    add_solution<5>(rows, start, c, result);
  }
  return result;
}

}  // namespace

FourBarFunctions four_bar_functions(std::span<const PrecisionPoint> points,
                                    const GivenStart& start) {
  const int unknown = int{!start.input} + int{!start.output};
  assert(condition_count(points) == static_cast<std::size_t>(3 + unknown));
  const Rows rows = rows_of(points);
  if (unknown == 0) return with_both_given(rows, start);
  return unknown == 1 ? with_one_given(rows, start) : with_none_given(rows, start);
}

}  // namespace cognate::synthesis
