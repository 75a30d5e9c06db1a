/// Prints, as markdown, what the smallest base radius of a cam costs and how wrong it is: by half
/// planes, by the same limits at every position in general solvers, by half planes on a grid of
/// positions, and as textbooks have it: nested golden-section searches for offset and pressure
/// angle about a bisection for the base radius.
#include <fmt/core.h>

#include <cmath>
#include <random>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/cam/result.hpp"
#include "problems/cam/search.hpp"
#include "synthesis/exact/cam/half_planes.hpp"
#include "synthesis/exact/cam/smallest_cam.hpp"
#include "tests/bench/kernel/measure.hpp"
#include "tests/support/cam_problems.hpp"

namespace cognate::bench {
namespace {

constexpr double kRise = 30 * kDegree, kReturn = 60 * kDegree;

/// A harmonic rise of 30 over 120°, a harmonic return over 90°, a dwell.
problems::CamProblem harmonic_cam() {
  problems::CamProblem problem = translating_roller({}, {}, 1e-6);
  problem.motion = {segment(cam::MotionLaw::harmonic, 120, 30),
                    segment(cam::MotionLaw::harmonic, 90, -30),
                    segment(cam::MotionLaw::dwell, 150)};
  problem.constraints.pressure_angle_max_rise_working = kRise;
  problem.constraints.pressure_angle_max_return_working = kReturn;
  problem.constraints.curvature_radius_min.reset();
  return problem;
}

/// The greatest of ±s′ − T s over a harmonic stroke, in closed form.
double harmonic_depth(double stroke, double over, double tangent) {
  const double rate = kPi / over;
  return 0.5 * stroke * (std::hypot(rate, tangent) - tangent);
}

/// The vertex of the two half planes: both limits bind.
double true_radius() {
  const double up = std::tan(kRise), down = std::tan(kReturn);
  const double rise = harmonic_depth(30, 120 * kDegree, up);
  const double fall = harmonic_depth(30, 90 * kDegree, down);
  const double height = (rise + fall) / (up + down);
  return std::hypot(rise - up * height, height);
}

double by_half_planes(const cam::MotionProgramme& programme) {
  const synthesis::PressureLimits limits{.rise_working = kRise, .fall_working = kReturn};
  return synthesis::smallest_translating(programme, limits, -HUGE_VAL, HUGE_VAL)
      ->dimensions.base_radius;
}

double by_search(const problems::CamProblem& problem, synthesis::Solver solver) {
  const problems::CamVariables variables(problem);
  problems::Work work;
  const problems::Run run;
  const problems::Deadline deadline(run);
  const auto end = search_cam(variables, {40, 1}, solver, deadline, work);
  return std::sqrt(end->x[0] * end->x[0] + end->x[1] * end->x[1]);
}

double by_grid(const cam::MotionProgramme& programme, int points) {
  std::vector<synthesis::HalfPlane> planes(2);
  planes[0] = {{1, std::tan(kRise)}, -HUGE_VAL};
  planes[1] = {{-1, std::tan(kReturn)}, -HUGE_VAL};
  for (int i = 0; i < points; ++i) {
    const auto m = programme.at(kTurn * i / points);
    auto& plane = planes[m.velocity >= 0 ? 0 : 1];
    plane.bound = std::max(plane.bound, std::abs(m.velocity) - plane.normal.y * m.displacement);
  }
  return synthesis::nearest_point({0, 0}, planes)->distance;
}

/// The least value of f on [low, high], by golden sections to the width that values resolve.
template <class F>
double golden(double low, double high, F f) {
  constexpr double kShare = 0.6180339887498949;
  double left = high - kShare * (high - low), right = low + kShare * (high - low);
  double at_left = f(left), at_right = f(right);
  for (int i = 0; i < 38; ++i) {
    if (at_left < at_right) {
      high = right, right = left, at_right = at_left;
      at_left = f(left = high - kShare * (high - low));
    } else {
      low = left, left = right, at_left = at_right;
      at_right = f(right = low + kShare * (high - low));
    }
  }
  return std::min(at_left, at_right);
}

/// Greatest pressure angle over a stroke, less its limit.
double excess(const cam::MotionProgramme& programme, double from, double to, double sign,
              double limit, double offset, double base) {
  const double height = std::sqrt(base * base - offset * offset);
  const double least = golden(from, to, [&](double angle) {
    const auto m = programme.at(angle);
    return -sign * std::atan2(m.velocity - offset, height + m.displacement);
  });
  return -least - limit;
}

double by_golden_sections(const cam::MotionProgramme& programme) {
  const auto radius_with = [&](double offset) {
    double low = std::abs(offset) + 1e-9, high = 200;
    for (int i = 0; i < 45; ++i) {
      const double base = 0.5 * (low + high);
      const bool keeps =
          excess(programme, 0, 120 * kDegree, 1, kRise, offset, base) <= 0 &&
          excess(programme, 120 * kDegree, 210 * kDegree, -1, kReturn, offset, base) <= 0;
      (keeps ? high : low) = base;
    }
    return high;
  };
  return golden(-40, 40, radius_with);
}

void print() {
  const auto problem = harmonic_cam();
  const auto programme = *programme_of(problem.motion);
  double result = 0;
  std::vector<Case> cases{
      {.name = "half planes", .run = [&] { result = by_half_planes(programme); }},
      {.name = "exchange, SLSQP",
       .run = [&] { result = by_search(problem, synthesis::Solver::slsqp); }},
      {.name = "exchange, Ipopt",
       .run = [&] { result = by_search(problem, synthesis::Solver::ipopt); }},
      {.name = "golden sections", .run = [&] { result = by_golden_sections(programme); }}};
  for (const int points : {360, 10'000, 1'000'000}) {
    cases.push_back({.name = fmt::format("grid of {}", points),
                     .run = [&, points] { result = by_grid(programme, points); }});
  }
  measure(cases, 10);
  fmt::print("Smallest base radius, offset free, harmonic rise and return:\n\n");
  fmt::print("| by | µs | relative error |\n|---|---|---|\n");
  for (const Case& one : cases) {
    one.run();
    fmt::print("| {} | {:.1f} | {:.1e} |\n", one.name, one.nanoseconds / 1000,
               std::abs(result / true_radius() - 1));
  }
}

}  // namespace
}  // namespace cognate::bench

int main() {
  cognate::bench::print();
}
