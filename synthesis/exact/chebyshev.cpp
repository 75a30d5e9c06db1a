#include "synthesis/exact/chebyshev.hpp"

#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {

std::vector<double> chebyshev_spacing(double first, double last, int count) {
  const double middle = 0.5 * (first + last);
  const double half_width = 0.5 * (last - first);
  std::vector<double> points;
  for (int i = 1; i <= count; ++i) {
    // A cosine written as a sine of an angle about zero vanishes exactly at the middle point.
    const double turn = kPi * (2 * i - 1 - count) / (2 * count);
    points.push_back(middle + half_width * std::sin(turn));
  }
  return points;
}

}  // namespace cognate::synthesis
