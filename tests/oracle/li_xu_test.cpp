/// The worked examples of Li & Xu 2011 on kinematics, forces and types: every output at every
/// position, and the work of the driving torque over a cycle.
#include "tests/oracle/li_xu.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"

namespace cognate::li_xu_test {
namespace {

constexpr double pi = kPi;

double largest(const std::vector<double>& values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

bool is_angle(const std::string& output) {
  return output.starts_with("theta");
}

TEST(LiXu, EveryOutputAtEveryPosition) {
  constexpr double tolerance = 1e-10;  // of the greatest value in the column
  std::size_t compared = 0;
  for (const Example& example : read_examples()) {
    const Model model = model_of(example);
    for (std::size_t i = 0; i < example.crank.size(); ++i) {
      const Instant now = instant(model, example.crank[i]);
      for (const auto& [name, expected] : example.at) {
        ASSERT_TRUE(model.outputs.contains(name)) << example.number << ' ' << name;
        ASSERT_EQ(expected.size(), example.crank.size());
        const double error = model.outputs.at(name)(now) - expected[i];
        EXPECT_LE(std::abs(is_angle(name) ? std::remainder(error, 2 * pi) : error),
                  tolerance * largest(expected))
            << example.number << ", " << example.title << ": " << name
            << " at theta1 = " << example.crank[i] * 180 / pi << " deg should be " << expected[i];
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 1308U);
}

TEST(LiXu, StrokeAndTimeRatioOfTheShaper) {
  const auto examples = read_examples();
  const auto found = std::ranges::find(examples, "1-4", &Example::number);
  ASSERT_NE(found, examples.end());
  const Model model = model_of(*found);
  const Extremes ram = extremes(model.mechanism, 5), bar = extremes(model.mechanism, 3);
  const auto& expected = found->over_the_cycle;
  const double back = std::remainder(ram.crank_at_greatest - ram.crank_at_least, 2 * pi);
  EXPECT_NEAR(ram.greatest, expected.at("sE_max"), 1e-12);  // printed with 12 digits
  EXPECT_NEAR(ram.least, expected.at("sE_min"), 1e-12);
  EXPECT_NEAR(ram.greatest - ram.least, expected.at("stroke"), 1e-14);
  EXPECT_NEAR(ram.crank_at_greatest, expected.at("theta1_at_sEmax"), 1e-12);
  EXPECT_NEAR(ram.crank_at_least, expected.at("theta1_at_sEmin"), 1e-12);
  EXPECT_NEAR(bar.greatest - bar.least, expected.at("swing_of_guide"), 1e-13);
  EXPECT_NEAR((2 * pi - back) / back, expected.at("K"), 1e-12);
}

/// ∫ f over [from, to] by Gauss and Legendre's rule of five points in `panels` panels.
template <class Function>
double integral(const Function& f, double from, double to, int panels) {
  constexpr double node[] = {0, 0.5384693101056831, 0.9061798459386640};
  constexpr double weight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const double half = (to - from) / (2 * panels);
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel) {
    const double middle = from + (2 * panel + 1) * half;
    sum += weight[0] * f(middle);
    for (int k = 1; k < 3; ++k) {
      sum += weight[k] * (f(middle - half * node[k]) + f(middle + half * node[k]));
    }
  }
  return half * sum;
}

/// Crank angles in (0, 2π) at which loads begin or cease to act.
std::vector<double> switches(const Model& model) {
  const auto acting = [&](double crank) { return instant(model, crank).loads.size(); };
  std::vector<double> found;
  constexpr int steps = 90;
  for (int i = 0; i < steps; ++i) {
    double low = 2 * pi * i / steps, high = 2 * pi * (i + 1) / steps;
    const std::size_t before = acting(low);
    if (acting(high) == before) continue;
    for (int halving = 0; halving < 50; ++halving) {
      const double middle = (low + high) / 2;
      (acting(middle) == before ? low : high) = middle;
    }
    found.push_back(high);
  }
  return found;
}

/// The work of the driving torque in a turn of the crank, from piece to piece between switches.
double cycle_work(const Model& model) {
  std::vector<double> ends = switches(model);
  ends.insert(ends.begin(), 0);
  ends.push_back(2 * pi);
  const auto torque = [&](double crank) { return instant(model, crank).forces.drive; };
  double work = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    work += integral(torque, ends[i - 1], ends[i], 60);
  }
  return work;
}

TEST(LiXu, WorkOverACycleIsThatOfTheLoads) {
  int tested = 0;
  for (const Example& example : read_examples()) {
    if (example.number.front() != '2') continue;
    ++tested;
    double expected = 0;
    if (example.title.find("working") != std::string::npos) {
      expected = 100 * 2 * std::asin(0.4);  // 82.3033692135: the torque times the swing
    } else if (example.number == "2-4") {
      expected = 5880 * 0.9 * 6 / 11;  // 2886.545454545: the force times 90 % of the stroke
    }
    const Model model = model_of(example);
    const std::vector<double>& torque = example.at.at("Mb");
    EXPECT_NEAR(cycle_work(model), expected, 1e-10 * largest(torque))
        << example.number << ", " << example.title;
  }
  EXPECT_GE(tested, 9);
}

TEST(LiXu, Types) {
  for (const TypeExample& example : read_types()) {
    EXPECT_EQ(problems::to_string(mobility_class(example.links)), example.mobility);
  }
}

}  // namespace
}  // namespace cognate::li_xu_test
