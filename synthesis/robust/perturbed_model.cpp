#include "synthesis/robust/perturbed_model.hpp"

#include <algorithm>
#include <numeric>

namespace cognate::synthesis {
namespace {

/// So often a step is halved, and not taken then.
constexpr int kHalvings = 4;
/// Parts of a change, the first and the least.
constexpr double kFirstPart = 0.25, kLeastPart = 1.0 / 64;

}  // namespace

PerturbedModel::Sample& PerturbedModel::memory() const {
  thread_local Sample memory;
  const auto variables = nominal_.variables().size();
  const auto rows = static_cast<std::size_t>(nominal_.residual_count());
  const auto locals = static_cast<std::size_t>(nominal_.local_count());
  memory.moved.resize(variables);
  memory.slope.resize(variables);
  memory.r.resize(rows);
  memory.jacobian.resize(rows * (variables - locals));
  memory.local.resize(locals > 0 ? rows : 0);
  return memory;
}

/// One Newton step of each local variable.
void PerturbedModel::follow(Sample& at) const {
  const auto places = nominal_.local_of_residual();
  const auto globals = static_cast<std::size_t>(nominal_.global_count());
  thread_local std::vector<double> along, square;
  along.assign(at.moved.size() - globals, 0.0);
  square.assign(along.size(), 0.0);
  for (std::size_t row = 0; row < at.r.size(); ++row) {
    if (places[row] < 0) continue;
    const auto place = static_cast<std::size_t>(places[row]);
    along[place] += at.local[row] * at.r[row];
    square[place] += at.local[row] * at.local[row];
  }
  for (std::size_t k = 0; k < along.size(); ++k) {
    if (square[k] > 0) at.moved[globals + k] -= along[k] / square[k];
  }
}

/// Residuals where the local variables have followed from where they stand; a step to where the
/// model has no value is halved. False where it has none to begin with.
bool PerturbedModel::settle(bool differentiate, Sample& at) const {
  const int steps = at.local.empty() ? 0 : follow_;
  const auto locals =
      std::span(at.moved).subspan(static_cast<std::size_t>(nominal_.global_count()));
  thread_local std::vector<double> before;
  before.assign(locals.begin(), locals.end());
  for (int step = 0; step <= steps; ++step) {
    const bool slopes = step < steps || differentiate;
    const auto has_value = [&] {
      return slopes ? nominal_.residuals(at.moved, at.r, at.jacobian, at.local)
                    : nominal_.residuals(at.moved, at.r, {}, {});
    };
    for (int halved = 0; !has_value(); ++halved) {
      if (step == 0 || halved > kHalvings) return false;
      for (std::size_t k = 0; k < locals.size(); ++k) {
        locals[k] = halved < kHalvings ? 0.5 * (locals[k] + before[k]) : before[k];
      }
    }
    if (step == steps) break;
    before.assign(locals.begin(), locals.end());
    follow(at);
  }
  return true;
}

/// As `settle`, by parts of the change one after the other: what does not close where the design
/// stands may close where its local variables go meanwhile.
bool PerturbedModel::approach(std::span<const double> x, bool differentiate, Sample& at) const {
  if (at.local.empty() || follow_ == 0) return false;
  const auto globals = static_cast<std::size_t>(nominal_.global_count());
  thread_local std::vector<double> changed, reached;
  changed.assign(at.moved.begin(), at.moved.begin() + static_cast<std::ptrdiff_t>(globals));
  reached.assign(x.begin(), x.end());
  for (double done = 0, step = kFirstPart; done < 1;) {
    const double next = std::min(1.0, done + step);
    std::ranges::copy(reached, at.moved.begin());
    for (std::size_t k = 0; k < globals; ++k) at.moved[k] += next * (changed[k] - x[k]);
    if (settle(differentiate && next == 1, at)) {
      std::copy(at.moved.begin() + static_cast<std::ptrdiff_t>(globals), at.moved.end(),
                reached.begin() + static_cast<std::ptrdiff_t>(globals));
      done = next;
      continue;
    }
    step /= 2;
    if (step < kLeastPart) return false;
  }
  return true;
}

bool PerturbedModel::evaluate(std::span<const double> x, std::size_t number, bool differentiate,
                              Sample& at) const {
  perturbation_.move(x, number, at.moved, at.slope);
  return settle(differentiate, at) || approach(x, differentiate, at);
}

void PerturbedModel::nominal_constraints(std::span<const double> x, std::span<double> c,
                                         std::span<double> jacobian) const {
  const auto n = static_cast<std::size_t>(nominal_.global_count());
  const auto rows = static_cast<std::size_t>(nominal_.constraint_count());
  if (rows == 0) return;
  if (jacobian.empty()) return nominal_.constraints(x, c, {});
  std::vector<double> narrow(rows * n);
  nominal_.constraints(x, c, narrow);
  std::ranges::fill(jacobian, 0.0);
  for (std::size_t row = 0; row < rows; ++row) {
    std::copy_n(narrow.begin() + static_cast<std::ptrdiff_t>(row * n), n,
                jacobian.begin() + static_cast<std::ptrdiff_t>(row * x.size()));
  }
}

/// 1 − ‖r‖²/limit ≥ 0 for the design itself.
void PerturbedModel::limit_sum(std::span<const double> x, double limit, double& c,
                               std::span<double> row) const {
  const auto n = static_cast<std::size_t>(nominal_.global_count());
  const auto rows = static_cast<std::size_t>(nominal_.residual_count());
  std::vector<double> r(rows), jacobian(row.empty() ? 0 : rows * n);
  std::vector<double> local(row.empty() || nominal_.local_count() == 0 ? 0 : rows);
  std::ranges::fill(row, 0.0);
  c = -1;
  if (!nominal_.residuals(x, r, jacobian, local)) return;
  c = 1 - std::inner_product(r.begin(), r.end(), r.begin(), 0.0) / limit;
  if (row.empty()) return;
  for (std::size_t i = 0; i < rows; ++i) {
    const double along = -2 * r[i] / limit;
    for (std::size_t k = 0; k < n; ++k) row[k] += along * jacobian[i * n + k];
    if (local.empty()) continue;
    const int place = nominal_.local_of_residual()[i];
    if (place >= 0) row[n + static_cast<std::size_t>(place)] += along * local[i];
  }
}

void PerturbedModel::constraints(std::span<const double> x, const std::optional<double>& most,
                                 std::span<double> c, std::span<double> jacobian) const {
  const auto rows = static_cast<std::size_t>(nominal_.constraint_count());
  const std::size_t columns = x.size();
  nominal_constraints(x, c.first(rows),
                      jacobian.empty() ? jacobian : jacobian.first(rows * columns));
  if (!most) return;
  limit_sum(x, *most, c[rows],
            jacobian.empty() ? jacobian : jacobian.subspan(rows * columns, columns));
}

}  // namespace cognate::synthesis
