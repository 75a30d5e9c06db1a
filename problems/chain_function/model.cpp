#include "problems/chain_function/model.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
std::optional<double> output_level(const ChainFunctionSpace& space,
                                   const ChainFunctionDesign& design,
                                   std::span<const synthesis::AnglePair> pairs) {
  const std::vector<double> side(design.chain.side.begin(), design.chain.side.end());
  FreeChain chain(space, design.chain.parameters, side);
  std::optional<double> first;
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (const auto& [input, output] : pairs) {
    chain.at(design.start + input);
    if (!first) first = space.error(chain, space.wanted(output));
    const double error = space.error(chain, space.wanted(output + *first));
    if (!std::isfinite(error)) return std::nullopt;
    least = std::min(least, error);
    greatest = std::max(greatest, error);
  }
  return *first + 0.5 * (least + greatest);
}

ChainFunctionModel::ChainFunctionModel(const ChainFunctionSpace& space,
                                       const ChainFunctionDesign& design,
                                       std::vector<TransmissionCheck> checks,
                                       std::span<const synthesis::AnglePair> pairs,
                                       synthesis::Objective objective)
    : space_(space),
      design_{within_bounds(space, design.chain), design.start},
      side_(design.chain.side.begin(), design.chain.side.end()),
      checks_(std::move(checks)),
      pairs_(pairs),
      objective_(objective) {
  for (const int parameter : space.free) {
    const auto i = static_cast<std::size_t>(parameter);
    variables_.push_back({fmt::format("parameter {}", parameter), space.lower[i], space.upper[i],
                          std::max(0.1, std::abs(design_.chain.parameters[i]))});
  }
  variables_.push_back({"start", design.start - kTurn, design.start + kTurn, 1});
  variables_.push_back({"output's start", -space.most_level(), space.most_level(), 1});
  const auto level = output_level(space, design_, pairs);
  closes_ = level.has_value();
  for (const auto& pair : pairs) {
    turned_.push_back(unit_vector(pair.input));
    wanted_.push_back(space.wanted(pair.output + level.value_or(0)));
  }
}

std::vector<double> ChainFunctionModel::start() const {
  std::vector<double> x;
  for (const int parameter : space_.free) {
    const auto i = static_cast<std::size_t>(parameter);
    x.push_back(design_.chain.parameters[i]);
  }
  x.push_back(design_.start);
  x.push_back(0);
  return x;
}

ChainFunctionModel::Parameters ChainFunctionModel::parameters(std::span<const double> x) const {
  Parameters all;
  std::ranges::copy(design_.chain.parameters, all.begin());
  for (std::size_t i = 0; i < space_.free.size(); ++i) {
    all[static_cast<std::size_t>(space_.free[i])] = x[i];
  }
  return all;
}

ChainFunctionDesign ChainFunctionModel::design(std::span<const double> x) const {
  const Parameters all = parameters(x);
  const auto count = static_cast<std::ptrdiff_t>(design_.chain.parameters.size());
  return {{{all.begin(), all.begin() + count}, design_.chain.side}, x[start_column()]};
}

bool ChainFunctionModel::residuals(std::span<const double> x, std::span<double> r,
                                   std::span<double> jacobian, std::span<double> /*local*/) const {
  if (!closes_) return false;
  const Parameters here = parameters(x);
  FreeChain chain(space_, here, side_);
  const Vec2d begun = unit_vector(x[start_column()]);
  const std::size_t columns = x.size();
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    chain.at(begun * turned_[i]);
    const double error = space_.error(chain, wanted_[i]);
    if (!std::isfinite(error)) return false;
    r[i] = error - x[level_column()];
    if (jacobian.empty()) continue;
    double* row = jacobian.data() + i * columns;
    std::fill_n(row, columns, 0.0);
    row[start_column()] = space_.output_slope(chain, row);
    row[level_column()] = -1;
  }
  return true;
}

void ChainFunctionModel::constraints(std::span<const double> x, std::span<double> c,
                                     std::span<double> jacobian) const {
  const Parameters here = parameters(x);
  FreeChain chain(space_, here, side_);
  transmission_constraints(chain, space_.cosine_limit, checks_, x.size(), c, jacobian,
                           CheckTurn{start_column(), x[start_column()] - design_.start});
}

}  // namespace cognate::problems
