/// @file A problem as the solvers race for it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "problems/function/problem.hpp"
#include "problems/linkage/result.hpp"
#include "problems/path/problem.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::bench {

/// How starts are drawn: `random` anywhere in a box where the linkage closes; `screened` as the
/// search itself draws them, by structure and the best of many.
enum class Starts { random, screened };

/// One descent: what is minimised, from where, and the error of the linkage at a point; infinite
/// where that breaks a constraint or has a defect.
struct Attempt {
  std::shared_ptr<const synthesis::Model> model;
  std::vector<double> start;
  std::function<double(std::span<const double>)> error;
};

/// The next attempt; empty where none was found.
using Draw = std::function<std::optional<Attempt>(std::mt19937_64&)>;

struct Contest {
  std::string name;
  std::string kind;
  /// The least error known, as the published ones are given; empty: the best of this race counts.
  std::optional<double> best_known;
  double unit = 1;                    ///< what errors are divided by where the least is 0
  std::function<Draw(Starts)> begin;  ///< a source of attempts that remembers no race before
  /// The error of the best design that `auto` finds with so many starts; infinite without any.
  std::function<double(int starts, const problems::Run& run)> solve;
};

/// `name`: of the library's file.
Contest path_contest(const problems::PathProblem& problem, std::string name);
Contest function_contest(const problems::FunctionProblem& problem, std::string name);

/// A point within the bounds of `model`, cut to ±`reach`, where it has a value; empty where many
/// draws found none.
std::optional<std::vector<double>> random_point(const synthesis::Model& model, double reach,
                                                std::mt19937_64& random);

}  // namespace cognate::bench
