#include "tests/stress/batch_accuracy.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "analysis/batch/four_bar_batch.hpp"

namespace cognate::stress {
namespace {

constexpr std::size_t kAngles = 16;

/// Designs as a batch takes them, A at the origin and D on the x axis.
template <class Real>
struct Designs {
  std::vector<Real> zero, crank, coupler, rocker, frame, assembly, u, v;

  void add(const Configuration& at) {
    zero.push_back(0);
    crank.push_back(static_cast<Real>(at.links.crank));
    coupler.push_back(static_cast<Real>(at.links.coupler));
    rocker.push_back(static_cast<Real>(at.links.rocker));
    frame.push_back(static_cast<Real>(at.links.frame));
    assembly.push_back(static_cast<Real>(at.assembly));
    u.push_back(static_cast<Real>(at.coupler_point.x));
    v.push_back(static_cast<Real>(at.coupler_point.y));
  }

  FourBarArrays<Real> arrays() const {
    return {zero, zero, frame, zero, crank, coupler, rocker, assembly, u, v};
  }

  /// Design i, its numbers as rounded, with the crank at `half`.
  Configuration at(std::size_t i, const Vec2d& half) const {
    return {{crank[i], coupler[i], rocker[i], frame[i]}, half, assembly[i], {u[i], v[i]}};
  }
};

}  // namespace

template <class Real>
Accuracy batch_accuracy(const Family& family, InstructionSet set, int designs, unsigned seed) {
  // How many times the unit of double is that of Real.
  constexpr double kScale = 0.5 * std::numeric_limits<Real>::epsilon() / kUnit;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any_angle(-3.15, 3.15);
  std::vector<double> angles(kAngles);
  for (double& angle : angles) angle = any_angle(random);
  Designs<Real> all;
  for (int i = 0; i < designs; ++i) all.add(family.draw(family.distances.front(), random));

  const std::size_t count = all.zero.size();
  std::vector<Real> x(count * kAngles), y(count * kAngles);
  const BatchStatus status =
      evaluate_batch<Real>(all.arrays(), CrankTable<Real>(angles), {.x = x, .y = y},
                           {.threads = 1, .instruction_set = set});
  Accuracy accuracy;
  if (status != BatchStatus::done) return accuracy;
  for (std::size_t row = 0; row < kAngles; ++row) {
    const Vec2d half{std::cos(0.5 * angles[row]), std::sin(0.5 * angles[row])};
    for (std::size_t i = 0; i < count; ++i) {
      const ExactClosure exact = exact_closure(all.at(i, half));
      const Vec2d point{x[row * count + i], y[row * count + i]};
      const bool closes = !std::isnan(point.x);
      accuracy.include_flag(exact.closes, closes, exact.boundary_distance / kScale);
      if (!exact.closes || !closes) continue;
      accuracy.include_error(distance(point, exact.point) / exact.size / kScale,
                             exact.point_condition);
    }
  }
  return accuracy;
}

template Accuracy batch_accuracy<double>(const Family&, InstructionSet, int, unsigned);
template Accuracy batch_accuracy<float>(const Family&, InstructionSet, int, unsigned);

}  // namespace cognate::stress
