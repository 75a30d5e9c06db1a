/// @file How the responses of a mechanism change with its dimensions, to first order.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/tolerance/affine_mechanism.hpp"
#include "analysis/tolerance/response.hpp"

namespace cognate {

/// Values and derivatives at every station. Where the mechanism cannot be assembled they are not
/// numbers; at a dead point derivatives are not finite.
class SensitivityTable {
 public:
  SensitivityTable(std::size_t responses, std::size_t dimensions, std::size_t stations)
      : responses_(responses),
        dimensions_(dimensions),
        values_(responses * stations),
        rates_(responses * stations * dimensions) {}

  /// The response of the nominal mechanism, as ChangedMechanism::value.
  Vec2d& value(std::size_t station, std::size_t response) {
    return values_[station * responses_ + response];
  }
  const Vec2d& value(std::size_t station, std::size_t response) const {
    return values_[station * responses_ + response];
  }

  /// ∂/∂x of each dimension x of its deviation; y is used by points alone.
  std::span<Vec2d> rates(std::size_t station, std::size_t response) {
    return std::span(rates_).subspan((station * responses_ + response) * dimensions_, dimensions_);
  }
  std::span<const Vec2d> rates(std::size_t station, std::size_t response) const {
    return std::span(rates_).subspan((station * responses_ + response) * dimensions_, dimensions_);
  }

 private:
  std::size_t responses_, dimensions_;
  std::vector<Vec2d> values_, rates_;
};

/// By implicit differentiation of the closures: the kernel's own formulas over numbers that carry
/// four derivatives at a time, so that four dimensions cost a motion of such numbers.
SensitivityTable sensitivities(const AffineMechanism& mechanism,
                               std::span<const Response> responses,
                               std::span<const Station> stations);

}  // namespace cognate
