/// @file Crank positions prepared for batches.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/batch/kernel.hpp"

namespace cognate {

/// Crank angles as the sine and the versine that closures want, to be made once and used for any
/// number of designs and calls. Rows are split at cos θ = 0, where the closure changes its form:
/// a sweep falls into a few runs of rows on one side; rows that jump between the sides are sorted
/// by side, and results still come in the order of the angles.
///
/// Real is double or float; sines and versines are taken of the half angle in double.
template <class Real>
class CrankTable {
 public:
  CrankTable() = default;

  /// `angles` in radians, counted from the directed line A→D plus `origin`: for crank angles from
  /// the x axis, `origin` is frame_angle(linkage).
  explicit CrankTable(std::span<const double> angles, double origin = 0);

  /// `count` equal steps of a full turn, from 0.
  static CrankTable full_turn(std::size_t count);

  /// How many positions there are.
  std::size_t size() const { return order_.size(); }

  /// What the kernels read; the arrays are padded, and order()[i] is the row of their entry i.
  std::span<const Real> sin() const { return sin_; }
  std::span<const Real> versine() const { return versine_; }
  std::span<const std::size_t> order() const { return order_; }
  std::span<const batch::Run> runs() const { return runs_; }
  bool in_order() const { return in_order_; }

 private:
  std::vector<Real> sin_, versine_;
  std::vector<std::size_t> order_;
  std::vector<batch::Run> runs_;
  bool in_order_ = true;
};

extern template class CrankTable<double>;
extern template class CrankTable<float>;

}  // namespace cognate
