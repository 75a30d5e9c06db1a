/// Distinguishes certified roots by balls of the invariants of their symmetry.
#include <algorithm>
#include <tuple>
#include <vector>

#include "synthesis/exact/nine_point/ball.hpp"
#include "synthesis/exact/nine_point/certificate.hpp"

namespace cognate::synthesis {
namespace {

using DoubleBall = Ball<double>;

/// The balls of numbers that do not change with the symmetry.
std::vector<DoubleBall> invariants(const RootCertificate& root, RootSymmetry symmetry) {
  const auto ball = [&](const std::complex<double>& z) {
    return DoubleBall(z.real(), z.imag(), DoubleBall::enlarged(root.radius * (2 + std::abs(z))));
  };
  const auto& [first, second] = std::tie(root.refined.first, root.refined.second);
  const DoubleBall x = ball(first.moving), a = ball(first.fixed);
  const DoubleBall y = ball(second.moving), b = ball(second.fixed);
  switch (symmetry) {
    case RootSymmetry::none:
      return {x, a, y, b, ball(first.moving_bar), ball(second.moving_bar)};
    case RootSymmetry::swapped_dyads:
      return {x + y, a + b, x * y, a * b, a * x + b * y};
    case RootSymmetry::cognates:  // the sum of the three foci of the curve
      return {a + b + (b * x - a * y) * inverse(x - y)};
  }
  return {};
}

/// A certified root by its place in the list.
struct Invariants {
  int index;
  std::vector<DoubleBall> balls;
};

bool overlap(const Invariants& a, const Invariants& b) {
  for (std::size_t i = 0; i < a.balls.size(); ++i) {
    if (are_apart(a.balls[i], b.balls[i])) return false;
  }
  return true;
}

}  // namespace

std::vector<std::array<int, 2>> overlapping(std::span<const RootCertificate> roots,
                                            RootSymmetry symmetry) {
  std::vector<Invariants> all;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (roots[i].certified) all.push_back({int(i), invariants(roots[i], symmetry)});
  }
  std::vector<std::array<int, 2>> pairs;
  for (std::size_t k = 1; k < all.size(); ++k) {
    for (std::size_t i = 0; i < k; ++i) {
      if (overlap(all[i], all[k])) pairs.push_back({all[i].index, all[k].index});
    }
  }
  return pairs;
}

int count_distinct(std::span<const RootCertificate> roots, RootSymmetry symmetry) {
  int count = int(std::ranges::count(roots, true, &RootCertificate::certified));
  std::vector<bool> counted(roots.size(), false);
  for (const auto& [i, k] : overlapping(roots, symmetry)) {
    if (!counted[std::size_t(k)]) --count;
    counted[std::size_t(k)] = true;
  }
  return count;
}

}  // namespace cognate::synthesis
