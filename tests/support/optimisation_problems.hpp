/// @file Problems with known answers that every solver is run over.
#pragma once

#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "synthesis/optimise/model.hpp"

namespace cognate::synthesis::testing {

using Complex = std::complex<double>;
using Function = std::function<std::vector<Complex>(std::span<const Complex>)>;

/// A model written once in complex arithmetic: the derivatives are complex steps (Squire and Trapp,
/// 1998), exact to rounding and independent of anything in the library.
class FunctionModel final : public Model {
 public:
  struct Parts {
    std::vector<Variable> variables;
    Function residuals;
    Function constraints = [](std::span<const Complex>) { return std::vector<Complex>(); };
    Objective objective = Objective::sum_of_squares;
    std::vector<int> local_of_residual = {};
    int local_count = 0;
    std::function<bool(std::span<const double>)> has_value = [](auto) { return true; };
    int equality_count = 0;
  };

  explicit FunctionModel(Parts parts) : parts_(std::move(parts)) {
    std::vector<Complex> x(parts_.variables.size(), 1.0);
    residual_count_ = static_cast<int>(parts_.residuals(x).size());
    constraint_count_ = static_cast<int>(parts_.constraints(x).size());
  }

  std::span<const Variable> variables() const override { return parts_.variables; }
  int residual_count() const override { return residual_count_; }
  int constraint_count() const override { return constraint_count_; }
  int equality_count() const override { return parts_.equality_count; }
  Objective objective() const override { return parts_.objective; }
  std::span<const int> local_of_residual() const override { return parts_.local_of_residual; }
  int local_count() const override { return parts_.local_count; }

  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override {
    if (!parts_.has_value(x)) return false;
    fill(parts_.residuals, x, r, jacobian);
    for (int k = 0; k < local_count() && !local.empty(); ++k) {
      const std::vector<double> column = derivative(parts_.residuals, x, global_count() + k);
      for (int row = 0; row < residual_count_; ++row) {
        if (parts_.local_of_residual[row] == k) local[row] = column[row];
      }
    }
    return true;
  }

  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override {
    fill(parts_.constraints, x, c, jacobian);
  }

 private:
  static std::vector<double> derivative(const Function& function, std::span<const double> x,
                                        int column) {
    constexpr double step = 1e-100;
    std::vector<Complex> z(x.begin(), x.end());
    z[column] += Complex(0, step);
    std::vector<double> out;
    for (const Complex& value : function(z)) out.push_back(value.imag() / step);
    return out;
  }

  void fill(const Function& function, std::span<const double> x, std::span<double> values,
            std::span<double> jacobian) const {
    const std::vector<Complex> z(x.begin(), x.end());
    const std::vector<Complex> value = function(z);
    for (std::size_t i = 0; i < value.size(); ++i) values[i] = value[i].real();
    const int n = global_count();
    for (int j = 0; j < n && !jacobian.empty(); ++j) {
      const std::vector<double> column = derivative(function, x, j);
      for (std::size_t i = 0; i < value.size(); ++i) jacobian[i * n + j] = column[i];
    }
  }

  Parts parts_;
  int residual_count_ = 0;
  int constraint_count_ = 0;
};

/// A model, where to start, and every local minimum that may be reached from there. `x` is empty
/// where many points share the minimum.
struct Problem {
  struct Minimum {
    double objective = 0;
    std::vector<double> x;
  };
  std::string name;
  FunctionModel model;
  std::vector<std::vector<double>> starts;
  std::vector<Minimum> minima;
  bool rugged = false;    ///< there are more minima than those listed, away from the starts
  bool singular = false;  ///< JᵀJ is singular at the minimum: x is known to few digits only
};

inline std::vector<Variable> boxes(std::vector<std::pair<double, double>> bounds) {
  std::vector<Variable> out;
  for (const auto& [lower, upper] : bounds) {
    out.push_back({.name = "x" + std::to_string(out.size() + 1), .lower = lower, .upper = upper});
  }
  return out;
}

inline std::vector<Variable> free_variables(int count) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return boxes(std::vector<std::pair<double, double>>(count, {-infinity, infinity}));
}

using Values = std::vector<Complex>;
using Point = std::span<const Complex>;

inline Values rosenbrock(Point x) {
  return {10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]};
}

/// Moré, Garbow and Hillstrom (1981), problems 1, 2 and 13.
inline std::vector<Problem> unconstrained_problems() {
  std::vector<Problem> out;
  out.push_back({.name = "rosenbrock",
                 .model = FunctionModel({free_variables(2), rosenbrock}),
                 .starts = {{-1.2, 1}, {-12, 10}, {3, -2}},
                 .minima = {{0, {1, 1}}}});
  out.push_back({.name = "freudenstein_roth",
                 .model = FunctionModel({free_variables(2),
                                         [](Point x) -> Values {
                                           return {
                                               -13.0 + x[0] + ((5.0 - x[1]) * x[1] - 2.0) * x[1],
                                               -29.0 + x[0] + ((x[1] + 1.0) * x[1] - 14.0) * x[1]};
                                         }}),
                 .starts = {{0.5, -2}, {6, 3}, {15, -2}},
                 .minima = {{0, {5, 4}}, {48.98425367924, {11.41277900, -0.8968052532}}}});
  out.push_back({.name = "powell_singular",
                 .model = FunctionModel({free_variables(4),
                                         [](Point x) -> Values {
                                           return {x[0] + 10.0 * x[1],
                                                   std::sqrt(5.0) * (x[2] - x[3]),
                                                   (x[1] - 2.0 * x[2]) * (x[1] - 2.0 * x[2]),
                                                   std::sqrt(10.0) * (x[0] - x[3]) * (x[0] - x[3])};
                                         }}),
                 .starts = {{3, -1, 0, 1}, {1, 2, -1, 3}},
                 .minima = {{0, {0, 0, 0, 0}}},
                 .singular = true});
  return out;
}

/// Minima on bounds, one variable fixed, scales far apart, a region without value.
inline std::vector<Problem> bounded_problems() {
  std::vector<Problem> out;
  out.push_back({.name = "rosenbrock_bounded",
                 .model = FunctionModel({boxes({{-2, 0.5}, {-2, 2}}), rosenbrock}),
                 .starts = {{-1.2, 1}, {0.5, -2}, {9, 9}},
                 .minima = {{0.25, {0.5, 0.25}}}});
  // At x₁ = 0.5 the second coordinate stops at its own bound: r = (10·(0.1 − 0.25), 0.5) is not the
  // least, x₁ moves back to where 200 x₁ (x₁² − 0.1) = 1 − x₁.
  out.push_back({.name = "rosenbrock_low_ceiling",
                 .model = FunctionModel({boxes({{0, 0.5}, {-2, 0.1}}), rosenbrock}),
                 .starts = {{0.1, -1}, {0.5, 0.1}},
                 .minima = {{0.4566745074985484, {0.33176908118957865, 0.1}}}});
  out.push_back({.name = "rosenbrock_fixed",
                 .model = FunctionModel({boxes({{0.7, 0.7}, {-2, 2}}), rosenbrock}),
                 .starts = {{0.7, -1}},
                 .minima = {{0.09, {0.7, 0.49}}}});
  FunctionModel::Parts scaled{free_variables(2), [](Point x) -> Values {
                                return {10.0 * (1e-6 * x[1] - 1e6 * x[0] * x[0]), 1.0 - 1e3 * x[0]};
                              }};
  scaled.variables[0].scale = 1e-3;
  scaled.variables[1].scale = 1e6;
  out.push_back({.name = "rosenbrock_scaled",
                 .model = FunctionModel(scaled),
                 .starts = {{-1.2e-3, 1e6}},
                 .minima = {{0, {1e-3, 1e6}}}});
  // A full Gauss-Newton step from 5 lands at 5 − 5 log 5 < 0, where there is no logarithm.
  FunctionModel::Parts logarithm{boxes({{-10, 10}}),
                                 [](Point x) -> Values { return {std::log(x[0])}; }};
  logarithm.has_value = [](std::span<const double> x) { return x[0] > 0; };
  out.push_back({.name = "logarithm",
                 .model = FunctionModel(logarithm),
                 .starts = {{5}, {9}, {0.01}},
                 .minima = {{0, {1}}}});
  return out;
}

/// Hock and Schittkowski (1981), problems 22, 43, 65 and 76, completed to sums of squares.
inline std::vector<Problem> constrained_problems() {
  std::vector<Problem> out;
  out.push_back({.name = "hs22",
                 .model = FunctionModel({free_variables(2),
                                         [](Point x) -> Values {
                                           return {x[0] - 2.0, x[1] - 1.0};
                                         },
                                         [](Point x) -> Values {
                                           return {2.0 - x[0] - x[1], x[1] - x[0] * x[0]};
                                         }}),
                 .starts = {{2, 2}, {-3, 1}, {0, 5}},
                 .minima = {{1, {1, 1}}}});
  const Function residuals43 = [](Point x) -> Values {
    return {x[0] - 2.5, x[1] - 2.5, std::sqrt(2.0) * (x[2] - 5.25), x[3] + 3.5};
  };
  const Function constraints43 = [](Point x) -> Values {
    const Complex a = x[0] * x[0], b = x[1] * x[1], c = x[2] * x[2], d = x[3] * x[3];
    return {8.0 - a - b - c - d - x[0] + x[1] - x[2] + x[3],
            10.0 - a - 2.0 * b - c - 2.0 * d + x[0] + x[3],
            5.0 - 2.0 * a - b - c - 2.0 * x[0] + x[1] + x[3]};
  };
  out.push_back({.name = "hs43",
                 .model = FunctionModel({free_variables(4), residuals43, constraints43}),
                 .starts = {{0, 0, 0, 0}, {3, 3, 3, 3}, {-2, 1, 4, 0}},
                 .minima = {{79.875 - 44, {0, 1, 2, -1}}}});
  // The same in units far apart.
  const std::vector<double> unit = {1e3, 1e-2, 1, 1e-5};
  const auto in_units = [unit](const Function& function) -> Function {
    return [unit, function](Point x) {
      Values plain;
      for (std::size_t i = 0; i < x.size(); ++i) plain.push_back(x[i] / unit[i]);
      return function(plain);
    };
  };
  FunctionModel::Parts scaled{free_variables(4), in_units(residuals43), in_units(constraints43)};
  for (std::size_t i = 0; i < unit.size(); ++i) scaled.variables[i].scale = unit[i];
  out.push_back({.name = "hs43_scaled",
                 .model = FunctionModel(scaled),
                 .starts = {{0, 0, 0, 0}, {3e3, 3e-2, 3, 3e-5}},
                 .minima = {{79.875 - 44, {0, 1e-2, 2, -1e-5}}}});
  out.push_back(
      {.name = "hs65",
       .model = FunctionModel({boxes({{-4.5, 4.5}, {-4.5, 4.5}, {-5, 5}}),
                               [](Point x) -> Values {
                                 return {x[0] - x[1], (x[0] + x[1] - 10.0) / 3.0, x[2] - 5.0};
                               },
                               [](Point x) -> Values {
                                 return {(48.0 - x[0] * x[0] - x[1] * x[1] - x[2] * x[2]) / 48.0};
                               }}),
       .starts = {{-5, 5, 0}, {0, 0, 0}, {4, 4, 4}},
       .minima = {{0.9535288567, {3.6504617, 3.6504617, 4.6204171}}}});
  out.push_back({.name = "hs76",
                 .model = FunctionModel({boxes({{0, 10}, {0, 10}, {0, 10}, {0, 10}}),
                                         [](Point x) -> Values {
                                           return {x[0] - 0.5 * x[2] - 0.5,
                                                   std::sqrt(0.5) * (x[3] + x[2] - 1.0),
                                                   0.5 * (x[2] + 3.0),
                                                   std::sqrt(0.5) * (x[1] - 3.0)};
                                         },
                                         [](Point x) -> Values {
                                           return {5.0 - x[0] - 2.0 * x[1] - x[2] - x[3],
                                                   4.0 - 3.0 * x[0] - x[1] - 2.0 * x[2] + x[3],
                                                   x[1] + 4.0 * x[2] - 1.5};
                                         }}),
                 .starts = {{0.5, 0.5, 0.5, 0.5}, {10, 10, 10, 10}, {0, 0, 0, 0}},
                 .minima = {{31.0 / 11, {3.0 / 11, 23.0 / 11, 0, 6.0 / 11}}}});
  return out;
}

/// Hock and Schittkowski (1981), problems 6, 14, 42, 52 and 60: equalities, in 14 an inequality
/// too.
inline std::vector<Problem> equality_problems() {
  std::vector<Problem> out;
  const auto add = [&](std::string name, int equalities, std::vector<Variable> variables,
                       Function residuals, Function constraints,
                       std::vector<std::vector<double>> starts, Problem::Minimum minimum) {
    FunctionModel::Parts parts{std::move(variables), std::move(residuals), std::move(constraints)};
    parts.equality_count = equalities;
    const bool rugged = name == "hs60";
    out.push_back(
        {std::move(name), FunctionModel(parts), std::move(starts), {std::move(minimum)}, rugged});
  };
  add(
      "hs6", 1, free_variables(2), [](Point x) -> Values { return {1.0 - x[0]}; },
      [](Point x) -> Values { return {10.0 * (x[1] - x[0] * x[0])}; }, {{-1.2, 1}, {2, 2}},
      {0, {1, 1}});
  const double root7 = std::sqrt(7.0);
  add(
      "hs14", 1, free_variables(2),
      [](Point x) -> Values {
        return {x[0] - 2.0, x[1] - 1.0};
      },
      [](Point x) -> Values {
        return {x[0] - 2.0 * x[1] + 1.0, 1.0 - 0.25 * x[0] * x[0] - x[1] * x[1]};
      },
      {{2, 2}, {0, 0}}, {9 - 2.875 * root7, {0.5 * (root7 - 1), 0.25 * (root7 + 1)}});
  const double root2 = std::sqrt(2.0);
  add(
      "hs42", 2, free_variables(4),
      [](Point x) -> Values {
        return {x[0] - 1.0, x[1] - 2.0, x[2] - 3.0, x[3] - 4.0};
      },
      [](Point x) -> Values {
        return {x[0] - 2.0, x[2] * x[2] + x[3] * x[3] - 2.0};
      },
      {{1, 1, 1, 1}, {2, 0, 2, 0.5}}, {28 - 10 * root2, {2, 2, 0.6 * root2, 0.8 * root2}});
  add(
      "hs52", 3, free_variables(5),
      [](Point x) -> Values {
        return {4.0 * x[0] - x[1], x[1] + x[2] - 2.0, x[3] - 1.0, x[4] - 1.0};
      },
      [](Point x) -> Values {
        return {x[0] + 3.0 * x[1], x[2] + x[3] - 2.0 * x[4], x[1] - x[4]};
      },
      {{2, 2, 2, 2, 2}, {0, 0, 0, 0, 0}},
      {1859 / 349.0, {-33 / 349.0, 11 / 349.0, 180 / 349.0, -158 / 349.0, 11 / 349.0}});
  add(
      "hs60", 1, boxes({{-10, 10}, {-10, 10}, {-10, 10}}),
      [](Point x) -> Values {
        return {x[0] - 1.0, x[0] - x[1], (x[1] - x[2]) * (x[1] - x[2])};
      },
      [root2](Point x) -> Values {
        return {x[0] * (1.0 + x[1] * x[1]) + x[2] * x[2] * x[2] * x[2] - 4.0 - 3 * root2};
      },
      {{2, 2, 2}}, {0.03256820025, {1.104859024, 1.196674194, 1.535262257}});
  return out;
}

/// Best approximation of `target` on [-1, 1], sampled at steps of 1/40, by a polynomial.
inline Function approximation(std::function<double(double)> target, int coefficients) {
  return [target, coefficients](Point x) {
    Values out;
    for (int i = -40; i <= 40; ++i) {
      const double at = i / 40.0;
      Complex value = 0;
      for (int k = coefficients - 1; k >= 0; --k) value = value * at + x[k];
      out.push_back(value - target(at));
    }
    return out;
  };
}

/// Charalambous and Conn (1978), Madsen (1975), and Chebyshev's own.
inline std::vector<Problem> minimax_problems() {
  const auto minimax = [](Function residuals, int variables) {
    FunctionModel::Parts parts{free_variables(variables), std::move(residuals)};
    parts.objective = Objective::max_abs;
    return parts;
  };
  std::vector<Problem> out;
  out.push_back({.name = "cb2",
                 .model = FunctionModel(minimax(
                     [](Point x) -> Values {
                       return {x[0] * x[0] + x[1] * x[1] * x[1] * x[1],
                               (2.0 - x[0]) * (2.0 - x[0]) + (2.0 - x[1]) * (2.0 - x[1]),
                               2.0 * std::exp(x[1] - x[0])};
                     },
                     2)),
                 .starts = {{1, -0.1}, {2, 2}, {0, 1}},
                 .minima = {{1.95222449387, {1.139037652, 0.8995599384}}}});
  out.push_back(
      {.name = "madsen",
       .model = FunctionModel(minimax(
           [](Point x) -> Values {
             return {x[0] * x[0] + x[1] * x[1] + x[0] * x[1], std::sin(x[0]), std::cos(x[1])};
           },
           2)),
       .starts = {{3, 1}, {-1, 1}, {1, -1}},
       .minima = {{0.61643243560, {0.453296, -0.906592}}, {0.61643243560, {-0.453296, 0.906592}}}});
  out.push_back(
      {.name = "chebyshev_cubic",
       .model = FunctionModel(minimax(approximation([](double x) { return x * x * x; }, 3), 3)),
       .starts = {{0, 0, 0}, {1, -1, 2}},
       .minima = {{0.25, {0, 0.75, 0}}}});
  // x² by a + bx with b ≥ 1/2: the error is +e at −1 and −e at 1/4.
  auto constrained = minimax(approximation([](double x) { return x * x; }, 2), 2);
  constrained.constraints = [](Point x) -> Values { return {x[1] - 0.5}; };
  out.push_back({.name = "chebyshev_constrained",
                 .model = FunctionModel(constrained),
                 .starts = {{0, 0}, {2, 2}},
                 .minima = {{0.78125, {0.71875, 0.5}}}});
  return out;
}

/// Orthogonal-distance fits: each point's angle on the curve is a local variable.
inline std::vector<Problem> local_problems() {
  std::vector<Problem> out;

  // At each of eight angles one point inside and one outside the circle (3, −1; 2), both by 0.1:
  // every other circle is farther from them, and the least is 16 · 0.1².
  std::vector<double> at, px, py;
  for (int i = 0; i < 16; ++i) {
    const double angle = (i / 2) * kPi / 4, radius = i % 2 == 0 ? 2.1 : 1.9;
    at.push_back(angle);
    px.push_back(3 + radius * std::cos(angle));
    py.push_back(-1 + radius * std::sin(angle));
  }
  FunctionModel::Parts circle{free_variables(3 + 16), [px, py](Point x) {
                                Values out;
                                for (int i = 0; i < 16; ++i) {
                                  out.push_back(x[0] + x[2] * std::cos(x[3 + i]) - px[i]);
                                  out.push_back(x[1] + x[2] * std::sin(x[3 + i]) - py[i]);
                                }
                                return out;
                              }};
  circle.local_count = 16;
  circle.variables[2].scale = 10;
  circle.variables[5].scale = 0.1;
  for (int i = 0; i < 16; ++i)
    circle.local_of_residual.insert(circle.local_of_residual.end(), 2, i);
  std::vector<double> start = {2.5, -0.5, 1.5}, answer = {3, -1, 2};
  for (int i = 0; i < 16; ++i) start.push_back(at[i] + 0.2 * std::sin(i));
  answer.insert(answer.end(), at.begin(), at.end());
  out.push_back({.name = "circle",
                 .model = FunctionModel(circle),
                 .starts = {start},
                 .minima = {{0.16, answer}}});

  // Twelve points on an ellipse, found again exactly.
  const std::vector<double> planted = {1, 2, 3, 1.5, 0.4};
  const auto ellipse_point = [](auto centre_x, auto centre_y, auto a, auto b, auto tilt, auto t) {
    const auto u = a * std::cos(t), v = b * std::sin(t);
    return std::pair(centre_x + u * std::cos(tilt) - v * std::sin(tilt),
                     centre_y + u * std::sin(tilt) + v * std::cos(tilt));
  };
  std::vector<double> ellipse_start = {0.8, 2.3, 2.5, 1.8, 0.3}, ellipse_answer = planted;
  std::vector<std::pair<double, double>> points;
  FunctionModel::Parts ellipse{boxes({{-5, 5}, {-5, 5}, {0.1, 9}, {0.1, 9}, {-1, 1}}), {}};
  for (int i = 0; i < 12; ++i) {
    const double t = 2 * kPi * i / 12;
    points.push_back(ellipse_point(planted[0], planted[1], planted[2], planted[3], planted[4], t));
    ellipse_start.push_back(t + 0.1);
    ellipse_answer.push_back(t);
    ellipse.variables.push_back({.name = "t", .lower = -10, .upper = 10});
    ellipse.local_of_residual.insert(ellipse.local_of_residual.end(), 2, i);
  }
  ellipse.local_count = 12;
  ellipse.residuals = [points, ellipse_point](Point x) {
    Values out;
    for (int i = 0; i < 12; ++i) {
      const auto [u, v] = ellipse_point(x[0], x[1], x[2], x[3], x[4], x[5 + i]);
      out.push_back(u - points[i].first);
      out.push_back(v - points[i].second);
    }
    return out;
  };
  out.push_back({.name = "ellipse",
                 .model = FunctionModel(ellipse),
                 .starts = {ellipse_start},
                 .minima = {{0, ellipse_answer}}});
  return out;
}

inline const std::vector<Problem>& all_problems() {
  static const std::vector<Problem> problems = [] {
    std::vector<Problem> out;
    for (auto group : {unconstrained_problems(), bounded_problems(), constrained_problems(),
                       equality_problems(), minimax_problems(), local_problems()}) {
      out.insert(out.end(), group.begin(), group.end());
    }
    return out;
  }();
  return problems;
}

}  // namespace cognate::synthesis::testing
