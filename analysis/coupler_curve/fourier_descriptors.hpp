/// @file Fourier descriptors of a closed curve: what of its shape does not depend on place, size,
/// turn, starting point and the sense in which it is traced.
///
/// By its arc length s the curve is P(s) = Σ cₖ e^{2πiks/L}. Moving it changes c₀ alone; turning it
/// by β and starting it elsewhere multiply cₖ by e^{i(β + kα)}. Coefficients are divided by L/2π,
/// so that Σ k²|cₖ|² = 1 for every curve. Zahn & Roskies, IEEE Transactions on Computers 21, 1972;
/// Ullah & Kota, Journal of Mechanical Design 119, 1997; by arc length McGarva & Mullineux, Applied
/// Mathematical Modelling 17, 1993.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/coupler_curve/circuit_samples.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// The highest harmonic.
inline constexpr int kHarmonics = 4;

/// cₖ for k = −4 … 4 over L/2π; that of k is at k + 4. The curve is traced so that |c₁| ≥ |c₋₁|,
/// and turned and started so that c₁ and c₋₁ are real and not negative and, of the two starts that
/// this leaves half a length apart, so that the real part of c₂ is not negative.
struct FourierDescriptors {
  std::array<Vec2d, 2 * kHarmonics + 1> coefficients{};

  /// c of a harmonic from −4 to 4.
  Vec2d& of(int harmonic) { return coefficients[place(harmonic)]; }
  const Vec2d& of(int harmonic) const { return coefficients[place(harmonic)]; }

 private:
  static constexpr std::size_t place(int harmonic) {
    return static_cast<std::size_t>(std::ptrdiff_t{harmonic} + kHarmonics);
  }
};

/// Finds descriptors; keeps its room from curve to curve.
class DescriptorFinder {
 public:
  /// Of a curve with length, given by no fewer than eight samples.
  FourierDescriptors operator()(const CurveSamples& curve);

 private:
  std::vector<double> speed_;
};

/// The descriptors of the closed curve through `points`, which lie in equal steps of its arc length
/// `length`.
FourierDescriptors descriptors_of(std::span<const Vec2d> points, double length);

/// The sum of |aₖ − bₖ|² in whichever of the ways to name b's coefficients, or those of its mirror
/// image, comes nearest: in either sense and from either start, near which a curve may be given.
double squared_distance(const FourierDescriptors& a, const FourierDescriptors& b);

}  // namespace cognate
