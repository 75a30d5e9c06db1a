#include "synthesis/exact/null_plane.hpp"

#include <cmath>
#include <limits>

#include "synthesis/exact/reflections.hpp"

namespace cognate::synthesis {

template <int Dimension, int Rows>
std::optional<std::array<Eigen::Matrix<double, Rows + Dimension, 1>, Dimension>> null_basis(
    const Eigen::Matrix<double, Rows, Rows + Dimension>& rows) {
  constexpr int kColumns = Rows + Dimension;
  constexpr double kDependent = 4 * kColumns * std::numeric_limits<double>::epsilon();
  const Eigen::Matrix<double, kColumns, Rows> across = rows.rowwise().normalized().transpose();
  if (!across.allFinite()) return std::nullopt;
  const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, kColumns, Rows>> qr(across);
  const auto& r = qr.matrixQR();
  if (!(std::abs(r(Rows - 1, Rows - 1)) > kDependent * std::abs(r(0, 0)))) return std::nullopt;
  std::array<Eigen::Matrix<double, kColumns, 1>, Dimension> basis;
  for (int i = 0; i < Dimension; ++i) {
    basis[i] = Eigen::Matrix<double, kColumns, 1>::Unit(Rows + i);
    apply_q(qr, basis[i]);
  }
  return basis;
}

template std::optional<std::array<Eigen::Matrix<double, 4, 1>, 1>> null_basis<1, 3>(
    const Eigen::Matrix<double, 3, 4>&);
template std::optional<std::array<Eigen::Matrix<double, 5, 1>, 2>> null_basis<2, 3>(
    const Eigen::Matrix<double, 3, 5>&);
template std::optional<std::array<Eigen::Matrix<double, 6, 1>, 2>> null_basis<2, 4>(
    const Eigen::Matrix<double, 4, 6>&);
template std::optional<std::array<Eigen::Matrix<double, 7, 1>, 2>> null_basis<2, 5>(
    const Eigen::Matrix<double, 5, 7>&);

}  // namespace cognate::synthesis
