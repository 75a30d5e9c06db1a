/// @file Limits on the lengths in SIMD lanes, as penalties of a sum of squares. Include in kernels
/// alone.
#pragma once

#include "synthesis/search/lane_fit.hpp"
#include "synthesis/search/link_limit.hpp"

namespace cognate::synthesis::COGNATE_ISA {

/// `limit` at `lengths` (crank, coupler, rocker, frame), and its derivatives by them.
inline Real evaluate(const LinkLimit& limit, const Real* lengths, Real* slope) {
  const Real &l1 = lengths[0], &l2 = lengths[1], &l3 = lengths[2], &l4 = lengths[3];
  switch (limit.kind) {
    case LinkLimit::Kind::linear: {
      Real sum(-limit.margin);
      for (int k = 0; k < 4; ++k) {
        slope[k] = Real(limit.weights[k]);
        sum = sum + slope[k] * lengths[k];
      }
      return sum;
    }
    case LinkLimit::Kind::grashof_excess: {
      const Real longest = larger(larger(l1, l2), larger(l3, l4));
      const Real shortest = smaller(smaller(l1, l2), smaller(l3, l4));
      const Real zero(0.0), two(2.0), weight(limit.weights[0]);
      Real sum(0.0);
      for (int k = 0; k < 4; ++k) {
        slope[k] = weight * (choose(lengths[k] == longest, two, zero) +
                             choose(lengths[k] == shortest, two, zero) - Real(1.0));
        sum = sum + slope[k] * lengths[k];
      }
      return sum;
    }
    default:
      break;
  }
  const Real sense(limit.kind == LinkLimit::Kind::transmission_max ? 1.0 : -1.0);
  const Real diagonal = l4 + sense * l1;
  const Real inverse = Real(1.0) / (l2 * l3);
  const Real cosine = Real(0.5) * inverse * (l2 * l2 + l3 * l3 - diagonal * diagonal);
  const Real by_frame = -(sense * diagonal * inverse);
  slope[0] = sense * by_frame;
  slope[1] = sense * inverse * (l2 - cosine * l3);
  slope[2] = sense * inverse * (l3 - cosine * l2);
  slope[3] = by_frame;
  return sense * (cosine - Real(limit.limit_cosine));
}

}  // namespace cognate::synthesis::COGNATE_ISA
