/// @file Random linkages with loads, and their forces from closures and equations of motion of
/// their own, which share no code with the program.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cognate::stress {

enum class When { always, advance, back, interval, stroke };

/// A linkage with a load on its output, and what a file says of it. Of a slider-crank `rocker` is 0
/// and `frame` its offset.
struct Linkage {
  bool slides = false;
  double crank = 1, coupler = 1, rocker = 1, frame = 1, side = 1;
  double mass = 0, u = 0, v = 0, inertia = 0, output_inertia = 0, gravity = 0, speed = 1, load = 0;
  When when = When::always;
  double from = 0, to = 0;  ///< degrees, or parts of the stroke
  double start = 0;
  int steps = 3;
};

/// What is judged: the driving torque, and the magnitudes of reactions. A massless crank carries at
/// A the force of B, a massless rocker at D that of C.
enum class ForceQuantity { torque, at_b, at_c, on_slide };

/// A force at the crank's angle `q`, with or without the load.
double force(const Linkage& linkage, ForceQuantity quantity, double q, bool loaded);

/// Whether the load acts at `q`.
bool acts(const Linkage& linkage, double q);

/// How far the output is along its stroke at `q`, from 0 to 1.
double part_of_stroke(const Linkage& linkage, double q);

/// Where the linkage closes, as intervals of the angle, over a turn.
std::vector<std::pair<double, double>> ranges(const Linkage& linkage);

/// The file that analyses it.
std::string file_of(const Linkage& linkage);

/// Four-bars (cranks that turn and that rock) and slider-cranks, clear of change points.
class LinkageFamily {
 public:
  explicit LinkageFamily(std::uint64_t seed) : random_(seed) {}

  Linkage next();

 private:
  double between(double a, double b) { return std::uniform_real_distribution(a, b)(random_); }
  Linkage draw();

  std::mt19937_64 random_;
};

}  // namespace cognate::stress
