#include "synthesis/robust/quantile_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "analysis/numbers/parallel.hpp"

namespace cognate::synthesis {
namespace {

/// The ranks that count reach so far towards the last of all, of what lies beyond the share.
constexpr double kReach = 0.9;
/// So many ranks count at least, on either side.
constexpr double kFewestRanks = 2;

std::vector<double> rank_weights(std::size_t count, double share) {
  const double middle = share * static_cast<double>(count);
  const double half =
      std::max(kFewestRanks, kReach * std::min(share, 1 - share) * static_cast<double>(count));
  std::vector<double> weights(count);
  for (std::size_t rank = 0; rank < count; ++rank) {
    const double away = (static_cast<double>(rank) + 0.5 - middle) / half;
    weights[rank] = std::max(0.0, 1 - away * away);
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace

/// The greatest error of one sample, and the station where it is.
struct QuantileModel::Made {
  double error = std::numeric_limits<double>::infinity();
  std::size_t station = 0;
  std::size_t number = 0;
};

QuantileModel::QuantileModel(const Model& nominal, const Perturbation& perturbation,
                             QuantileOptions options)
    : nominal_(nominal),
      samples_(nominal, perturbation, options.follow),
      options_(std::move(options)),
      weight_(rank_weights(perturbation.count(), options_.share)) {
  const auto stations = static_cast<std::size_t>(nominal.residual_count() / options_.components);
  options_.scale.resize(stations, 1);
}

QuantileModel::Made QuantileModel::made(std::span<const double> x, std::size_t number) const {
  PerturbedModel::Sample& at = samples_.memory();
  Made made;
  made.number = number;
  if (!samples_.evaluate(x, number, false, at)) return made;
  made.error = 0;
  const auto components = static_cast<std::size_t>(options_.components);
  for (std::size_t station = 0; station < options_.scale.size(); ++station) {
    double square = 0;
    for (std::size_t i = 0; i < components; ++i) {
      square += at.r[station * components + i] * at.r[station * components + i];
    }
    const double error = options_.scale[station] * std::sqrt(square);
    if (error <= made.error) continue;
    made.error = error;
    made.station = station;
  }
  return made;
}

/// By their errors; equal ones by their numbers, so that the order is always the same.
std::vector<QuantileModel::Made> QuantileModel::sorted(std::span<const double> x) const {
  std::vector<Made> all;
  all.reserve(samples_.count());
  for (std::size_t k = 0; k < samples_.count(); ++k) all.push_back(made(x, k));
  std::ranges::sort(all, [](const Made& a, const Made& b) {
    return a.error != b.error ? a.error < b.error : a.number < b.number;
  });
  return all;
}

std::vector<double> QuantileModel::errors(std::span<const double> x, int threads) const {
  constexpr std::size_t kBlock = 4096;
  std::vector<double> all(samples_.count());
  const std::size_t blocks = (all.size() + kBlock - 1) / kBlock;
  parallel_for(static_cast<int>(blocks), threads, [&](int block, int) {
    const std::size_t first = static_cast<std::size_t>(block) * kBlock;
    const std::size_t last = std::min(all.size(), first + kBlock);
    for (std::size_t k = first; k < last; ++k) all[k] = made(x, k).error;
  });
  std::ranges::sort(all);
  return all;
}

/// By the theorem of the envelope local variables that follow take no part.
bool QuantileModel::add_gradient(std::span<const double> x, const Made& of, double weight,
                                 std::span<double> gradient) const {
  PerturbedModel::Sample& at = samples_.memory();
  if (!samples_.evaluate(x, of.number, true, at)) return false;
  if (!(of.error > 0)) return true;  // at its least, where the distance has no slope
  const auto n = static_cast<std::size_t>(nominal_.global_count());
  const auto components = static_cast<std::size_t>(options_.components);
  const double scale = options_.scale[of.station];
  for (std::size_t i = 0; i < components; ++i) {
    const std::size_t row = of.station * components + i;
    const double along = weight * scale * scale * at.r[row] / of.error;
    for (std::size_t k = 0; k < n; ++k) {
      gradient[k] += along * at.jacobian[row * n + k] * at.slope[k];
    }
  }
  return true;
}

bool QuantileModel::residuals(std::span<const double> x, std::span<double> r,
                              std::span<double> jacobian, std::span<double> /*local*/) const {
  const auto all = sorted(x);
  double sum = 0;
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    if (weight_[rank] > 0) sum += weight_[rank] * all[rank].error;
  }
  if (!std::isfinite(sum)) return false;
  r[0] = sum;
  if (jacobian.empty()) return true;
  std::ranges::fill(jacobian, 0.0);
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    const double weight = weight_[rank];
    if (weight > 0 && !add_gradient(x, all[rank], weight, jacobian)) return false;
  }
  return true;
}

}  // namespace cognate::synthesis
