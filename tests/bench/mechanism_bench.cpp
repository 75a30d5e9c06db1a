/// Time for one position of a mechanism given as data, by what is requested: positions, velocities,
/// accelerations, driving torque, all reactions. Times are per position of all bodies.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate {
namespace {

constexpr std::size_t positions = 64;

/// Crank directions all round, in no order that could be learned by heart.
std::vector<DrivePosition<double>> sweep() {
  std::vector<DrivePosition<double>> all;
  for (std::size_t i = 0; i < positions; ++i) {
    const double angle = kTurn * double(i * 39 % positions) / positions;
    all.push_back({{std::cos(angle), std::sin(angle)}, 0});
  }
  return all;
}

/// Li & Xu 2011, example 2-1.
Mechanism<double> four_bar() {
  return {Crank<double>{{0, 0}, 0.4}, {Rrr<double>{{1, {0.4, 0}}, {0, {1.2, 0}}, 1, 0.7}}};
}

/// Li & Xu 2011, example 2-4.
Mechanism<double> shaper() {
  return {Crank<double>{{0, 0.275}, 0.125},
          {Rpr<double>{{1, {0.125, 0}}, {0, {0, 0}}, 0},
           Rrp<double>{{3, {0.6, 0}}, 0.15, {0, {0, 0.575}, {1, 0}, 0}, Assembly::crossed}}};
}

template <int Order>
void motion(benchmark::State& state, const Mechanism<double>& mechanism) {
  const auto drives = sweep();
  MechanismMotion<Order> motion(mechanism);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(motion.move_to(drives[i]));
    benchmark::DoNotOptimize(motion.bodies().data());
    benchmark::ClobberMemory();
    i = (i + 1) % positions;
  }
}

/// Motions computed beforehand, so that the forces alone are timed; each body has mass, a load acts
/// on the last.
struct Bearing {
  InverseDynamics dynamics;
  std::vector<MechanismMotion<2>> motions;
  std::vector<Load> loads;
  DriveRate rate{10, 1};

  explicit Bearing(const Mechanism<double>& mechanism)
      : dynamics(mechanism,
                 std::vector<Inertia>(std::size_t(body_count(mechanism)), {2, {0.2, 0.1}, 0.3}),
                 {0, -9.8}) {
    for (const auto& drive : sweep()) {
      motions.emplace_back(mechanism);
      motions.back().move_to(drive);
    }
    loads = {{{body_count(mechanism) - 1, {0.1, 0}}, {100, 0}, 10}};
  }
};

void drive(benchmark::State& state, const Mechanism<double>& mechanism) {
  const Bearing bearing(mechanism);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        bearing.dynamics.drive<2>(bearing.motions[i].bodies(), bearing.rate, bearing.loads));
    i = (i + 1) % positions;
  }
}

void reactions(benchmark::State& state, const Mechanism<double>& mechanism) {
  Bearing bearing(mechanism);
  Forces forces = bearing.dynamics.forces();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(bearing.dynamics.solve<2>(bearing.motions[i].bodies(), bearing.rate,
                                                       bearing.loads, forces));
    benchmark::ClobberMemory();
    i = (i + 1) % positions;
  }
}

void register_all(const char* name, const Mechanism<double>& mechanism) {
  const auto add = [&](const char* what, auto function) {
    benchmark::RegisterBenchmark((std::string(name) + '/' + what).c_str(),
                                 [=](benchmark::State& state) { function(state, mechanism); });
  };
  add("position", motion<0>);
  add("velocity", motion<1>);
  add("acceleration", motion<2>);
  add("third derivative", motion<3>);
  add("driving torque alone", drive);
  add("all forces", reactions);
}

}  // namespace
}  // namespace cognate

int main(int argc, char** argv) {
  cognate::register_all("four-bar", cognate::four_bar());
  cognate::register_all("shaper", cognate::shaper());
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
