#include "problems/tolerance/draws.hpp"

#include <cmath>
#include <limits>

#include "problems/basics/counter_random.hpp"

namespace cognate::problems {
namespace {

/// Streams of other random numbers of a run begin at 0.
constexpr std::uint64_t kToleranceStream = 0x746f6c6572616e63;

template <std::size_t Size>
double polynomial(const double (&coefficients)[Size], double x) {
  double value = coefficients[Size - 1];
  for (std::size_t i = Size - 1; i > 0; --i) value = value * x + coefficients[i - 1];
  return value;
}

constexpr double kA[] = {3.3871328727963666080,   1.3314166789178437745e2, 1.9715909503065514427e3,
                         1.3731693765509461125e4, 4.5921953931549871457e4, 6.7265770927008700853e4,
                         3.3430575583588128105e4, 2.5090809287301226727e3};
constexpr double kB[] = {1,
                         4.2313330701600911252e1,
                         6.8718700749205790830e2,
                         5.3941960214247511077e3,
                         2.1213794301586595867e4,
                         3.9307895800092710610e4,
                         2.8729085735721942674e4,
                         5.2264952788528545610e3};
constexpr double kC[] = {1.42343711074968357734,    4.63033784615654529590,
                         5.76949722146069140550,    3.64784832476320460504,
                         1.27045825245236838258,    2.41780725177450611770e-1,
                         2.27238449892691845833e-2, 7.74545014278341407640e-4};
constexpr double kD[] = {1,
                         2.05319162663775882187,
                         1.67638483018380384940,
                         6.89767334985100004550e-1,
                         1.48103976427480074590e-1,
                         1.51986665636164571966e-2,
                         5.47593808499534494600e-4,
                         1.05075007164441684324e-9};
constexpr double kE[] = {6.65790464350110377720,    5.46378491116411436990,
                         1.78482653991729133580,    2.96560571828504891230e-1,
                         2.65321895265761230930e-2, 1.24266094738807843860e-3,
                         2.71155556874348757815e-5, 2.01033439929228813265e-7};
constexpr double kF[] = {1,
                         5.99832206555887937690e-1,
                         1.36929880922735805310e-1,
                         1.48753612908506148525e-2,
                         7.86869131145613259100e-4,
                         1.84631831751005468180e-5,
                         1.42151175831644588870e-7,
                         2.04426310338993978564e-15};

}  // namespace

double normal_quantile(double p) {
  const double q = p - 0.5;
  if (std::abs(q) <= 0.425) {
    const double r = 0.180625 - q * q;
    return q * polynomial(kA, r) / polynomial(kB, r);
  }
  const double tail = std::sqrt(-std::log(q < 0 ? p : 1 - p));
  const double value = tail <= 5 ? polynomial(kC, tail - 1.6) / polynomial(kD, tail - 1.6)
                                 : polynomial(kE, tail - 5) / polynomial(kF, tail - 5);
  return q < 0 ? -value : value;
}

double deviations_in_half_width(ToleranceDistribution distribution) {
  return distribution == ToleranceDistribution::uniform ? std::sqrt(3.0) : 3.0;
}

void draw_changes(std::span<const TolerancedDimension> dimensions,
                  ToleranceDistribution distribution, std::uint64_t seed, std::size_t first,
                  std::size_t count, std::span<double> changes) {
  constexpr double kHalfStep = 0x1p-54;  // keeps numbers off 0
  const double sigmas = deviations_in_half_width(distribution);
  for (std::size_t d = 0; d < dimensions.size(); ++d) {
    const double middle = dimensions[d].middle(), half = dimensions[d].half_width();
    for (std::size_t i = 0; i < count; ++i) {
      const double unit =
          unit_number(random_word(seed, kToleranceStream + d, first + i)) + kHalfStep;
      changes[d * count + i] = distribution == ToleranceDistribution::uniform
                                   ? middle + half * (2 * unit - 1)
                                   : middle + half / sigmas * normal_quantile(unit);
    }
  }
}

void reject_lost_lengths(std::span<const TolerancedDimension> dimensions, std::size_t count,
                         std::span<double> changes) {
  for (std::size_t d = 0; d < dimensions.size(); ++d) {
    const double nominal = dimensions[d].nominal;
    if (!dimensions[d].is_length || !(nominal > 0)) continue;
    for (double& change : changes.subspan(d * count, count)) {
      if (change <= -nominal) change = std::numeric_limits<double>::quiet_NaN();
    }
  }
}

}  // namespace cognate::problems
