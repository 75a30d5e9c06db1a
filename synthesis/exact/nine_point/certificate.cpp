#include "synthesis/exact/nine_point/certificate.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "synthesis/exact/nine_point/ball.hpp"
#include "synthesis/exact/nine_point/position_miss.hpp"

namespace cognate::synthesis {
namespace {

using Complex = std::complex<double>;
using Long = boost::multiprecision::cpp_bin_float_quad;
using LongBall = Ball<Long>;
using DoubleBall = Ball<double>;

constexpr int kMost = 16;
/// The roundings that go into a root that Newton's method has settled in double.
constexpr double kRoundings = 1e3;
using Matrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;
using Vector = Eigen::Matrix<Complex, Eigen::Dynamic, 1, 0, kMost, 1>;

Complex rounded(const LongBall& z) {
  return {double(z.re), double(z.im)};
}

/// The ball of double middle that contains `z`.
DoubleBall wider(const LongBall& z) {
  const Complex middle = rounded(z);
  const double rounding = 0x1p-52 * (std::abs(middle.real()) + std::abs(middle.imag()));
  return {middle.real(), middle.imag(), DoubleBall::enlarged(z.radius + rounding)};
}

/// The square system of a problem; unknowns are those of the pivots, then the rotations not given.
class Equations {
 public:
  Equations(const PathSystem& system, std::span<const SideCondition> conditions)
      : system_(system), conditions_(conditions) {}

  int given_rotations() const { return system_.kind.poses - 1; }
  int unknowns() const { return kPivotUnknowns + int(system_.d.size()) - given_rotations(); }
  int equations() const { return 2 * int(system_.d.size()) + int(conditions_.size()); }

  template <class B>
  std::vector<B> values(const std::vector<B>& z) const {
    std::vector<B> all;
    for (int j = 0; j < int(system_.d.size()); ++j) {
      const CouplerMove<B> to = displacement(z, j);
      all.push_back(dyad_equation(first(z), to).value);
      all.push_back(dyad_equation(second(z), to).value);
    }
    for (const SideCondition& condition : conditions_) {
      all.push_back(side_value(condition, pivot_unknowns(first(z), second(z))));
    }
    return all;
  }

  /// Calls `set(row, column, ball)` for what is not zero throughout.
  template <class B, class Set>
  void jacobian(const std::vector<B>& z, Set&& set) const {
    for (int j = 0; j < int(system_.d.size()); ++j) {
      const CouplerMove<B> to = displacement(z, j);
      for (int dyad = 0; dyad < 2; ++dyad) {
        const auto f = dyad_equation(dyad == 0 ? first(z) : second(z), to);
        const B partials[] = {f.moving, f.moving_bar, f.fixed, f.fixed_bar};
        for (int k = 0; k < 4; ++k) set(2 * j + dyad, 4 * dyad + k, partials[k]);
        if (j < given_rotations()) continue;
        set(2 * j + dyad, kPivotUnknowns + j - given_rotations(), f.log_t * to.inverse_t);
      }
    }
    for (int i = 0; i < int(conditions_.size()); ++i) {
      const auto gradient =
          side_gradient(conditions_[std::size_t(i)], pivot_unknowns(first(z), second(z)));
      for (int k = 0; k < kPivotUnknowns; ++k) {
        set(2 * int(system_.d.size()) + i, k, gradient[std::size_t(k)]);
      }
    }
  }

 private:
  template <class B>
  static Dyad<B> first(const std::vector<B>& z) {
    return {z[0], z[1], z[2], z[3]};
  }
  template <class B>
  static Dyad<B> second(const std::vector<B>& z) {
    return {z[4], z[5], z[6], z[7]};
  }
  template <class B>
  CouplerMove<B> displacement(const std::vector<B>& z, int j) const {
    const auto at = std::size_t(j);
    const B d(system_.d[at]), d_bar(std::conj(system_.d[at]));
    if (j < given_rotations()) return {B(system_.t[at]), B(std::conj(system_.t[at])), d, d_bar};
    const B& t = z[std::size_t(kPivotUnknowns + j - given_rotations())];
    return {t, inverse(t), d, d_bar};
  }

  const PathSystem& system_;
  std::span<const SideCondition> conditions_;
};

/// The unknowns of a root; nothing where it has not as many rotations as the system.
std::vector<Complex> unknowns_of(const PathSystem& system, const PathRoot& root) {
  if (root.rotations.size() != system.d.size()) return {};
  const auto pivots = pivot_unknowns(root.first, root.second);
  std::vector<Complex> all(pivots.begin(), pivots.end());
  all.insert(all.end(), root.rotations.begin() + (system.kind.poses - 1), root.rotations.end());
  return all;
}

PathRoot root_of(const PathSystem& system, PathRoot root, const std::vector<LongBall>& z) {
  const auto at = [&](int i) { return rounded(z[std::size_t(i)]); };
  root.first = {at(0), at(1), at(2), at(3)};
  root.second = {at(4), at(5), at(6), at(7)};
  const std::size_t given = std::size_t(system.kind.poses - 1);
  for (std::size_t j = given; j < root.rotations.size(); ++j) {
    root.rotations[j] = rounded(z[kPivotUnknowns + j - given]);
  }
  return root;
}

/// A square matrix of numbers of 113 bits, row by row.
class LongMatrix {
 public:
  explicit LongMatrix(int size) : size_(size), entries_(std::size_t(size) * std::size_t(size)) {}
  int size() const { return size_; }
  LongBall& operator()(int i, int k) { return entries_[std::size_t(i * size_ + k)]; }
  const LongBall& operator()(int i, int k) const { return entries_[std::size_t(i * size_ + k)]; }

 private:
  int size_;
  std::vector<LongBall> entries_;
};

LongBall middle_of(LongBall ball) {
  ball.radius = 0;
  return ball;
}

/// The approximate inverse by Gauss and Jordan's elimination with row pivots; any matrix where
/// there is none.
LongMatrix inverse_of(LongMatrix a) {
  const int n = a.size();
  LongMatrix result(n);
  for (int i = 0; i < n; ++i) result(i, i) = LongBall(Complex(1));
  for (int column = 0; column < n; ++column) {
    int pivot = column;
    for (int i = column + 1; i < n; ++i) {
      if (magnitude(a(i, column)) > magnitude(a(pivot, column))) pivot = i;
    }
    const LongBall reciprocal = middle_of(inverse(a(pivot, column)));
    for (int k = 0; k < n; ++k) {
      std::swap(a(pivot, k), a(column, k));
      std::swap(result(pivot, k), result(column, k));
      a(column, k) = middle_of(a(column, k) * reciprocal);
      result(column, k) = middle_of(result(column, k) * reciprocal);
    }
    for (int i = 0; i < n; ++i) {
      const LongBall factor = a(i, column);
      if (i == column) continue;
      for (int k = 0; k < n; ++k) {
        a(i, k) = middle_of(a(i, k) - factor * a(column, k));
        result(i, k) = middle_of(result(i, k) - factor * result(column, k));
      }
    }
  }
  return result;
}

class Prover {
 public:
  Prover(const Equations& equations, const std::vector<Complex>& start) : equations_(equations) {
    for (const Complex& z : start) {
      z_.emplace_back(z);
      weight_.push_back(1 + std::abs(z));
    }
  }

  const std::vector<LongBall>& middle() const { return z_; }
  double weight(int i) const { return weight_[std::size_t(i)]; }

  /// Newton's method, the residual with 113 bits. False where it goes astray.
  bool refine() {
    constexpr int kSteps = 8;
    constexpr double kSettled = 1e-28;
    for (int step = 0; step < kSteps; ++step) {
      const Matrix jacobian = middle_jacobian();
      const Vector correction = jacobian.partialPivLu().solve(residual());
      if (!correction.allFinite()) return false;
      for (int i = 0; i < size(); ++i) {
        LongBall& z = z_[std::size_t(i)];
        z.re -= correction[i].real();
        z.im -= correction[i].imag();
      }
      if (norm(correction) <= kSettled) break;
    }
    return true;
  }

  /// Makes the middle its own conjugate, as far as 113 bits allow.
  void symmetrise(int rotations_from) {
    for (std::size_t i = 0; i < kPivotUnknowns; i += 2) {
      LongBall &z = z_[i], &bar = z_[i + 1];
      const Long re = (z.re + bar.re) / 2, im = (z.im - bar.im) / 2;
      z = {re, im, 0};
      bar = {re, -im, 0};
    }
    for (std::size_t j = std::size_t(rotations_from); j < z_.size(); ++j) {
      const Long size = sqrt(z_[j].re * z_[j].re + z_[j].im * z_[j].im);
      z_[j] = {z_[j].re / size, z_[j].im / size, 0};
    }
  }

  void invert_jacobian() {
    inverse_ = middle_jacobian().inverse();
    long_inverse_.reset();
  }

  /// From now on inverts and bounds the Jacobian with 113 bits: for roots so far out, or so near to
  /// singular, that its rounding in double times its condition leaves nothing to prove.
  void invert_jacobian_long() {
    LongMatrix jacobian(size());
    equations_.jacobian(
        z_, [&](int row, int column, const LongBall& ball) { jacobian(row, column) = ball; });
    long_inverse_ = inverse_of(std::move(jacobian));
  }

  /// An upper bound of ‖Y F(z)‖.
  double correction_bound() const {
    const auto values = equations_.values(z_);
    double bound = 0;
    for (int i = 0; i < size(); ++i) {
      LongBall total;
      for (int k = 0; k < size(); ++k) {
        const LongBall entry = long_inverse_ ? (*long_inverse_)(i, k) : LongBall(inverse_(i, k));
        total = total + entry * values[std::size_t(k)];
      }
      bound = larger(bound, (magnitude(total) + total.radius) / weight(i));
    }
    return DoubleBall::enlarged(bound);
  }

  /// An upper bound of ‖I − Y F′‖ over the polydisc of radius r.
  double contraction_bound(double r) const {
    return long_inverse_ ? long_contraction_bound(r) : double_contraction_bound(r);
  }

 private:
  double double_contraction_bound(double r) const {
    std::vector<DoubleBall> z;
    for (int i = 0; i < size(); ++i) {
      z.push_back(wider(z_[std::size_t(i)]));
      z.back().radius = DoubleBall::enlarged(z.back().radius + r * weight(i));
    }
    Matrix middle = Matrix::Zero(size(), size());
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost> spread =
        middle.cwiseAbs();
    equations_.jacobian(z, [&](int row, int column, const DoubleBall& ball) {
      middle(row, column) = {ball.re, ball.im};
      // Sixteen products are summed below, each of their roundings within a few units.
      spread(row, column) = DoubleBall::enlarged(ball.radius + 0x1p-47 * magnitude(ball));
    });
    const Matrix defect = Matrix::Identity(size(), size()) - inverse_ * middle;
    const auto rest = (inverse_.cwiseAbs() * spread).eval();
    double bound = 0;
    for (int i = 0; i < size(); ++i) {
      double sum = 0;
      for (int k = 0; k < size(); ++k) {
        sum += (std::abs(defect(i, k)) * (1 + 0x1p-48) + rest(i, k)) * weight(k);
      }
      bound = larger(bound, sum / weight(i));
    }
    return bound * (1 + 0x1p-44) + 1e-15;
  }

  double long_contraction_bound(double r) const {
    std::vector<LongBall> z = z_;
    for (int i = 0; i < size(); ++i) {
      z[std::size_t(i)].radius = DoubleBall::enlarged(r * weight(i));
    }
    LongMatrix jacobian(size());
    equations_.jacobian(
        z, [&](int row, int column, const LongBall& ball) { jacobian(row, column) = ball; });
    double bound = 0;
    for (int i = 0; i < size(); ++i) {
      double sum = 0;
      for (int k = 0; k < size(); ++k) {
        LongBall defect(Complex(i == k ? 1 : 0));
        for (int j = 0; j < size(); ++j) {
          defect = defect - (*long_inverse_)(i, j) * jacobian(j, k);
        }
        sum += DoubleBall::enlarged(magnitude(defect) + defect.radius) * weight(k);
      }
      bound = larger(bound, sum / weight(i));
    }
    return bound * (1 + 0x1p-44);
  }

  int size() const { return int(z_.size()); }
  double norm(const Vector& v) const {
    double largest = 0;
    for (int i = 0; i < size(); ++i) largest = larger(largest, std::abs(v[i]) / weight(i));
    return largest;
  }
  Matrix middle_jacobian() const {
    std::vector<DoubleBall> z;
    for (const LongBall& at : z_) z.emplace_back(rounded(at));
    Matrix jacobian = Matrix::Zero(size(), size());
    equations_.jacobian(z, [&](int row, int column, const DoubleBall& ball) {
      jacobian(row, column) = {ball.re, ball.im};
    });
    return jacobian;
  }
  Vector residual() const {
    const auto values = equations_.values(z_);
    Vector all(size());
    for (int i = 0; i < size(); ++i) all[i] = rounded(values[std::size_t(i)]);
    return all;
  }

  const Equations& equations_;
  std::vector<LongBall> z_;  // of radius 0
  std::vector<double> weight_;
  Matrix inverse_;
  std::optional<LongMatrix> long_inverse_;  // instead of the one above, where it is there
};

/// The largest radius tried on which T halves distances at least; 0 where none does.
double halving_radius(const Prover& prover) {
  constexpr double kLargest = 1e-2, kLeast = 1e-26;
  double r = kLargest;
  while (r > kLeast) {
    const double contraction = prover.contraction_bound(r);
    if (contraction <= 0.5) return r;
    // The bound grows about in proportion to r; NaN and infinity ask for a longer step.
    r *= contraction < 1e6 ? std::clamp(0.4 / contraction, 1e-4, 0.5) : 1e-4;
  }
  return 0;
}

/// How far `from` is from the middle, in the weighted norm.
double distance(const Prover& prover, const std::vector<Complex>& from) {
  double largest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const LongBall gap = prover.middle()[i] - LongBall(from[i]);
    largest = larger(largest, (magnitude(gap) + gap.radius) / prover.weight(int(i)));
  }
  return DoubleBall::enlarged(largest);
}

/// How far the conjugate of a zero within `radius` of the middle can be from the middle.
double conjugate_distance(const Prover& prover, double radius) {
  const auto& z = prover.middle();
  double largest = 0;
  const auto take = [&](const LongBall& image, int i) {
    const LongBall gap = image - LongBall(z[std::size_t(i)].re, z[std::size_t(i)].im, 0);
    largest = larger(largest, (magnitude(gap) + gap.radius) / prover.weight(i));
  };
  for (int i = 0; i < int(z.size()); ++i) {
    const bool pivot = i < kPivotUnknowns;
    const int partner = pivot ? (i ^ 1) : i;
    LongBall zero = z[std::size_t(partner)];
    zero.radius = DoubleBall::enlarged(radius * prover.weight(partner));
    if (!pivot) zero = inverse(zero);
    take({zero.re, -zero.im, zero.radius}, i);
  }
  return DoubleBall::enlarged(largest);
}

bool is_conjugate_of_itself(const std::vector<Complex>& z) {
  constexpr double kNear = 1e-6;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const Complex image = i < kPivotUnknowns ? std::conj(z[i ^ 1]) : 1.0 / std::conj(z[i]);
    if (!(std::abs(image - z[i]) <= kNear * (1 + std::abs(z[i])))) return false;
  }
  return true;
}

}  // namespace

RootCertificate certify(const PathSystem& system, const PathRoot& root,
                        std::span<const SideCondition> conditions) {
  RootCertificate certificate;
  certificate.refined = root;
  const Equations equations(system, conditions);
  const std::vector<Complex> start = unknowns_of(system, root);
  if (int(start.size()) != equations.unknowns() || equations.unknowns() > kMost ||
      equations.equations() != equations.unknowns()) {
    return certificate;
  }
  Prover prover(equations, start);
  if (!prover.refine()) return certificate;
  if (is_conjugate_of_itself(start)) prover.symmetrise(kPivotUnknowns);
  prover.invert_jacobian();
  double unique = halving_radius(prover);
  if (unique == 0) {
    prover.invert_jacobian_long();
    unique = halving_radius(prover);
  }
  // T halves distances within `unique`, so that twice the first step is a radius that holds.
  const double radius = 2.1 * prover.correction_bound();
  const double moved = distance(prover, start);
  // No nearer than this to a true root can a root be brought in double, by its condition.
  const double in_doubt = kRoundings * std::numeric_limits<double>::epsilon() * root.condition;
  const bool is_near = moved <= unique || moved <= in_doubt;
  if (!(unique > 0 && radius < unique && is_near)) return certificate;

  certificate.certified = true;
  certificate.refined = root_of(system, root, prover.middle());
  certificate.unique_within = unique;
  certificate.radius = DoubleBall::enlarged(radius + 0x1p-52);  // that of the doubles in `refined`
  certificate.distance = DoubleBall::enlarged(radius + moved);
  certificate.real = conjugate_distance(prover, radius) <= unique;
  return certificate;
}

}  // namespace cognate::synthesis
