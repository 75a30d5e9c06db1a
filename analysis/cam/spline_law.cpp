#include "analysis/cam/spline_law.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace cognate::cam {
namespace {

/// The knots of a spline with N = 1 (cubic) or 2 (quintic) derivatives by the share u of the
/// segment at each, which is what is sought.
template <std::size_t N>
struct Knots {
  std::vector<double> at, displacement;
  std::vector<std::array<double, N>> derivatives;
  bool periodic = false;

  std::size_t pieces() const { return at.size() - 1; }
  double half_width(std::size_t piece) const { return 0.5 * (at[piece + 1] - at[piece]); }
  double half_step(std::size_t piece) const {
    return 0.5 * (displacement[piece + 1] - displacement[piece]);
  }
  /// How many knots have unknown derivatives, and the place of `knot` among them, −1 if given.
  std::size_t unknowns() const { return periodic ? pieces() : pieces() - 1; }
  int unknown(std::size_t knot) const {
    if (periodic) return static_cast<int>(knot % pieces());
    return knot == 0 || knot == pieces() ? -1 : static_cast<int>(knot) - 1;
  }
};

/// A spline of degree 2N + 1 through given points is, of all functions through them, the one of
/// least E = ½ ∫ (s⁽ᴺ⁺¹⁾)² (Holladay, 1957; Schoenberg, 1964). For one piece over x in [−1, 1] with
/// the derivatives z = (s′, ..)(−1), (s′, ..)(1) and the half step D = (s(1) − s(−1))/2, the
/// gradient of E by z is stiffness · z − load · D; that the gradients of neighbours cancel is
/// continuity of the derivatives N + 1 to 2N.
template <std::size_t N>
struct Element;
template <>
struct Element<1> {
  static constexpr double stiffness[2][2]{{2, 1}, {1, 2}};
  static constexpr double load[2]{3, 3};
};
template <>
struct Element<2> {
  static constexpr double stiffness[4][4]{
      {24, 9, 21, -6}, {9, 4.5, 6, -1.5}, {21, 6, 24, -9}, {-6, -1.5, -9, 4.5}};
  static constexpr double load[4]{45, 15, 45, -15};
};

template <std::size_t N>
struct System {
  std::vector<Eigen::Triplet<double>> lower;
  Eigen::VectorXd load;
};

/// Adds a piece to the system. A derivative by u of order p is that by x over hᵖ, h half the width.
template <std::size_t N>
void add_element(const Knots<N>& knots, std::size_t piece, System<N>& system) {
  const double h = knots.half_width(piece);
  const double energy = std::pow(h, -static_cast<double>(2 * N + 1));
  const auto unknown = [&](std::size_t i) {
    const int knot = knots.unknown(piece + i / N);
    return knot < 0 ? -1 : static_cast<int>(N) * knot + static_cast<int>(i % N);
  };
  const auto scale = [&](std::size_t i) { return i % N == 0 ? h : h * h; };
  for (std::size_t r = 0; r < 2 * N; ++r) {
    const int row = unknown(r);
    if (row < 0) continue;
    system.load[row] += energy * scale(r) * Element<N>::load[r] * knots.half_step(piece);
    for (std::size_t c = 0; c < 2 * N; ++c) {
      const double entry = energy * scale(r) * scale(c) * Element<N>::stiffness[r][c];
      const int column = unknown(c);
      if (column < 0) {
        system.load[row] -= entry * knots.derivatives[piece + c / N][c % N];
      } else if (column <= row) {
        system.lower.emplace_back(row, column, entry);
      }
    }
  }
}

/// Finds the unknown derivatives. The matrix is positive definite, and a band but for the corner of
/// a periodic spline: its factors have O(n) entries in the order of the knots.
template <std::size_t N>
bool solve(Knots<N>& knots) {
  const auto size = static_cast<Eigen::Index>(N * knots.unknowns());
  if (size == 0) return true;
  System<N> system;
  system.load = Eigen::VectorXd::Zero(size);
  system.lower.reserve(knots.pieces() * N * (2 * N + 1));
  for (std::size_t piece = 0; piece < knots.pieces(); ++piece) add_element(knots, piece, system);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(system.lower.begin(), system.lower.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower,
                              Eigen::NaturalOrdering<int>>
      factors(matrix);
  if (factors.info() != Eigen::Success) return false;
  const Eigen::VectorXd solution = factors.solve(system.load);
  for (std::size_t knot = 0; knot < knots.at.size(); ++knot) {
    const int unknown = knots.unknown(knot);
    if (unknown < 0) continue;
    for (std::size_t p = 0; p < N; ++p) {
      knots.derivatives[knot][p] =
          solution[static_cast<Eigen::Index>(N) * unknown + static_cast<Eigen::Index>(p)];
    }
  }
  return true;
}

/// Hermite's polynomial on [−1, 1], less its value at −1, by its even and its odd part: first
/// derivatives m, second ones q, half the step D.
std::array<double, 6> hermite(const std::array<double, 1>& m0, const std::array<double, 1>& m1,
                              double step) {
  const double even = 0.25 * (m1[0] - m0[0]), odd = 0.5 * (0.5 * (m0[0] + m1[0]) - step);
  return {step - even, step - odd, even, odd, 0, 0};
}
std::array<double, 6> hermite(const std::array<double, 2>& begin, const std::array<double, 2>& end,
                              double step) {
  const auto [m0, q0] = begin;
  const auto [m1, q1] = end;
  const double excess = 0.5 * (m0 + m1) - step, slope = 0.5 * (m1 - m0);
  const double fourth = 0.125 * (0.5 * (q0 + q1) - slope), second = 0.5 * slope - 2 * fourth;
  const double fifth = 0.125 * (0.5 * (q1 - q0) - 3 * excess), third = 0.5 * excess - 2 * fifth;
  return {step - second - fourth, step - third - fifth, second, third, fourth, fifth};
}

/// Derivatives by x from those by u.
template <std::size_t N>
std::array<double, N> by_half_width(std::array<double, N> derivatives, double h) {
  double power = 1;
  for (double& derivative : derivatives) derivative *= power *= h;
  return derivatives;
}

template <std::size_t N>
MotionPiece<double> piece_of(const Knots<N>& knots, std::size_t i, double over) {
  MotionPiece<double> piece;
  const double h = knots.half_width(i);
  piece.span = over * (knots.at[i + 1] - knots.at[i]);
  piece.terms = 2 * N + 2;
  std::ranges::copy(hermite(by_half_width(knots.derivatives[i], h),
                            by_half_width(knots.derivatives[i + 1], h), knots.half_step(i)),
                    piece.polynomial.begin());
  return piece;
}

bool is_finite(const MotionPiece<double>& piece) {
  return piece.span > 0 && std::ranges::all_of(piece.polynomial, [](double coefficient) {
           return std::isfinite(coefficient);
         });
}

template <std::size_t N>
bool append(Knots<N>& knots, const MotionSegment& segment, double begin, double start, int index,
            std::vector<MotionPiece<double>>& pieces) {
  if (!solve(knots)) return false;
  const std::size_t before = pieces.size();
  for (std::size_t i = 0; i < knots.pieces(); ++i) {
    MotionPiece<double> piece = piece_of(knots, i, segment.over);
    piece.begin = begin + segment.over * knots.at[i];
    piece.offset = start + knots.displacement[i];
    piece.segment = index;
    pieces.push_back(piece);
    if (is_finite(piece)) continue;
    pieces.resize(before);
    return false;
  }
  return true;
}

/// Whether the points are in order, apart, strictly inside.
bool is_in_order(const std::vector<SplinePoint>& points) {
  double last = 0;
  for (const auto& [at, displacement] : points) {
    if (!(at > last) || !std::isfinite(displacement)) return false;
    last = at;
  }
  return last < 1;
}

template <std::size_t N>
Knots<N> knots_of(const MotionSegment& segment) {
  Knots<N> knots;
  knots.periodic = segment.ends.periodic;
  knots.at.push_back(0);
  knots.displacement.push_back(0);
  for (const auto& [at, displacement] : segment.points) {
    knots.at.push_back(at);
    knots.displacement.push_back(displacement);
  }
  knots.at.push_back(1);
  knots.displacement.push_back(segment.rise);
  knots.derivatives.resize(knots.at.size());
  return knots;
}

}  // namespace

bool append_spline(const MotionSegment& segment, double begin, double start, int index,
                   std::vector<MotionPiece<double>>& pieces) {
  if (!is_in_order(segment.points)) return false;
  const SplineEnds& ends = segment.ends;
  if (ends.periodic && segment.rise != 0) return false;
  const double over = segment.over;
  if (segment.degree == 3) {
    Knots<1> knots = knots_of<1>(segment);
    knots.derivatives.front() = {over * ends.velocity_begin};
    knots.derivatives.back() = {over * ends.velocity_end};
    return append(knots, segment, begin, start, index, pieces);
  }
  if (segment.degree != 5) return false;
  Knots<2> knots = knots_of<2>(segment);
  knots.derivatives.front() = {over * ends.velocity_begin, over * over * ends.acceleration_begin};
  knots.derivatives.back() = {over * ends.velocity_end, over * over * ends.acceleration_end};
  return append(knots, segment, begin, start, index, pieces);
}

}  // namespace cognate::cam
