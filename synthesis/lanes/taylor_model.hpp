/// @file Functions over boxes as polynomials of third degree in the position t ∈ [−1, 1]⁴ and a
/// bound of what remains, one box in each lane. Include in kernels alone.
///
/// |f(t) − Σ at[m] t^m| ≤ rest over the box, rounding of all operations included: each adds kPad
/// times the magnitudes it worked with, several times what its few roundings can amount to. A model
/// holds the monomials of the sides that enter it alone, known at compile time.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <utility>

#include "synthesis/lanes/lane_numbers.hpp"

namespace cognate::synthesis::COGNATE_ISA {

/// The sides of a box, as bits.
inline constexpr unsigned kFrameSide = 1, kFirstSide = 2, kSecondSide = 4, kPhaseSide = 8;
inline constexpr unsigned kAllSides = 15;

inline constexpr double kPad = 0x1p-47;  // 64 units of the last place

template <std::size_t kCount, class Body>
inline void unrolled(Body&& body) {
  [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    (body(std::integral_constant<std::size_t, kIndex>{}), ...);
  }
  (std::make_index_sequence<kCount>{});
}

/// The monomials of some sides: 1, then those of degree 1, 2 and 3, of each degree in
/// lexicographic order.
template <unsigned kSides>
struct Monomials {
  static constexpr int kSize = std::popcount(kSides);
  static constexpr int kQuadratic = 1 + kSize;  ///< the first of degree 2
  static constexpr int kCubic = kQuadratic + kSize * (kSize + 1) / 2;
  static constexpr int kCount = kCubic + kSize * (kSize + 1) * (kSize + 2) / 6;

  /// The powers of the four sides, in two bits each: those of a product are the sum.
  static constexpr std::array<int, kCount> powers() {
    std::array<int, kSize> side{};
    for (int i = 0, n = 0; i < 4; ++i) {
      if (kSides >> i & 1) side[n++] = 1 << (2 * i);
    }
    std::array<int, kCount> all{};
    int linear = 1, quadratic = kQuadratic, cubic = kCubic;
    for (int i = 0; i < kSize; ++i) {
      all[linear++] = side[i];
      for (int j = i; j < kSize; ++j) {
        all[quadratic++] = side[i] + side[j];
        for (int k = j; k < kSize; ++k) all[cubic++] = side[i] + side[j] + side[k];
      }
    }
    return all;
  }
  static constexpr auto kPowers = powers();

  static constexpr int place(int power) {
    for (int i = 0; i < kCount; ++i) {
      if (kPowers[i] == power) return i;
    }
    return -1;
  }
};

/// One product of coefficients, and whether it is the first that its place receives.
struct ModelTerm {
  int a = 0, b = 0, to = 0;
  bool first = true;
};

/// All products of coefficients [first_a, …) of one model with [first_b, …) of another up to degree
/// three, ordered by where they go.
template <unsigned kA, unsigned kB>
struct ModelTerms {
  using To = Monomials<kA | kB>;
  template <class Use>
  static constexpr void each(int first_a, int end_a, int first_b, int end_b, const Use& use) {
    for (int to = 0; to < To::kCount; ++to) {
      bool first = true;
      for (int a = first_a; a < end_a; ++a) {
        for (int b = first_b; b < end_b; ++b) {
          if (Monomials<kA>::kPowers[a] + Monomials<kB>::kPowers[b] != To::kPowers[to]) continue;
          use(ModelTerm{a, b, to, first});
          first = false;
        }
      }
    }
  }
  template <int kFirstA, int kEndA, int kFirstB, int kEndB>
  static constexpr int count() {
    int terms = 0;
    each(kFirstA, kEndA, kFirstB, kEndB, [&](const ModelTerm&) { ++terms; });
    return terms;
  }
  template <int kFirstA, int kEndA, int kFirstB, int kEndB>
  static constexpr auto list() {
    std::array<ModelTerm, count<kFirstA, kEndA, kFirstB, kEndB>()> terms{};
    int n = 0;
    each(kFirstA, kEndA, kFirstB, kEndB, [&](const ModelTerm& term) { terms[n++] = term; });
    return terms;
  }
  static constexpr auto kAll = list<0, Monomials<kA>::kCount, 0, Monomials<kB>::kCount>();
};

template <unsigned kSides>
struct Model {
  using Of = Monomials<kSides>;
  Real at[Of::kCount];
  Real rest;
  Real linear, quadratic, cubic;  ///< sums of absolute coefficients

  void measure() {
    linear = quadratic = cubic = Real(0.0);
    unrolled<Of::kCount - 1>([&](auto index) {
      constexpr int i = static_cast<int>(index.value) + 1;
      Real& sum = i < Of::kQuadratic ? linear : i < Of::kCubic ? quadratic : cubic;
      sum = sum + magnitude(at[i]);
    });
  }
  /// Of all but the constant.
  Real spread() const { return linear + quadratic + cubic; }
  Real size() const { return magnitude(at[0]) + spread(); }
  /// Adds what the operation's rounding may amount to.
  void pad(const Real& magnitudes) { rest = rest * Real(1 + kPad) + magnitudes * Real(kPad); }
};

template <unsigned kA, unsigned kB>
inline Model<kA | kB> operator*(const Model<kA>& a, const Model<kB>& b) {
  using Terms = ModelTerms<kA, kB>;
  Model<kA | kB> product;
  unrolled<Terms::kAll.size()>([&](auto index) {
    constexpr ModelTerm term = Terms::kAll[index.value];
    const Real part = a.at[term.a] * b.at[term.b];
    if constexpr (term.first) {
      product.at[term.to] = part;
    } else {
      product.at[term.to] = product.at[term.to] + part;
    }
  });
  const Real whole_a = a.size(), whole_b = b.size();
  const Real beyond = a.linear * b.cubic + a.quadratic * (b.quadratic + b.cubic) +
                      a.cubic * (b.linear + b.quadratic + b.cubic);
  product.rest = beyond + whole_a * b.rest + a.rest * (whole_b + b.rest);
  product.measure();
  product.pad(whole_a * whole_b);
  return product;
}

/// a + factor·b
template <unsigned kA, unsigned kB>
inline Model<kA | kB> plus(const Model<kA>& a, const Real& factor, const Model<kB>& b) {
  using Of = Monomials<kA | kB>;
  Model<kA | kB> sum;
  unrolled<Of::kCount>([&](auto index) {
    constexpr int of_a = Monomials<kA>::place(Of::kPowers[index.value]);
    constexpr int of_b = Monomials<kB>::place(Of::kPowers[index.value]);
    if constexpr (of_a < 0 && of_b < 0) {
      sum.at[index.value] = Real(0.0);
    } else if constexpr (of_b < 0) {
      sum.at[index.value] = a.at[of_a];
    } else if constexpr (of_a < 0) {
      sum.at[index.value] = factor * b.at[of_b];
    } else {
      sum.at[index.value] = a.at[of_a] + factor * b.at[of_b];
    }
  });
  const Real scale = magnitude(factor);
  sum.rest = a.rest + scale * b.rest;
  sum.measure();
  sum.pad(a.size() + scale * b.size());
  return sum;
}

/// factor·a + constant
template <unsigned kA>
inline Model<kA> scaled(const Real& factor, const Model<kA>& a, const Real& constant) {
  Model<kA> result;
  for (int i = 0; i < Model<kA>::Of::kCount; ++i) result.at[i] = factor * a.at[i];
  result.at[0] = result.at[0] + constant;
  const Real scale = magnitude(factor);
  result.rest = scale * a.rest;
  result.measure();
  result.pad(scale * a.size() + magnitude(constant));
  return result;
}

/// f of a model, from f and its Taylor coefficients at the model's constant and a bound of the
/// fourth over the model's range.
struct TaylorCoefficients {
  Real f0, f1, f2, f3, fourth;
};

template <unsigned kA>
inline Model<kA> composed(const TaylorCoefficients& f, const Model<kA>& a) {
  using Of = Monomials<kA>;
  using Terms = ModelTerms<kA, kA>;
  static constexpr auto kSquares = Terms::template list<1, Of::kQuadratic, 1, Of::kQuadratic>();
  static constexpr auto kCubes =
      Terms::template list<1, Of::kQuadratic, Of::kQuadratic, Of::kCubic>();
  Real square[Of::kCubic], inner[Of::kCubic], cube[Of::kCount];
  const auto sum_up = [](auto& to, const Real* left, const Real* right, auto term) {
    constexpr ModelTerm at = term();
    const Real part = left[at.a] * right[at.b];
    if constexpr (at.first) {
      to[at.to] = part;
    } else {
      to[at.to] = to[at.to] + part;
    }
  };
  unrolled<kSquares.size()>([&](auto index) {
    sum_up(square, a.at, a.at, [] { return kSquares[decltype(index)::value]; });
  });
  Model<kA> result;
  result.at[0] = f.f0;
  const Real doubled = f.f2 + f.f2;
  for (int i = 1; i < Of::kQuadratic; ++i) result.at[i] = f.f1 * a.at[i];
  for (int i = Of::kQuadratic; i < Of::kCubic; ++i) {
    result.at[i] = f.f1 * a.at[i] + f.f2 * square[i];
    inner[i] = doubled * a.at[i] + f.f3 * square[i];
  }
  unrolled<kCubes.size()>([&](auto index) {
    sum_up(cube, a.at, inner, [] { return kCubes[decltype(index)::value]; });
  });
  for (int i = Of::kCubic; i < Of::kCount; ++i) result.at[i] = f.f1 * a.at[i] + cube[i];

  const Real e = a.cubic + a.rest, g = a.quadratic + e, whole = a.linear + g;
  const Real f1 = magnitude(f.f1), f2 = magnitude(f.f2), f3 = magnitude(f.f3);
  const Real square_of_whole = whole * whole;
  result.rest = f1 * a.rest + f2 * (Real(2.0) * a.linear * e + g * g) +
                f3 * g * (Real(3.0) * a.linear * (a.linear + g) + g * g) +
                f.fourth * square_of_whole * square_of_whole;
  result.measure();
  result.pad(magnitude(f.f0) + whole * (f1 + whole * (f2 + whole * f3)));
  return result;
}

/// What `a` is at least; `valid` falls where that is too little for a series.
template <unsigned kA>
inline Real least_of(const Model<kA>& a, Mask& valid) {
  const Real low = a.at[0] * Real(1 - kPad) - (a.spread() + a.rest) * Real(1 + kPad);
  valid = valid && (low > Real(0.02) * a.at[0]);
  return low;
}

template <unsigned kA>
inline Model<kA> reciprocal(const Model<kA>& a, Mask& valid) {
  const Real low = least_of(a, valid), inverse = Real(1.0) / a.at[0];
  const Real square = inverse * inverse;
  return composed<kA>({inverse, -square, square * inverse, -square * square, square * square / low},
                      a);
}

/// The logarithm less its value at the constant.
template <unsigned kA>
inline Model<kA> logarithm(const Model<kA>& a, Mask& valid) {
  const Real low = least_of(a, valid), inverse = Real(1.0) / a.at[0];
  const Real square = inverse * inverse, cube = square * inverse;
  return composed<kA>(
      {Real(0.0), inverse, Real(-0.5) * square, cube * Real(1.0 / 3), Real(0.25) * cube / low}, a);
}

template <unsigned kA>
inline Model<kA> square_root(const Model<kA>& a, Mask& valid) {
  const Real low = least_of(a, valid);
  const Real value = root(a.at[0]), inverse = Real(1.0) / a.at[0];
  const Real f1 = Real(0.5) * value * inverse, f2 = Real(-0.25) * f1 * inverse;
  const Real fourth = Real(5.0 / 128) / (low * low * low * root(larger(low, Real(1e-30))));
  return composed<kA>({value, f1, f2, Real(-0.5) * f2 * inverse, fourth}, a);
}

/// The cosine of a side, of half width `half`, where its middle has these cosine and sine.
template <unsigned kSide>
inline Model<kSide> cosine_of_side(const Real& cosine, const Real& sine, const Real& half) {
  const Real square = half * half;
  Model<kSide> result;
  result.at[0] = cosine;
  result.at[1] = -sine * half;
  result.at[2] = Real(-0.5) * cosine * square;
  result.at[3] = Real(1.0 / 6) * sine * half * square;
  result.rest = Real(1.0 / 24) * square * square;
  result.measure();
  const Real reach = Real(1.0) + half;
  result.pad(reach * reach * reach);
  return result;
}

}  // namespace cognate::synthesis::COGNATE_ISA
