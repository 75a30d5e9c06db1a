/// @file Where the transmission angles of a chain come nearest to their limit.
#pragma once

#include <array>
#include <vector>

#include "problems/chain/free_chain.hpp"

namespace cognate::problems {

/// Angles of the crank, from ≤ to.
struct CrankSpan {
  double from, to;
};

/// |cos μ| of the joints of a design along its crank.
class CosineScan {
 public:
  CosineScan(const ChainSpace& space, const synthesis::ChainDesign& design)
      : space_(space),
        design_(design),
        side_(design.side.begin(), design.side.end()),
        is_led_(has_three_pin_link(*space.topology)) {}

  /// Where cosines have extremes near the limit or beyond it, between samples too, and the greatest
  /// violation.
  std::vector<TransmissionCheck> extremes(const CrankSpan& span, double& violation);

 private:
  static constexpr int kSamples = 180;  ///< of a span, between which extremes are refined

  using Samples = std::array<double, kSamples + 1>;

  double cosine(int joint, double crank);
  Samples sampled(int joint, const CrankSpan& span);
  /// Where it is greatest between two samples on either side of `crank`.
  double peak_near(int joint, double crank, double step);
  void scan(int joint, const CrankSpan& span, std::vector<TransmissionCheck>& found,
            double& violation);

  const ChainSpace& space_;
  const synthesis::ChainDesign& design_;
  std::vector<double> side_;
  bool is_led_;  ///< has a three-pin link
  synthesis::ChainPlace<double> place_;
};

}  // namespace cognate::problems
