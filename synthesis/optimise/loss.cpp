#include "synthesis/optimise/loss.hpp"

#include <chrono>
#include <cmath>

namespace cognate::synthesis {
namespace {

/// √(ρ(s)/s) and its derivative by s.
LossValue share(Loss loss, double s) {
  if (!(s > 0)) return {1, 0};
  const auto [rho, slope] = evaluate(loss, s);
  const double value = std::sqrt(rho / s);
  return {value, (slope - rho / s) / (2 * value * s)};  // s² may overflow
}

/// `rows` of one block times the share; r, s and share those of the block, `width` entries a row.
/// By the product rule k dr + r k′ ds, ds = 2 r·dr/a².
void scale_rows(std::span<const double> r, const LossValue& share, double scale,
                std::span<double> rows) {
  const std::size_t width = rows.size() / r.size();
  for (std::size_t j = 0; j < width; ++j) {
    double along = 0;
    for (std::size_t i = 0; i < r.size(); ++i) along += (r[i] / scale) * rows[i * width + j];
    const double turn = share.slope * 2 * along;
    for (std::size_t i = 0; i < r.size(); ++i) {
      double& entry = rows[i * width + j];
      entry = share.value * entry + (r[i] / scale) * turn;
    }
  }
}

}  // namespace

LossValue evaluate(Loss loss, double s) {
  switch (loss) {
    case Loss::none:
      break;
    case Loss::huber:
      return s <= 1 ? LossValue{s, 1} : LossValue{2 * std::sqrt(s) - 1, 1 / std::sqrt(s)};
    case Loss::soft_l1: {
      const double root = std::sqrt(1 + s);
      return {2 * s / (root + 1), 1 / root};
    }
    case Loss::cauchy:
      return {std::log1p(s), 1 / (1 + s)};
    case Loss::arctan:
      return {std::atan(s), 1 / (1 + s * s)};
    case Loss::tukey:
      return s <= 1 ? LossValue{s * (1 - s * (1 - s / 3)), (1 - s) * (1 - s)}
                    : LossValue{1.0 / 3, 0};
  }
  return {s, 1};
}

Solution solve_by_loss(Solver solver, const Model& model, Loss loss, double scale, int block,
                       std::span<const double> start, const Options& options) {
  if (loss == Loss::none) return solve(solver, model, start, options);
  const RobustModel robust(model, loss, scale, block);
  if (loss != Loss::tukey) return solve(solver, robust, start, options);
  const auto begin = std::chrono::steady_clock::now();
  const Solution way = solve(solver, RobustModel(model, Loss::huber, scale, block), start, options);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  Options left = options;
  left.time_limit -= spent.count();
  Solution solution = solve(solver, robust, way.x, left);
  solution.iterations += way.iterations;
  solution.evaluations += way.evaluations;
  solution.gradients += way.gradients;
  return solution;
}

bool RobustModel::residuals(std::span<const double> x, std::span<double> r,
                            std::span<double> jacobian, std::span<double> local) const {
  if (!model_.residuals(x, r, jacobian, local)) return false;
  const auto block = static_cast<std::size_t>(block_);
  const std::size_t width = jacobian.size() / r.size();
  for (std::size_t first = 0; first < r.size(); first += block) {
    const std::span<double> error = r.subspan(first, block);
    double squares = 0;
    for (const double value : error) squares += (value / scale_) * (value / scale_);
    const LossValue factor = share(loss_, squares);
    if (!jacobian.empty()) {
      scale_rows(error, factor, scale_, jacobian.subspan(first * width, block * width));
    }
    if (!local.empty()) scale_rows(error, factor, scale_, local.subspan(first, block));
    for (double& value : error) value *= factor.value;
  }
  return true;
}

}  // namespace cognate::synthesis
