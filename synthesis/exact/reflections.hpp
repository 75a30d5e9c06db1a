/// @file What the reflections of a QR decomposition with few columns do, one after the other.
/// Eigen's own ways of asking for it bring along that by blocks of 48 reflections, which takes the
/// compiler seconds for every size.
#pragma once

#include <Eigen/QR>

namespace cognate::synthesis {

/// Reflects `x`, the rows from `k` on, by reflection `k` of `qr`.
template <class Matrix, class Rows>
void reflect(const Eigen::ColPivHouseholderQR<Matrix>& qr, Eigen::Index k, Rows x) {
  const Eigen::Block<const Matrix, Eigen::Dynamic, 1> normal(qr.matrixQR(), k + 1, k, x.rows() - 1,
                                                             1);
  Eigen::Matrix<double, Matrix::MaxRowsAtCompileTime, 1> products;
  x.applyHouseholderOnTheLeft(normal, qr.hCoeffs()[k], products.data());
}

/// `x` becomes Q x.
template <class Matrix, class Vector>
void apply_q(const Eigen::ColPivHouseholderQR<Matrix>& qr, Vector& x) {
  for (Eigen::Index k = qr.hCoeffs().size(); k-- > 0;) {
    reflect(qr, k, x.bottomRightCorner(qr.rows() - k, 1));
  }
}

/// Q.
template <class Matrix>
auto factor_q(const Eigen::ColPivHouseholderQR<Matrix>& qr) {
  constexpr int kRows = Matrix::RowsAtCompileTime, kMost = Matrix::MaxRowsAtCompileTime;
  using Square = Eigen::Matrix<double, kRows, kRows, 0, kMost, kMost>;
  Square q = Square::Identity(qr.rows(), qr.rows());
  for (Eigen::Index k = qr.hCoeffs().size(); k-- > 0;) {
    reflect(qr, k, q.bottomRightCorner(qr.rows() - k, qr.rows() - k));
  }
  return q;
}

/// `qr.solve(right)`.
template <class Matrix>
auto solved(
    const Eigen::ColPivHouseholderQR<Matrix>& qr,
    Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1, 0, Matrix::MaxRowsAtCompileTime, 1> right) {
  using Solution =
      Eigen::Matrix<double, Matrix::ColsAtCompileTime, 1, 0, Matrix::MaxColsAtCompileTime, 1>;
  Solution x = Solution::Zero(qr.cols());
  const Eigen::Index rank = qr.nonzeroPivots();
  if (rank == 0) return x;
  for (Eigen::Index k = 0; k < rank; ++k) {
    reflect(qr, k, right.bottomRightCorner(qr.rows() - k, 1));
  }
  auto top = right.topRows(rank);
  qr.matrixQR().topLeftCorner(rank, rank).template triangularView<Eigen::Upper>().solveInPlace(top);
  for (Eigen::Index i = 0; i < rank; ++i) x[qr.colsPermutation().indices()[i]] = top[i];
  return x;
}

}  // namespace cognate::synthesis
