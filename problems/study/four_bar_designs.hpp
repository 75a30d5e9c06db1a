/// @file The four-bars of a study side by side.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/batch/quantities.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "problems/study/study.hpp"

namespace cognate::problems {

/// The dimension that a varied key is, if it is one of a four-bar that has a coupler point or not.
std::optional<DesignVariable> four_bar_dimension(const KeyPath& path);

/// The dimensions of some designs, an array for each in the order of `DesignVariable`, and the
/// frames' lengths.
class FourBarDesigns {
 public:
  /// The designs of `base` with the values of `dimensions`, design by design in `values`.
  void fill(const FourBar& base, std::span<const DesignVariable> dimensions,
            std::span<const double> values);

  std::size_t size() const { return frame_.size(); }
  std::span<const double> of(DesignVariable dimension) const {
    return columns_[static_cast<std::size_t>(dimension)];
  }
  std::span<const double> frame() const { return frame_; }

  /// Design i; what does not vary is that of `base`.
  FourBar design(const FourBar& base, std::size_t i) const;

 private:
  std::array<std::vector<double>, kDesignVariables> columns_;
  std::vector<double> frame_;
};

}  // namespace cognate::problems
