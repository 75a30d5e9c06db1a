/// @file Products with the orthogonal factor Q of a small QR factorisation, reflection by
/// reflection. Eigen's own give the same numbers, but bring the product by blocks along, which no
/// matrix of a few rows uses and which takes the compiler seconds for each size.
#pragma once

#include <Eigen/QR>
#include <array>

namespace cognate::synthesis {

/// The most columns that a reflection is applied to.
inline constexpr int kMostReflected = 8;

/// Applies reflection `k` to the last `columns` columns of `to`.
template <class Matrix, class Columns>
void reflect(const Eigen::ColPivHouseholderQR<Matrix>& qr, Eigen::Index k, Columns& to,
             Eigen::Index columns) {
  std::array<double, kMostReflected> workspace;
  const Eigen::Index rows = qr.rows() - k;
  const Eigen::Block<const Matrix, Eigen::Dynamic, 1> essential(qr.matrixQR(), k + 1, k, rows - 1,
                                                                1);
  to.bottomRightCorner(rows, columns)
      .applyHouseholderOnTheLeft(essential, qr.hCoeffs().coeff(k), workspace.data());
}

/// Column `i` of Q.
template <class Matrix>
Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1> column_of_q(
    const Eigen::ColPivHouseholderQR<Matrix>& qr, Eigen::Index i) {
  Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1> column =
      Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1>::Unit(qr.rows(), i);
  for (Eigen::Index k = qr.cols() - 1; k >= 0; --k) reflect(qr, k, column, 1);
  return column;
}

/// Q, all of it.
template <class Matrix>
auto whole_q(const Eigen::ColPivHouseholderQR<Matrix>& qr) {
  using Square = Eigen::Matrix<double, Matrix::RowsAtCompileTime, Matrix::RowsAtCompileTime>;
  Square q = Square::Identity(qr.rows(), qr.rows());
  for (Eigen::Index k = qr.cols() - 1; k >= 0; --k) reflect(qr, k, q, qr.rows() - k);
  return q;
}

/// x of least |A·x − right| for the factorised A.
template <class Matrix, class Right>
auto least_squares(const Eigen::ColPivHouseholderQR<Matrix>& qr, Right right) {
  const Eigen::Index rank = qr.nonzeroPivots();
  for (Eigen::Index k = 0; k < rank; ++k) reflect(qr, k, right, 1);
  qr.matrixQR()
      .topLeftCorner(rank, rank)
      .template triangularView<Eigen::Upper>()
      .solveInPlace(right.topRows(rank));
  Eigen::Matrix<double, Matrix::ColsAtCompileTime, 1, 0, Matrix::MaxColsAtCompileTime, 1> x =
      Eigen::Matrix<double, Matrix::ColsAtCompileTime, 1, 0, Matrix::MaxColsAtCompileTime, 1>::Zero(
          qr.cols());
  for (Eigen::Index i = 0; i < rank; ++i) x[qr.colsPermutation().indices()[i]] = right[i];
  return x;
}

}  // namespace cognate::synthesis
