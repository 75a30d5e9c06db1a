#include "problems/cam/starts.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace cognate::problems {
namespace {

/// A number from −1 to 1, the same on every system.
double draw(std::mt19937_64& random) {
  return 2 * (static_cast<double>(random() >> 11U) * 0x1p-53) - 1;
}

/// Lengths in proportions that cams usually have, about a base radius.
cam::CamDimensions<double> usual(const CamProblem& problem, double base) {
  const auto or_else = [&](CamDimension dimension, double free) {
    return problem.length(dimension).given.value_or(free);
  };
  cam::CamDimensions<double> d;
  d.base_radius = or_else(CamDimension::base_radius, base);
  d.offset = or_else(CamDimension::offset, 0);
  d.roller_radius = or_else(CamDimension::roller_radius, 0.25 * d.base_radius);
  d.face_offset = or_else(CamDimension::face_offset, 0);
  const auto& arm = problem.length(CamDimension::arm).given;
  d.centre_distance = or_else(CamDimension::centre_distance,
                              arm ? std::hypot(*arm, d.base_radius) : 2 * d.base_radius);
  d.arm = arm.value_or(
      std::sqrt(std::abs(d.centre_distance * d.centre_distance - d.base_radius * d.base_radius)));
  return d;
}

void clamp_to_bounds(const CamVariables& variables, std::vector<double>& x) {
  const auto all = variables.variables();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i])) x[i] = all[i].scale;
    x[i] = std::clamp(x[i], all[i].lower, all[i].upper);
  }
}

/// Lengths by a factor, the offset and what may have either sign by an addition.
void vary(const CamVariables& variables, std::mt19937_64& random, std::vector<double>& x) {
  constexpr double kLogarithm = 1.5;
  const auto all = variables.variables();
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool signed_length = all[i].lower < 0;
    const bool narrow = all[i].upper - all[i].lower < 4 * all[i].scale;
    const double by = draw(random);
    if (narrow) {
      x[i] = std::lerp(all[i].lower, all[i].upper, 0.5 * (1 + by));
    } else if (signed_length) {
      x[i] += 2 * by * variables.unit();
    } else {
      x[i] *= std::exp(kLogarithm * by);
    }
  }
}

}  // namespace

std::vector<std::vector<double>> cam_starts(const CamVariables& variables, int count,
                                            std::uint64_t seed) {
  constexpr double kBases[] = {1, 2, 4};
  std::mt19937_64 random(seed);
  std::vector<std::vector<double>> starts;
  for (int i = 0; i < count; ++i) {
    const double base = kBases[static_cast<std::size_t>(i) % std::size(kBases)];
    auto x = variables.values(usual(variables.problem(), base * variables.unit()));
    clamp_to_bounds(variables, x);
    if (i >= static_cast<int>(std::size(kBases))) vary(variables, random, x);
    clamp_to_bounds(variables, x);
    starts.push_back(std::move(x));
  }
  return starts;
}

}  // namespace cognate::problems
