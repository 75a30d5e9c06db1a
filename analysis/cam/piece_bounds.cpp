#include "analysis/cam/piece_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::cam {
namespace {

using Coefficients = std::array<double, MotionPiece<double>::kMostTerms>;

/// The derivative `order` of a piece's polynomial by t, in powers of t. Returns how many there are.
std::size_t powers_of_t(const MotionPiece<double>& piece, int order, Coefficients& powers) {
  powers = piece.polynomial;
  auto count = static_cast<std::size_t>(piece.terms);
  for (; order > 0 && count > 0; --order, --count) {
    for (std::size_t k = 1; k < count; ++k) powers[k - 1] = 2 * static_cast<double>(k) * powers[k];
  }
  for (std::size_t first = 0; first + 1 < count; ++first) {  // x = 2t − 1: about −1, by Horner
    for (std::size_t k = count - 1; k-- > first;) powers[k] -= powers[k + 1];
  }
  for (std::size_t k = 0; k < count; ++k) powers[k] = std::ldexp(powers[k], static_cast<int>(k));
  return count;
}

/// A polynomial lies between the least and the greatest of its Bernstein coefficients
/// bⱼ = Σ (j over k)/(n over k) cₖ.
Bounds polynomial_bounds(const MotionPiece<double>& piece, int order) {
  Coefficients coefficients;
  const std::size_t count = powers_of_t(piece, order, coefficients);
  if (count == 0) return {};
  const auto degree = static_cast<double>(count - 1);
  Bounds bounds{coefficients[0], coefficients[0]};
  for (std::size_t j = 1; j < count; ++j) {
    double weight = 1, sum = coefficients[0];
    for (std::size_t k = 1; k <= j; ++k) {
      const auto before = static_cast<double>(k - 1);
      weight *= (static_cast<double>(j) - before) / (degree - before);
      sum += weight * coefficients[k];
    }
    bounds.least = std::min(bounds.least, sum);
    bounds.greatest = std::max(bounds.greatest, sum);
  }
  return bounds;
}

/// Whether a whole number lies in [from, to].
bool holds_whole(double from, double to) {
  return std::ceil(from) <= to;
}

/// The range of the derivative `order` by t of a sinusoid over t in [0, 1].
Bounds sinusoid_bounds(const Sinusoid<double>& wave, int order) {
  const double begin = wave.phase + 0.5 * order, end = begin + wave.rate;
  const double from = std::min(begin, end), to = std::max(begin, end);
  const double size = wave.amplitude * std::pow(pi_of<double>() * wave.rate, order);
  const double at_begin = sine_cosine_of_half_turns(begin).sine,
               at_end = sine_cosine_of_half_turns(end).sine;
  // sin(πy) is 1 where y = ½ + 2k and −1 where y = −½ + 2k.
  const double least =
      holds_whole(0.5 * (from + 0.5), 0.5 * (to + 0.5)) ? -1 : std::min(at_begin, at_end);
  const double greatest =
      holds_whole(0.5 * (from - 0.5), 0.5 * (to - 0.5)) ? 1 : std::max(at_begin, at_end);
  return {std::min(size * least, size * greatest), std::max(size * least, size * greatest)};
}

}  // namespace

Bounds bounds_of(const MotionPiece<double>& piece, int order) {
  Bounds sum = polynomial_bounds(piece, order);
  for (int i = 0; i < piece.sinusoid_count; ++i) {
    const auto [least, greatest] =
        sinusoid_bounds(piece.sinusoids[static_cast<std::size_t>(i)], order);
    sum.least += least;
    sum.greatest += greatest;
  }
  const double scale = piece.scale / std::pow(piece.span, order);
  sum = {std::min(scale * sum.least, scale * sum.greatest),
         std::max(scale * sum.least, scale * sum.greatest)};
  if (order > 0) return sum;
  return {piece.offset + sum.least, piece.offset + sum.greatest};
}

}  // namespace cognate::cam
