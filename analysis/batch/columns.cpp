#include "analysis/batch/columns.hpp"

namespace cognate::batch {
namespace {

/// The quantities and how many columns each has, in the order of Column.
struct Group {
  Quantity quantity;
  std::size_t columns;
};
constexpr Group kGroups[] = {{position, 2},  {velocity, 2},     {acceleration, 2},
                             {curvature, 1}, {transmission, 2}, {gradient, 2 * kDesignVariables}};

template <class Real>
std::array<std::span<Real>, kColumns> in_order(const FourBarColumns<Real>& given) {
  std::array<std::span<Real>, kColumns> all{
      given.x,
      given.y,
      given.velocity_x,
      given.velocity_y,
      given.acceleration_x,
      given.acceleration_y,
      given.curvature,
      given.transmission_sin,
      given.transmission_cos,
  };
  for (std::size_t i = 0; i < kDesignVariables; ++i) {
    all[column_gradient_x + i] = given.gradient_x[i];
    all[column_gradient_y + i] = given.gradient_y[i];
  }
  return all;
}

}  // namespace

template <class Real>
std::optional<ColumnPointers<Real>> column_pointers(const FourBarColumns<Real>& given,
                                                    std::size_t positions, std::size_t points) {
  const auto all = in_order(given);
  ColumnPointers<Real> result;
  std::size_t column = 0;
  for (const Group& group : kGroups) {
    std::size_t present = 0;
    for (const std::size_t end = column + group.columns; column < end; ++column) {
      if (all[column].empty()) continue;
      if (all[column].size() != positions * (of_points(column) ? points : 1)) return std::nullopt;
      result.columns[column] = all[column].data();
      ++present;
    }
    if (present != 0 && present != group.columns) return std::nullopt;
    if (present != 0) result.wanted |= group.quantity;
  }
  return result;
}

template std::optional<ColumnPointers<double>> column_pointers(const FourBarColumns<double>&,
                                                               std::size_t, std::size_t);
template std::optional<ColumnPointers<float>> column_pointers(const FourBarColumns<float>&,
                                                              std::size_t, std::size_t);

}  // namespace cognate::batch
