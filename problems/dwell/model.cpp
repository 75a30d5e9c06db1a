#include "problems/dwell/model.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
DwellModel::DwellModel(const DwellSpace& space, const DwellDesign& design, DwellChecks checks,
                       int nodes, double unit)
    : space_(space),
      design_(design),
      side_(design.chain.side.begin(), design.chain.side.end()),
      checks_(std::move(checks)),
      unit_(unit) {
  for (int i = 0; i < nodes; ++i) nodes_.push_back(0.5 - 0.5 * std::cos(kPi * i / (nodes - 1)));
  for (const int parameter : space.free) {
    const auto i = static_cast<std::size_t>(parameter);
    variables_.push_back({fmt::format("parameter {}", parameter), space.lower[i], space.upper[i],
                          std::max(0.1, std::abs(design.chain.parameters[i]))});
  }
  FreeChain chain(space, design.chain.parameters, side_);
  for (std::size_t k = 0; k < dwells(); ++k) {
    const auto& from = space.problem->dwells[k].from;
    const double low = from.value_or(design.start[k] - kTurn),
                 high = from.value_or(design.start[k] + kTurn);
    variables_.push_back({fmt::format("start {}", k + 1), low, high, 1});
  }
  for (std::size_t k = 0; k < dwells(); ++k) {
    double least = 0, greatest = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double crank = design.start[k] + space.problem->dwells[k].over * nodes_[i];
      chain.at(crank);
      if (k == 0 && i == 0) reference_ = space.output(chain);
      const double output = space.error(chain, reference_);
      least = i == 0 ? output : std::min(least, output);
      greatest = i == 0 ? output : std::max(greatest, output);
    }
    levels_.push_back(0.5 * (least + greatest));
    const double most = space.most_level();
    variables_.push_back({fmt::format("level {}", k + 1), -most, most, 1});
  }
}

int DwellModel::constraint_count() const {
  return 2 * static_cast<int>(checks_.transmission.size()) + has_swing() + has_apart();
}

std::vector<double> DwellModel::start() const {
  std::vector<double> x;
  for (const int parameter : space_.free) {
    const auto i = static_cast<std::size_t>(parameter);
    x.push_back(std::clamp(design_.chain.parameters[i], space_.lower[i], space_.upper[i]));
  }
  x.insert(x.end(), design_.start.begin(), design_.start.end());
  x.insert(x.end(), levels_.begin(), levels_.end());
  return x;
}

synthesis::ChainDesign DwellModel::chain(std::span<const double> x) const {
  synthesis::ChainDesign found = design_.chain;
  for (std::size_t i = 0; i < space_.free.size(); ++i) {
    found.parameters[static_cast<std::size_t>(space_.free[i])] = x[i];
  }
  return found;
}

DwellDesign DwellModel::design(std::span<const double> x) const {
  const auto starts = x.subspan(first_start(), dwells());
  return {chain(x), {starts.begin(), starts.end()}};
}

bool DwellModel::residuals(std::span<const double> x, std::span<double> r,
                           std::span<double> jacobian, std::span<double> /*local*/) const {
  const synthesis::ChainDesign here = chain(x);
  FreeChain chain(space_, here.parameters, side_);
  const std::size_t columns = x.size(), count = nodes_.size();
  for (std::size_t k = 0; k < dwells(); ++k) {
    for (std::size_t i = 0; i < count; ++i) {
      const double crank = x[first_start() + k] + space_.problem->dwells[k].over * nodes_[i];
      chain.at(crank);
      const double output = space_.error(chain, reference_);
      if (!std::isfinite(output)) return false;
      r[k * count + i] = (output - x[first_level() + k]) / unit_;
      if (jacobian.empty()) continue;
      double* row = jacobian.data() + (k * count + i) * columns;
      std::fill_n(row, columns, 0.0);
      row[first_start() + k] = space_.output_slope(chain, row);
      row[first_level() + k] = -1;
      for (std::size_t c = 0; c < columns; ++c) row[c] /= unit_;
    }
  }
  return true;
}

void DwellModel::constraints(std::span<const double> x, std::span<double> c,
                             std::span<double> jacobian) const {
  const synthesis::ChainDesign here = chain(x);
  FreeChain chain(space_, here.parameters, side_);
  const std::size_t columns = x.size();
  // Starts and levels stand after the free parameters: their entries are cleared as such.
  transmission_constraints(chain, space_.cosine_limit, checks_.transmission, columns, c, jacobian);
  std::size_t next = 2 * checks_.transmission.size();
  if (has_swing()) {
    std::vector<double> low(columns, 0.0);
    chain.at(checks_.lowest);
    const double below = space_.error(chain, reference_);
    space_.output_slope(chain, low.data());
    chain.at(checks_.highest);
    const double swing = space_.error(chain, reference_) - below;
    c[next] = std::isfinite(swing) ? swing - space_.swing_min : -1;
    if (!jacobian.empty()) {
      double* row = jacobian.data() + next * columns;
      std::fill_n(row, columns, 0.0);
      if (std::isfinite(swing)) {
        space_.output_slope(chain, row);
        for (std::size_t i = 0; i < space_.free.size(); ++i) row[i] -= low[i];
      }
    }
    ++next;
  }
  if (!has_apart()) return;
  const double sense = levels_[1] >= levels_[0] ? 1 : -1;
  c[next] = sense * (x[first_level() + 1] - x[first_level()]) - checks_.apart;
  if (jacobian.empty()) return;
  double* row = jacobian.data() + next * columns;
  std::fill_n(row, columns, 0.0);
  row[first_level() + 1] = sense;
  row[first_level()] = -sense;
}

}  // namespace cognate::problems
