/// @file What satisfies two homogeneous equations fewer than there are unknowns, or one.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace cognate::synthesis {

/// An orthonormal basis of the null space of `rows`, Rows × (Rows + Dimension), whose rows are
/// scaled to unit length first; from the QR decomposition of its transpose with pivoting. Empty
/// where the rows are dependent to within rounding: then more satisfies them. Nothing is allocated.
template <int Dimension, int Rows>
std::optional<std::array<Eigen::Matrix<double, Rows + Dimension, 1>, Dimension>> null_basis(
    const Eigen::Matrix<double, Rows, Rows + Dimension>& rows);

extern template std::optional<std::array<Eigen::Matrix<double, 4, 1>, 1>> null_basis<1, 3>(
    const Eigen::Matrix<double, 3, 4>&);
extern template std::optional<std::array<Eigen::Matrix<double, 5, 1>, 2>> null_basis<2, 3>(
    const Eigen::Matrix<double, 3, 5>&);
extern template std::optional<std::array<Eigen::Matrix<double, 6, 1>, 2>> null_basis<2, 4>(
    const Eigen::Matrix<double, 4, 6>&);
extern template std::optional<std::array<Eigen::Matrix<double, 7, 1>, 2>> null_basis<2, 5>(
    const Eigen::Matrix<double, 5, 7>&);

}  // namespace cognate::synthesis
