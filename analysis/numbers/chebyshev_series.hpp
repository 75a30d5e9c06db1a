/// @file Chebyshev series of degree 24 on [-1, 1], and zeros of such a series and of its
/// derivative.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace cognate::cam {

constexpr std::size_t kChebyshevDegree = 24;
constexpr std::size_t kChebyshevSize = kChebyshevDegree + 1;

/// Σ c_k·T_k(t) over the first `size` coefficients, at least one.
struct ChebyshevSeries {
  std::array<double, kChebyshevSize> coefficients{};
  std::size_t size = 1;

  double& operator[](std::size_t k) { return coefficients[k]; }
  double operator[](std::size_t k) const { return coefficients[k]; }
};

/// Values at the 25 nodes.
using ChebyshevSamples = std::array<double, kChebyshevSize>;

/// The nodes -cos(jπ/24), from -1 to 1, where T_24 is 1 or -1.
double chebyshev_node(std::size_t j);

/// The polynomial of degree 24 through values at the nodes.
ChebyshevSeries interpolant(const ChebyshevSamples& values);

/// Drops the last coefficients, as many as are all within `negligible` of 0.
void drop_last(ChebyshevSeries& series, double negligible);

struct ValueAndSlope {
  double value = 0;
  double slope = 0;
};

/// The sum of the series, and its derivative by t (Clenshaw 1955).
ValueAndSlope value_and_slope(const ChebyshevSeries& series, double t);

/// The series of the derivative by t.
ChebyshevSeries derivative(const ChebyshevSeries& series);

/// A series on [-1, 0] and on [0, 1], each as one over [-1, 1] again.
struct ChebyshevHalves {
  ChebyshevSeries left, right;
};

/// The halves, without last coefficients within `negligible` of 0.
ChebyshevHalves halves(const ChebyshevSeries& series, double negligible);

/// The most by which the series departs from its mean coefficient c_0: |T_k| ≤ 1.
inline double variation_bound(const ChebyshevSeries& series) {
  double sum = 0;
  for (std::size_t k = 1; k < series.size; ++k) sum += std::abs(series[k]);
  return sum;
}

/// Proof that the series is nowhere 0 on [-1, 1]; false proves nothing.
inline bool has_no_zero(const ChebyshevSeries& series) {
  return std::abs(series[0]) > variation_bound(series);
}

/// The place between a < b where the series passes through 0, its sign at a being `rises` ? - : +
/// and the opposite at b: Newton's steps, kept inside, or halving where they are slow.
double bracketed_zero(const ChebyshevSeries& series, double a, double b, bool rises);

/// Whether a value counts as positive: 0 does not, so that of two neighbouring pieces exactly one
/// holds a zero between them.
inline bool is_positive(double value) {
  return value > 0;
}

/// Calls `found(t)` at each sign change of the derivative of `series`, or of the series itself, in
/// order. Halves of the interval are tried until in each the function has no zero or its derivative
/// has none (then its ends' signs decide), both by bounds on the coefficients; or until the
/// function is within `rounding` of 0 all over, where at most one sign change is reported. The
/// derivative is taken by the local variable of a half, so that for it the latter means that the
/// series varies by no more than 2·rounding there.
/// `skip(piece)` may rule out a half by the series restricted to it.
class SignChanges {
 public:
  enum class Of { series, derivative };

  SignChanges(const ChebyshevSeries& series, Of what, double rounding)
      : series_(series),
        what_(what),
        function_(what == Of::series ? series : derivative(series)),
        rounding_(rounding) {}

  bool is_positive_at(double t) const { return is_positive(value_and_slope(function_, t).value); }

  /// With the function's signs at -1 and 1 as the caller sees them.
  template <class Skip, class Found>
  void visit(bool positive_begin, bool positive_end, Skip&& skip, Found&& found) const {
    visit(series_, {-1, 1, positive_begin, positive_end}, skip, found);
  }

 private:
  struct Bracket {
    double from, to;
    bool positive_begin, positive_end;
  };

  bool is_simple(const ChebyshevSeries& piece) const {
    const ChebyshevSeries slope = derivative(piece);
    const ChebyshevSeries& local = what_ == Of::series ? piece : slope;
    if (has_no_zero(local) || std::abs(local[0]) + variation_bound(local) <= rounding_) return true;
    return has_no_zero(what_ == Of::series ? slope : derivative(slope));
  }

  template <class Skip, class Found>
  void visit(const ChebyshevSeries& piece, const Bracket& bracket, Skip& skip, Found& found) const {
    const auto [from, to, positive_begin, positive_end] = bracket;
    if (skip(piece)) return;
    if (to - from <= kLeastWidth || is_simple(piece)) {
      if (positive_begin != positive_end) found(bracketed_zero(function_, from, to, positive_end));
      return;
    }
    const double middle = from + (to - from) / 2;
    const bool positive_middle = is_positive_at(middle);
    // What is dropped stays below the rounding in second derivatives too.
    const auto [left, right] = halves(piece, 1e-4 * rounding_);
    visit(left, {from, middle, positive_begin, positive_middle}, skip, found);
    visit(right, {middle, to, positive_middle, positive_end}, skip, found);
  }

  static constexpr double kLeastWidth = 1e-14;

  const ChebyshevSeries& series_;
  Of what_;
  ChebyshevSeries function_;
  double rounding_;
};

}  // namespace cognate::cam
