/// @file The worked examples of li_xu.toml, and the mechanisms they are about.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "problems/evaluation/active_loads.hpp"

namespace cognate {

struct Example {
  std::string number, title;
  std::map<std::string, double> given;
  std::vector<double> crank;                      ///< crank angles, radians
  std::map<std::string, std::vector<double>> at;  ///< of each output its value at `crank`
  std::map<std::string, double> over_the_cycle;
};

/// Reads li_xu.toml; throws what the parser throws.
std::vector<Example> read_examples();

/// A mechanism of `read_types`, and its class as the file writes it.
struct TypeExample {
  Lengths<double> links;
  std::string mobility;
};
std::vector<TypeExample> read_types();

/// All there is to know at one position.
struct Instant {
  MechanismMotion<2> motion;
  DriveRate rate;
  std::vector<Load> loads;
  Forces forces;

  Vec2d position(const Attached<double>& point) const;
  Vec2d velocity(const Attached<double>& point) const;
  Vec2d acceleration(const Attached<double>& point) const;
};

/// An output of the examples, e.g. "F12x", from the state of the mechanism.
using Output = std::function<double(const Instant&)>;

/// The mechanism of an example.
struct Model {
  Mechanism<double> mechanism;
  DriveRate rate;
  std::vector<Inertia> inertias;
  Vec2d gravity;
  std::vector<problems::LoadRule> rules;
  std::vector<problems::Stroke> strokes;
  std::map<std::string, Output> outputs;
};

Model model_of(const Example& example);

/// The model at a crank angle.
Instant instant(const Model& model, double crank);

/// Extremes of the travel of `body` over a turn of the crank that bracket [0, 2π) in two strokes,
/// by bisection on its velocity: crank angles of the least and of the greatest.
struct Extremes {
  double crank_at_least = 0, crank_at_greatest = 0;
  double least = 0, greatest = 0;
};
Extremes extremes(const Mechanism<double>& mechanism, int body);

}  // namespace cognate
