#include "problems/certificate/box_form.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::problems {
namespace {

using Numbers = std::array<std::array<double, 5>, 5>;

Numbers middles_of(const BoxForm& form) {
  Numbers middles;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) middles[i][j] = static_cast<double>(form[i][j].middle());
  }
  return middles;
}

/// What the diagonal lacks of a convex form: raises pivots that are too small.
std::array<double, 4> convexity_shifts(Numbers m) {
  std::array<double, 4> shifts{};
  for (int i = 1; i < 5; ++i) {
    double others = 0;
    for (int j = i + 1; j < 5; ++j) others = std::max(others, std::abs(m[i][j]));
    const double least = 0.7 * others;
    if (m[i][i] < least || m[i][i] <= 0) shifts[i - 1] = least - m[i][i];
    const double pivot = m[i][i] + shifts[i - 1];
    if (!(pivot > 0)) continue;
    for (int j = i + 1; j < 5; ++j) {
      for (int k = i + 1; k < 5; ++k) m[j][k] -= m[j][i] * m[i][k] / pivot;
    }
  }
  return shifts;
}

}  // namespace

FormMinimum form_minimum(const BoxForm& form) {
  constexpr int kMostSweeps = 200;
  const Numbers m = middles_of(form);
  const std::array<double, 4> shifts = convexity_shifts(m);
  std::array<double, 4> t{};
  const auto slope_of = [&](int i) {
    double sum = m[0][i + 1] + shifts[i] * t[i];
    for (int j = 0; j < 4; ++j) sum += m[i + 1][j + 1] * t[j];
    return sum;
  };
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double moved = 0;
    for (int i = 0; i < 4; ++i) {
      const double curvature = m[i + 1][i + 1] + shifts[i];
      const double next = curvature > 0 ? std::clamp(t[i] - slope_of(i) / curvature, -1.0, 1.0)
                                        : (slope_of(i) > 0 ? -1.0 : 1.0);
      moved = std::max(moved, std::abs(next - t[i]));
      t[i] = next;
    }
    if (moved < 1e-9) break;
  }
  FormMinimum minimum{m[0][0], {}};
  for (int i = 0; i < 4; ++i) {
    const double at = slope_of(i);
    minimum.value += t[i] * (m[0][i + 1] + at) - shifts[i];
    minimum.multiplier[i] = shifts[i] + std::max(0.0, std::abs(t[i]) == 1 ? -at * t[i] : 0.0);
  }
  return minimum;
}

bool surely_exceeds(const BoxForm& form, const std::array<double, 4>& multiplier,
                    const QuadInterval& loss) {
  constexpr double kRaised = 1e-13;  // so that a pivot of zero is positive; counted as lost
  BoxForm m = form;
  double size = 0;
  for (int i = 0; i < 5; ++i) size = std::max(size, static_cast<double>(m[i][i].magnitude()));
  m[0][0] = m[0][0] - loss;
  for (int i = 0; i < 4; ++i) {
    const QuadInterval added(multiplier[i] + kRaised * size);
    m[0][0] = m[0][0] - added;
    m[i + 1][i + 1] += added;
  }
  for (int i = 4; i > 0; --i) {
    if (!(m[i][i].low > 0)) return false;
    for (int j = 0; j < i; ++j) {
      const QuadInterval factor = m[j][i] / m[i][i];
      for (int k = 0; k <= j; ++k) {
        m[j][k] = m[j][k] - factor * m[k][i];
        m[k][j] = m[j][k];
      }
    }
  }
  return m[0][0].low > 0;
}

}  // namespace cognate::problems
