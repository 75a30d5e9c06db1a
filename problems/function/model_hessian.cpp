/// Second derivatives of the function model, for start angles that do not depend on the lengths.

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/function/extreme_crank_angle.hpp"
#include "problems/function/model.hpp"
#include "synthesis/optimise/closure_hessian.hpp"

namespace cognate::problems {
namespace {

/// By crank, coupler, rocker, frame and crank angle, in this order; symmetric.
using TransmissionHessian = std::array<std::array<double, 5>, 5>;

/// Of cos μ = (l₂² + l₃² − d²)/(2 l₂ l₃) with d² = l₁² + l₄² − 2 l₁ l₄ cos θ.
TransmissionHessian transmission_hessian(const Lengths<double>& links, double cosine, double sine) {
  enum { a, b, c, f, theta };
  const auto& [l1, l2, l3, l4] = links;
  const double d2 = l1 * l1 + l4 * l4 - 2 * l1 * l4 * cosine;
  TransmissionHessian out{};
  const auto set = [&](int i, int j, double value) { out[i][j] = out[j][i] = value; };
  set(b, b, (l3 - d2 / l3) / (l2 * l2 * l2));
  set(c, c, (l2 - d2 / l2) / (l3 * l3 * l3));
  set(b, c, -0.5 / (l2 * l2) - 0.5 / (l3 * l3) - 0.5 * d2 / (l2 * l2 * l3 * l3));
  // Through d²: its slopes, then its second derivatives.
  const double by_d2 = -0.5 / (l2 * l3);
  const std::array slopes{2 * (l1 - l4 * cosine), 0.0, 0.0, 2 * (l4 - l1 * cosine),
                          2 * l1 * l4 * sine};
  for (const int i : {a, f, theta}) {
    set(i, b, -by_d2 / l2 * slopes[i]);
    set(i, c, -by_d2 / l3 * slopes[i]);
  }
  set(a, a, 2 * by_d2);
  set(f, f, 2 * by_d2);
  set(a, f, -2 * cosine * by_d2);
  set(a, theta, 2 * l4 * sine * by_d2);
  set(f, theta, 2 * l1 * sine * by_d2);
  set(theta, theta, 2 * l1 * l4 * cosine * by_d2);
  return out;
}

constexpr int kInput = 4;  ///< index of the crank angle, and of the input's start

}  // namespace

/// Sums of slopes and second derivatives by lengths and crank angle.
struct FunctionModel::Curvature {
  std::array<double, 4> slopes{};
  synthesis::AngleHessian second{};

  void add(double weight, const AngleGradient<double>& slope,
           const synthesis::AngleHessian& hessian) {
    const std::array<double, 4> by_length{slope.crank, slope.coupler, slope.rocker, slope.frame};
    for (int i = 0; i < 4; ++i) slopes[i] += weight * by_length[i];
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < 5; ++j) second[i][j] += weight * hessian[i][j];
    }
  }
};

/// The transmission over the sweep: see `sweep_constraints`.
void FunctionModel::add_sweep_curvature(const FunctionGenerator& g, std::span<const double> weights,
                                        Curvature& out) const {
  const auto& [l1, l2, l3, l4] = g.links;
  for (int i = 0; i < 2; ++i) {
    const double sense = i == 0 ? 1 : -1;
    const auto extreme = extreme_crank_angle(wanted_.sweep, g.input_start, sense);
    const double c = std::cos(extreme.angle), s = std::sin(extreme.angle);
    const double d2 = l1 * l1 + l4 * l4 - 2 * l1 * l4 * c;
    const double cosine = (l2 * l2 + l3 * l3 - d2) / (2 * l2 * l3);
    auto second = transmission_hessian(g.links, c, s);
    for (int k = 0; k < 5 && !extreme.turns_with_start; ++k) {
      second[k][kInput] = second[kInput][k] = 0;
    }
    out.add(-sweep_weight_ * sense * weights[i],
            {(l4 * c - l1) / (l2 * l3), 1 / l3 - cosine / l2, 1 / l2 - cosine / l3,
             (l1 * c - l4) / (l2 * l3)},
            second);
  }
}

bool FunctionModel::lagrangian_hessian(std::span<const double> x,
                                       std::span<const double> of_residuals,
                                       std::span<const double> of_constraints,
                                       std::span<double> out) const {
  if (!has_hessian()) return false;
  const FunctionGenerator g = generator(x);
  const Closure<double> closure(g.links);
  const Vec2d half_start{std::cos(0.5 * g.input_start), std::sin(0.5 * g.input_start)};
  Curvature sum;
  for (std::size_t i = 0; i < wanted_.samples.size(); ++i) {
    const auto crank = crank_direction(half_start * half_input_[i]);
    const auto at = closure.at(crank, sign(assembly_));
    const Vec2d e1{crank.cos, crank.sin};
    sum.add(of_residuals[i], closure_gradient(g.links, e1, at).rocker,
            synthesis::closure_hessian(g.links, e1, at).rocker);
  }

  const auto of_lengths = static_cast<std::size_t>(linkage_constraints_.count());
  std::vector<double> values(of_lengths);
  std::vector<Lengths<double>> gradient(of_lengths);
  linkage_constraints_.evaluate(g.links, values, gradient);
  std::array<double, 16> of_links{};
  linkage_constraints_.add_hessian(g.links, of_constraints, of_links);
  for (std::size_t k = 0; k < of_lengths; ++k) {
    const Lengths<double>& slope = gradient[k];
    sum.add(of_constraints[k], {slope.crank, slope.coupler, slope.rocker, slope.frame}, {});
  }
  for (int i = 0; i < 16; ++i) sum.second[i / 4][i % 4] += of_links[i];
  if (limits_sweep_) add_sweep_curvature(g, of_constraints.subspan(of_lengths), sum);

  // From lengths to their logarithms; the output's start enters linearly.
  const std::array<double, 5> by{g.links.crank, g.links.coupler, g.links.rocker, g.links.frame, 1};
  const std::size_t n = free_.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const int a = free_[i], b = free_[j];
      double value = a > kInput || b > kInput ? 0 : by[a] * by[b] * sum.second[a][b];
      if (a == b && a < kInput) value += by[a] * sum.slopes[a];
      out[i * n + j] = value;
    }
  }
  return std::ranges::all_of(out, [](double value) { return std::isfinite(value); });
}

}  // namespace cognate::problems
