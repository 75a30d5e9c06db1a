#include "tests/stress/closure_families.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::stress {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

double sign(Random& random) {
  return random() % 2 == 0 ? 1.0 : -1.0;
}

Vec2d half_crank(double theta) {
  return {std::cos(0.5 * theta), std::sin(0.5 * theta)};
}

/// Assembly and coupler point at random, the point within two coupler lengths of B.
Configuration with_point(const Lengths<double>& links, const Vec2d& half, Random& random) {
  const double l2 = links.coupler;
  return {links, half, sign(random), {uniform(random, -l2, 2 * l2), uniform(random, -l2, l2)}};
}

Lengths<double> random_lengths(Random& random) {
  return {uniform(random, 0.1, 1), uniform(random, 0.1, 1), uniform(random, 0.1, 1),
          uniform(random, 0.1, 1)};
}

Lengths<double> rotating_lengths(Random& random) {
  for (;;) {
    const Lengths<double> links = random_lengths(random);
    const TransmissionAngles angles = transmission_angles(links);
    if (crank_rotates(links) && angles.acute_min > kPi / 6) return links;
  }
}

/// Whether |B − D| takes this value, and not where crank and frame are nearly in line.
bool is_diagonal(const Lengths<double>& links, const Exact& diagonal) {
  return diagonal > 1.01 * abs(Exact(links.frame) - links.crank) &&
         diagonal < 0.99 * (Exact(links.frame) + links.crank);
}

Configuration crank_that_turns(double, Random& random) {
  const auto links = rotating_lengths(random);
  return with_point(links, half_crank(uniform(random, -3.15, 3.15)), random);
}

Configuration any_linkage(double, Random& random) {
  return with_point(random_lengths(random), half_crank(uniform(random, -3.15, 3.15)), random);
}

/// Two links of any size down to 1e-8 of the other two, which differ by less than the sum of both.
Configuration any_ratio(double, Random& random) {
  std::array links{&Lengths<double>::crank, &Lengths<double>::coupler, &Lengths<double>::rocker,
                   &Lengths<double>::frame};
  std::ranges::shuffle(links, random);
  Lengths<double> lengths;
  lengths.*links[0] = std::pow(10.0, uniform(random, -8, 0));
  lengths.*links[1] = std::pow(10.0, uniform(random, -8, 0));
  lengths.*links[2] = 1;
  lengths.*links[3] = 1 + (lengths.*links[0] + lengths.*links[1]) * uniform(random, -0.99, 0.99);
  return with_point(lengths, half_crank(uniform(random, -3.15, 3.15)), random);
}

/// Crank or frame at the proportion `distance`.
Configuration vanishing_side(double Lengths<double>::*side, double distance, Random& random) {
  Lengths<double> links = random_lengths(random);
  links.*side *= distance;
  return with_point(links, half_crank(uniform(random, -3.15, 3.15)), random);
}

/// Coupler or rocker at the proportion `distance`: the other one and |B − D| differ by less.
Configuration vanishing_dyad(double Lengths<double>::*side, double Lengths<double>::*other,
                             double distance, Random& random) {
  for (;;) {
    Lengths<double> links = random_lengths(random);
    links.*side *= distance;
    const Exact diagonal = Exact(links.*other) + Exact(links.*side) * uniform(random, -0.9, 0.9);
    if (is_diagonal(links, diagonal)) {
      return with_point(links, half_crank_for(links, diagonal), random);
    }
  }
}

/// |B − D| is l₂ + l₃ (stretched) or |l₂ − l₃| (folded), less or more by the relative `distance`;
/// a tenth of them beyond the limit.
Configuration near_limit(bool stretched, double distance, Random& random) {
  for (;;) {
    const Lengths<double> links = random_lengths(random);
    const double inwards = uniform(random, -0.1, 1) < 0 ? -1 : 1;
    const Exact limit =
        stretched ? Exact(links.coupler) + links.rocker : abs(Exact(links.coupler) - links.rocker);
    const Exact diagonal = limit * (1 + Exact(stretched ? -inwards : inwards) * distance);
    if (is_diagonal(links, diagonal)) {
      return with_point(links, half_crank_for(links, diagonal), random);
    }
  }
}

/// The crank off the frame's line by the angle `distance`, on either side of D or away from it.
Vec2d near_line(bool towards, double distance, Random& random) {
  const double half = 0.5 * distance * sign(random);
  return towards ? Vec2d{std::cos(half), std::sin(half)} : Vec2d{std::sin(half), std::cos(half)};
}

Configuration parallelogram(double distance, Random& random) {
  const double a = uniform(random, 0.1, 1), b = uniform(random, 0.1, 1);
  return with_point({a, b, a, b}, near_line(random() % 2 == 0, distance, random), random);
}

/// Crank and frame equal, coupler and rocker longer: B meets D.
Configuration kite_on_d(double distance, Random& random) {
  const double a = uniform(random, 0.1, 1), b = uniform(random, 1, 2);
  return with_point({a, b, b, a}, near_line(true, distance, random), random);
}

/// Crank and coupler equal, rocker and frame equal: C meets A.
Configuration kite_on_a(double distance, Random& random) {
  const double a = uniform(random, 0.1, 1), b = uniform(random, 1, 2);
  return with_point({a, a, b, b}, near_line(random() % 2 == 0, distance, random), random);
}

/// l₁ + l₂ = l₃ + l₄ without rounding, and the crank near the frame's line.
Configuration change_point(double distance, Random& random) {
  constexpr double kGrid = 0x1p-30;
  for (;;) {
    Lengths<double> links = random_lengths(random);
    for (double* length : {&links.crank, &links.coupler, &links.rocker}) {
      *length = kGrid * std::round(*length / kGrid);
    }
    links.frame = links.crank + links.coupler - links.rocker;
    if (links.frame < 0.05) continue;
    return with_point(links, near_line(true, distance, random), random);
  }
}

/// Lengths off a change point by the relative `distance`, the crank off the line by as much as
/// makes the two matter alike.
Configuration near_change_point(double distance, Random& random) {
  for (;;) {
    Lengths<double> links = random_lengths(random);
    links.frame = (links.crank + links.coupler - links.rocker) * (1 + distance * sign(random));
    if (links.frame < 0.05) continue;
    const double angle = std::sqrt(distance) * uniform(random, 0, 2);
    return with_point(links, near_line(true, angle, random), random);
  }
}

/// A parallelogram whose coupler is longer or shorter by the relative `distance`.
Configuration near_parallelogram(double distance, Random& random) {
  const double a = uniform(random, 0.1, 1), b = uniform(random, 0.1, 1);
  const double angle = std::sqrt(distance) * uniform(random, 0, 2);
  return with_point({a, b * (1 + distance * sign(random)), a, b},
                    near_line(random() % 2 == 0, angle, random), random);
}

}  // namespace

std::vector<double> half_decades(int first, int last) {
  std::vector<double> all;
  for (int half = 2 * first; half <= 2 * last; ++half) all.push_back(std::pow(10.0, -0.5 * half));
  return all;
}

std::vector<Family> closure_families() {
  using std::placeholders::_1, std::placeholders::_2;
  const auto near = half_decades(2, 16);
  const auto ratios = half_decades(0, 8);
  return {
      {"crank that turns, μ within 30°…150°", "none", {1}, crank_that_turns},
      {"any linkage", "none", {1}, any_linkage},
      {"links in ratios to 1e±8", "none", {1}, any_ratio},
      {"vanishing crank", "ratio of lengths", ratios,
       std::bind(vanishing_side, &Lengths<double>::crank, _1, _2)},
      {"vanishing frame", "ratio of lengths", ratios,
       std::bind(vanishing_side, &Lengths<double>::frame, _1, _2)},
      {"vanishing coupler", "ratio of lengths", ratios,
       std::bind(vanishing_dyad, &Lengths<double>::coupler, &Lengths<double>::rocker, _1, _2)},
      {"vanishing rocker", "ratio of lengths", ratios,
       std::bind(vanishing_dyad, &Lengths<double>::rocker, &Lengths<double>::coupler, _1, _2)},
      {"dead point, stretched", "1 − d/(l₂ + l₃)", near, std::bind(near_limit, true, _1, _2)},
      {"dead point, folded", "d/|l₂ − l₃| − 1", near, std::bind(near_limit, false, _1, _2)},
      {"change point", "crank angle, rad", near, change_point},
      {"parallelogram, antiparallelogram", "crank angle, rad", near, parallelogram},
      {"kite, B on D", "crank angle, rad", near, kite_on_d},
      {"kite, C on A", "crank angle, rad", near, kite_on_a},
      {"near a change point", "relative excess", near, near_change_point},
      {"near a parallelogram", "relative excess", near, near_parallelogram},
  };
}

}  // namespace cognate::stress
