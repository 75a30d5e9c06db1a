#include "synthesis/exact/motion/cubic_pencil.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/motion/quartic_signs.hpp"

namespace cognate::synthesis {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = kPi;

/// Values of the cubic below this, its forms being of norm 1, are none.
constexpr double kVanishes = 1e-14;
/// Relative to the cubic's size: within this it is taken to contain a line.
constexpr double kFactor = 1e-12;

double determinant(const ThreeForms& f, const Vector3d& x, const Vector3d& y, const Vector3d& z) {
  return (f[0] * x).dot((f[1] * y).cross(f[2] * z));
}

double greatest(const std::vector<double>& c) {
  double result = 0;
  for (const double k : c) result = std::max(result, std::abs(k));
  return result;
}

/// The form less the factor (y₀ x − x₀ y), which vanishes at `root`.
std::vector<double> divided(const std::vector<double>& c, const Vector2d& root) {
  std::vector<double> result(c.size() - 1);
  if (std::abs(root.y()) >= std::abs(root.x())) {
    double carried = 0;
    for (std::size_t k = 0; k < result.size(); ++k) {
      carried = (c[k] + root.x() * carried) / root.y();
      result[k] = carried;
    }
    return result;
  }
  double carried = 0;
  for (std::size_t k = result.size(); k-- > 0;) {
    carried = (root.y() * carried - c[k + 1]) / root.x();
    result[k] = carried;
  }
  return result;
}

std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

Vector2d unit_2d(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

std::array<double, 4> cubic_on_line(const ThreeForms& f, const Vector3d& p, const Vector3d& q) {
  return {determinant(f, p, p, p),
          determinant(f, q, p, p) + determinant(f, p, q, p) + determinant(f, p, p, q),
          determinant(f, p, q, q) + determinant(f, q, p, q) + determinant(f, q, q, p),
          determinant(f, q, q, q)};
}

CubicPencil::CubicPencil(const ThreeForms& forms) {
  find_centre(forms);
  find_coefficients(forms);
  size_ = std::max({greatest(a_), greatest(b_), greatest(d_)});
  if (size_ <= kVanishes) {
    is_everything_ = true;
    return;
  }
  split_off_line();
  find_arcs();
}

/// At infinity a circular cubic is (x² + y²)(l₁x + l₂y). Without l it contains the line at
/// infinity, and the rest is a conic; the lines are then taken through a point that is not on the
/// conic.
void CubicPencil::find_centre(const ThreeForms& forms) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const Vector2d l(determinant(forms, x, x, x), determinant(forms, y, y, y));
  double size = 0, best = -1;
  Vector3d off_conic = x;
  for (const Vector3d& at :
       {x, y, Vector3d((x + y).normalized()), Vector3d((x - y).normalized())}) {
    const auto inwards = cubic_on_line(forms, at, z);
    for (const double c : inwards) size = std::max(size, std::abs(c));
    if (std::abs(inwards[1]) > best) {
      best = std::abs(inwards[1]);
      off_conic = at;
    }
  }
  has_line_at_infinity_ = l.norm() <= kFactor * size;
  centre_ = has_line_at_infinity_ ? off_conic : Vector3d(-l.y(), l.x(), 0).normalized();
  across_ = Vector3d(-centre_.y(), centre_.x(), 0);
  along_ = z;
}

void CubicPencil::find_coefficients(const ThreeForms& forms) {
  const auto x = cubic_on_line(forms, centre_, across_);
  const auto y = cubic_on_line(forms, centre_, along_);
  const auto sum = cubic_on_line(forms, centre_, across_ + along_);
  const auto difference = cubic_on_line(forms, centre_, across_ - along_);
  const double odd = 0.5 * (sum[3] - difference[3]), even = 0.5 * (sum[3] + difference[3]);
  a_ = {x[1], y[1]};
  b_ = {x[2], 0.5 * (sum[2] - difference[2]), y[2]};
  d_ = {x[3], odd - y[3], even - x[3], y[3]};
}

void CubicPencil::split_off_line() {
  const Vector2d slope(a_[0], a_[1]);
  if (!(slope.norm() > 0)) return;
  const Vector2d at = Vector2d(-slope.y(), slope.x()).normalized();
  const double rest = std::abs(binary_form(b_, at)) + std::abs(binary_form(d_, at));
  if (rest > kFactor * size_) return;
  arcs_.push_back({Kind::line, std::atan2(at.y(), at.x()), 0, 1});
  a_ = divided(a_, at);
  b_ = divided(b_, at);
  d_ = divided(d_, at);
}

void CubicPencil::find_arcs() {
  std::vector<double> square = product(b_, b_);
  const std::vector<double> other = product(a_, d_);
  for (std::size_t k = 0; k < square.size(); ++k) square[k] -= 4 * other[k];
  if (square.size() == 3) square = product(square, {1, 0, 1});  // x² + y² changes no sign
  std::ranges::copy(square, discriminant_.begin());

  const SignsOfQuartic signs = signs_of(discriminant_);
  nodes_.assign(signs.touches.begin(), signs.touches.end());
  const InPlaceVector<double, 4>& angles = signs.changes;
  if (angles.empty()) find_sheets();
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const bool last = k + 1 == angles.size();
    const double to = last ? angles[0] + pi : angles[k + 1];
    const double middle = 0.5 * (angles[k] + to);
    if (binary_form(discriminant_, unit_2d(middle)) > 0) {
      arcs_.push_back({Kind::loop, middle, 0.5 * (to - angles[k]), 1});
    }
  }
}

/// After half a turn of the line its two points have changed places where O lies off a conic, and
/// once more for each node.
void CubicPencil::find_sheets() {
  if (!(binary_form(discriminant_, {1, 0}) + binary_form(discriminant_, {0, 1}) > 0)) return;
  const bool is_conic = a_.size() == 1;
  const bool odd = nodes_.size() % 2 == 1;
  if (is_conic != odd) {
    arcs_.push_back({Kind::sheet, 0, 2 * pi, 1});
  } else {
    arcs_.push_back({Kind::sheet, 0, pi, 1});
    arcs_.push_back({Kind::sheet, 0, pi, -1});
  }
}

Vector3d CubicPencil::direction(double angle) const {
  return std::cos(angle) * across_ + std::sin(angle) * along_;
}

/// Between φ = 0 and `angle`, in [0, 2π].
int CubicPencil::nodes_before(double angle) const {
  int count = 0;
  for (const double node : nodes_) {
    count += angle > node;
    count += angle > node + pi;
  }
  return count;
}

Vector3d CubicPencil::root(double angle, int sheet) const {
  const int sign = nodes_before(angle) % 2 == 0 ? sheet : -sheet;
  const Vector2d at = unit_2d(angle);
  const double a = binary_form(a_, at), b = binary_form(b_, at), d = binary_form(d_, at);
  const double root = std::sqrt(std::max(b * b - 4 * a * d, 0.0));
  // The root of greater size is q/a, the other d/q.
  const double q = -0.5 * (b + std::copysign(root, b));
  const bool greater = (sign > 0) == (b < 0);
  const Vector2d s = greater ? Vector2d(q, a) : Vector2d(d, q);
  const Vector3d point = s.x() * centre_ + s.y() * direction(angle);
  return point.norm() > 0 ? point.normalized() : centre_;
}

Vector3d CubicPencil::at(int arc, double t) const {
  const Arc& curve = arcs_[static_cast<std::size_t>(arc)];
  const double turn = t - std::floor(t);
  switch (curve.kind) {
    case Kind::line: {
      const Vector2d s = unit_2d(pi * turn);
      return s.x() * direction(curve.middle) + s.y() * centre_;
    }
    case Kind::sheet:
      return root(curve.half * turn, curve.sheet);
    case Kind::loop:
      break;
  }
  const double angle = curve.middle - curve.half * std::cos(2 * pi * turn);
  return root(angle, turn < 0.5 ? 1 : -1);
}

}  // namespace cognate::synthesis
