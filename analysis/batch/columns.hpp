/// @file The columns of a batch as the kernels take them.
#pragma once

#include <array>
#include <optional>

#include "analysis/batch/four_bar_batch.hpp"

namespace cognate::batch {

/// Where each column goes, null if it is not requested, and the set of requested quantities.
template <class Real>
struct ColumnPointers {
  std::array<Real*, kColumns> columns{};
  unsigned wanted = 0;
};

/// Whether a column has a value for each coupler point.
constexpr bool of_points(std::size_t column) {
  return column != column_transmission_sin && column != column_transmission_cos;
}

/// Empty where a column has neither no value nor `positions` (times `points`, but for the
/// transmission angle), or where only some columns of a quantity are given.
template <class Real>
std::optional<ColumnPointers<Real>> column_pointers(const FourBarColumns<Real>& given,
                                                    std::size_t positions, std::size_t points);

}  // namespace cognate::batch
