/// @file Exact rational numbers of any length.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace cognate::train {

/// Reduced, with a positive denominator.
using Fraction = boost::multiprecision::cpp_rational;

inline bool is_whole(const Fraction& fraction) {
  return denominator(fraction) == 1;
}

/// The greatest fraction of which both are whole multiples; the other one where one is 0.
inline Fraction common_measure(const Fraction& a, const Fraction& b) {
  // Of p/q and r/s it is gcd(p s, r q)/(q s).
  return {gcd(numerator(a) * denominator(b), numerator(b) * denominator(a)),
          denominator(a) * denominator(b)};
}

}  // namespace cognate::train
