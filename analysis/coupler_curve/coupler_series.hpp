/// @file The coupler's motion as a power series of any order, with no closure solved anew.
///
/// By a parameter τ that no dead point stops, the links turn at rates that are products of their
/// own directions (differentiate the closure and project it across each link), so that the
/// coefficients of the directions follow one from the other:
///
///     four-bar       l₁ θ′ = h e₂ × e₃,   l₂ φ′ = h e₃ × e₁,   l₃ ψ′ = h e₂ × e₁
///     slider-crank   l₁ θ′ = h e₂ · d,    l₂ φ′ = −h e₁ · d
///
/// with e₁ along A→B, e₂ along B→C, e₃ along D→C, d along the slide. The length h is the shortest
/// of the moving links, so that none turns faster than τ. All rates vanish at a change point alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// Coefficients of τᵏ, k = 0…N, of the crank pin B, counted from the crank pivot, and of the unit
/// vector along B→C. The point z of the plane, counted from B at τ = 0 and carried along by the
/// coupler, has the coefficients pin[k] + direction[k]·conj(direction[0])·z.
template <class T, int N>
struct CouplerSeries {
  std::array<Vec2<T>, N + 1> pin;
  std::array<Vec2<T>, N + 1> direction;
  T crank_rate{};  ///< dθ/dτ; zero at a dead point of the crank as the driver
};

/// Coefficients of the k-th power of the product a·b of two series.
template <class Product, class T, std::size_t N>
auto series_product(const std::array<Vec2<T>, N>& a, const std::array<Vec2<T>, N>& b, std::size_t k,
                    Product product) {
  auto sum = product(a[0], b[k]);
  for (std::size_t j = 1; j <= k; ++j) sum = sum + product(a[j], b[k - j]);
  return sum;
}

/// A direction that turns at the rate ω: e′ = i ω e gives the coefficient after the k-th.
template <class T, std::size_t N>
void extend(std::array<Vec2<T>, N>& direction, const std::array<T, N>& rate, std::size_t k) {
  Vec2<T> sum{};
  for (std::size_t j = 0; j <= k; ++j) sum = sum + rate[j] * direction[k - j];
  direction[k + 1] = (T(1) / T(static_cast<double>(k + 1))) * perp(sum);
}

template <class T, std::size_t N>
std::array<Vec2<T>, N> scaled(const T& length, const std::array<Vec2<T>, N>& direction) {
  std::array<Vec2<T>, N> result;
  for (std::size_t k = 0; k < N; ++k) result[k] = length * direction[k];
  return result;
}

/// The coupler of a four-bar whose links point along the unit vectors e₁ (A→B), e₂ (B→C) and e₃
/// (D→C).
template <int N, class T>
CouplerSeries<T, N> four_bar_series(const Lengths<T>& links, const Vec2<T>& crank,
                                    const Vec2<T>& coupler, const Vec2<T>& rocker) {
  const T unit = std::min({links.crank, links.coupler, links.rocker});
  std::array<Vec2<T>, N + 1> e1{crank}, e2{coupler}, e3{rocker};
  std::array<T, N + 1> theta{}, phi{}, psi{};
  const auto across = [](const Vec2<T>& a, const Vec2<T>& b) { return cross(a, b); };
  for (std::size_t k = 0; k < N; ++k) {
    theta[k] = unit / links.crank * series_product(e2, e3, k, across);
    phi[k] = unit / links.coupler * series_product(e3, e1, k, across);
    psi[k] = unit / links.rocker * series_product(e2, e1, k, across);
    extend(e1, theta, k);
    extend(e2, phi, k);
    extend(e3, psi, k);
  }
  return {scaled(links.crank, e1), e2, theta[0]};
}

/// The coupler of a slider-crank whose links point along e₁ (A→B) and e₂ (B→C), its slide along the
/// unit vector d.
template <int N, class T>
CouplerSeries<T, N> slider_crank_series(const T& crank_length, const T& coupler_length,
                                        const Vec2<T>& crank, const Vec2<T>& coupler,
                                        const Vec2<T>& slide) {
  const T unit = std::min(crank_length, coupler_length);
  std::array<Vec2<T>, N + 1> e1{crank}, e2{coupler};
  std::array<T, N + 1> theta{}, phi{};
  for (std::size_t k = 0; k < N; ++k) {
    theta[k] = unit / crank_length * dot(e2[k], slide);
    phi[k] = -(unit / coupler_length) * dot(e1[k], slide);
    extend(e1, theta, k);
    extend(e2, phi, k);
  }
  return {scaled(crank_length, e1), e2, theta[0]};
}

}  // namespace cognate
