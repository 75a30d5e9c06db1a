/// @file Limits on the lengths in SIMD lanes. Include in kernels alone.
#pragma once

#include "synthesis/bounds/link_limit.hpp"
#include "synthesis/lanes/lane_numbers.hpp"

namespace cognate::synthesis::COGNATE_ISA {

struct LaneOperations {
  static Real larger(const Real& a, const Real& b) { return COGNATE_ISA::larger(a, b); }
  static Real smaller(const Real& a, const Real& b) { return COGNATE_ISA::smaller(a, b); }
  static Real root(const Real& a) { return COGNATE_ISA::root(a); }
  static Real is_equal(const Real& a, const Real& b) {
    return choose(a == b, Real(1.0), Real(0.0));
  }
};

inline LinkFunction<Real> evaluate(const LinkLimit& limit, const Real* lengths) {
  return synthesis::evaluate(limit, lengths, LaneOperations{});
}

}  // namespace cognate::synthesis::COGNATE_ISA
