#include "synthesis/robust/mean_square_model.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::synthesis {
namespace {

/// Takes out of the Jacobian what local variables that follow make good, each in its own rows.
void project(const Model& nominal, PerturbedModel::Sample& at) {
  if (at.local.empty()) return;
  const auto n = static_cast<std::size_t>(nominal.global_count());
  const auto locals = static_cast<std::size_t>(nominal.local_count());
  const auto places = nominal.local_of_residual();
  thread_local std::vector<double> along, square;
  along.assign(locals * n, 0.0);
  square.assign(locals, 0.0);
  for (std::size_t row = 0; row < at.r.size(); ++row) {
    if (places[row] < 0) continue;
    const auto place = static_cast<std::size_t>(places[row]);
    square[place] += at.local[row] * at.local[row];
    for (std::size_t k = 0; k < n; ++k) {
      along[place * n + k] += at.local[row] * at.jacobian[row * n + k];
    }
  }
  for (std::size_t row = 0; row < at.r.size(); ++row) {
    if (places[row] < 0) continue;
    const auto place = static_cast<std::size_t>(places[row]);
    if (!(square[place] > 0)) continue;
    const double share = at.local[row] / square[place];
    for (std::size_t k = 0; k < n; ++k) at.jacobian[row * n + k] -= share * along[place * n + k];
  }
}

}  // namespace

bool MeanSquareModel::residuals(std::span<const double> x, std::span<double> r,
                                std::span<double> jacobian, std::span<double> /*local*/) const {
  const Model& nominal = samples_.nominal();
  const auto n = static_cast<std::size_t>(nominal.global_count());
  const auto rows = static_cast<std::size_t>(nominal.residual_count());
  const double weight = 1 / std::sqrt(static_cast<double>(samples_.count()));
  PerturbedModel::Sample& at = samples_.memory();
  std::ranges::fill(jacobian, 0.0);
  for (std::size_t number = 0; number < samples_.count(); ++number) {
    if (!samples_.evaluate(x, number, !jacobian.empty(), at)) return false;
    const std::size_t first = number * rows;
    for (std::size_t row = 0; row < rows; ++row) r[first + row] = weight * at.r[row];
    if (jacobian.empty()) continue;
    project(nominal, at);
    for (std::size_t row = 0; row < rows; ++row) {
      double* into = jacobian.data() + (first + row) * x.size();
      for (std::size_t k = 0; k < n; ++k) {
        into[k] = weight * at.jacobian[row * n + k] * at.slope[k];
      }
    }
  }
  return true;
}

}  // namespace cognate::synthesis
