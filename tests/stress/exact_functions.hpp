/// @file Random exact problems of function generation, and whether their designs can be assembled
/// over the whole motion: by the triangle inequality alone, at its extremes and at many samples.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <variant>

#include "analysis/linkage/slider_crank.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/function/problem.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"

namespace cognate::problems {

/// What was looked at and what was wrong.
struct ExactFunctionCount {
  int problems = 0, refused = 0, without_design = 0;
  int sound = 0;          ///< designs that meet everything
  int defective = 0;      ///< designs with a circuit defect
  int gaps = 0;           ///< sound designs that cannot be assembled somewhere
  int false_defects = 0;  ///< designs with a circuit defect that can
  std::string first;      ///< the first problem with a wrong design
};

class ExactFunctionStress {
 public:
  ExactFunctionStress(std::uint64_t seed, int samples) : random_(seed), samples_(samples) {}

  /// One more problem: 3, 4 or 5 points, a four-bar or a slider-crank, a range up to a full turn.
  void add(ExactFunctionCount& count) {
    const std::string text = next();
    ++count.problems;
    const auto problem = parse_task(text);
    if (!problem) {
      ++count.refused;
      return;
    }
    const Result result = solve(std::get<FunctionProblem>(*problem), {});
    if (result.designs.empty()) ++count.without_design;
    for (const Design& design : result.designs) judge(design, text, count);
  }

 private:
  double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }

  std::string next() {
    const bool slider = random_() % 4 == 0;
    // Families on two numbers are two hundred times as dear as the rest.
    const int points = random_() % 16 == 0 ? 3 : 4 + int(random_() % 2);
    static const char* const kFunctions[] = {"log(x)", "x^2", "1/x", "sqrt(x)", "exp(x)"};
    const double low = uniform(0.5, 1.5), high = low + uniform(0.3, 2);
    input_ = uniform(20, 360);
    const double output = uniform(20, 120) * (random_() % 2 == 0 ? 1 : -1);
    return "kind = \"function-generation\"\n[target]\nfunction = \"" +
           std::string(kFunctions[random_() % 5]) + "\"\ndomain = [" + std::to_string(low) + ", " +
           std::to_string(high) + "]\ninput_range_deg = " + std::to_string(input_) +
           (slider ? "\noutput_range = " + std::to_string(output / 60)
                   : "\noutput_range_deg = " + std::to_string(output)) +
           "\nprecision_points = " + std::to_string(points) +
           (slider ? "\n[mechanism]\ntype = \"slider-crank\"\n" : "\n");
  }

  void judge(const Design& design, const std::string& text, ExactFunctionCount& count) const {
    const auto& defects = design.metrics.defects;
    const bool circuit = std::ranges::count(defects, Defect::circuit) > 0;
    const bool branch = std::ranges::count(defects, Defect::branch) > 0;
    const bool sound = std::ranges::all_of(design.constraints, &ConstraintCheck::satisfied);
    const double room = least_room(design);
    count.sound += sound;
    count.defective += circuit;
    // A motion may end beyond a dead point by 1e-7 of a radian.
    const bool gap = (sound || !circuit) && !branch && room < -3e-7;
    const bool false_defect = circuit && !turns(design) && room > 3e-7;
    count.gaps += gap;
    count.false_defects += false_defect;
    if (count.first.empty() && (gap || false_defect)) count.first = text;
  }

  /// Whether the crank turns fully: precision points on its two sides are on two circuits.
  static bool turns(const Design& design) {
    double least = HUGE_VAL;
    for (int k = 0; k < 4; ++k) least = std::min(least, room_at(design, k * kRightAngle));
    return least >= 0;
  }

  /// The least distance by which the links reach over the motion, relative: negative in a gap.
  double least_room(const Design& design) const {
    const double start = *design.metrics.input_start, sweep = input_ * kPi / 180;
    double least = room_at(design, start);
    for (int i = 0; i <= samples_; ++i) {
      least = std::min(least, room_at(design, start + sweep * i / samples_));
    }
    constexpr double kQuarter = kRightAngle;
    for (double k = std::ceil(start / kQuarter); k * kQuarter <= start + sweep; ++k) {
      least = std::min(least, room_at(design, k * kQuarter));
    }
    return least;
  }

  static double room_at(const Design& design, double angle) {
    if (const auto* m = std::get_if<SliderCrank>(&design.mechanism.description)) {
      return (m->coupler - std::abs(m->crank * std::sin(angle) - m->offset)) / m->crank;
    }
    const auto [l1, l2, l3, l4] = lengths(four_bar(design));
    const double d2 = l1 * l1 + l4 * l4 - 2 * l1 * l4 * std::cos(angle);
    const double most = (l2 + l3) * (l2 + l3) - d2, least = d2 - (l2 - l3) * (l2 - l3);
    return std::min(most, least) / (2 * l1 * l4);
  }

  std::mt19937_64 random_;
  int samples_;
  double input_ = 0;
};

}  // namespace cognate::problems
