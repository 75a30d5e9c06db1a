/// @file Exact rational numbers, whose numerator and denominator have at most 38 digits.
#pragma once

#include <cstdint>
#include <string>

namespace cognate::train {

__extension__ typedef __int128 WideInteger;

/// A reduced fraction with a positive denominator. What leaves the range of 128 bits, and a
/// quotient by zero, is no number: it stays so in every operation, and `is_number` says it.
class Fraction {
 public:
  Fraction(std::int64_t whole = 0) : numerator_(whole) {}  // NOLINT(google-explicit-constructor)
  Fraction(std::int64_t numerator, std::int64_t denominator);

  bool is_number() const { return denominator_ != 0; }
  bool is_zero() const { return is_number() && numerator_ == 0; }
  bool is_whole() const { return denominator_ == 1; }
  int sign() const { return numerator_ > 0 ? 1 : numerator_ < 0 ? -1 : 0; }
  double value() const;
  /// "-72/35", "4"; empty of what is no number.
  std::string text() const;

  Fraction operator-() const;
  friend Fraction operator+(const Fraction& a, const Fraction& b);
  friend Fraction operator-(const Fraction& a, const Fraction& b) { return a + -b; }
  friend Fraction operator*(const Fraction& a, const Fraction& b);
  friend Fraction operator/(const Fraction& a, const Fraction& b) { return a * b.inverse(); }
  friend bool operator==(const Fraction& a, const Fraction& b) = default;

  Fraction inverse() const;

  /// The greatest fraction of which both are whole multiples; the other one where one is 0.
  friend Fraction common_measure(const Fraction& a, const Fraction& b);

 private:
  static Fraction reduced(WideInteger numerator, WideInteger denominator);
  static Fraction not_a_number();

  WideInteger numerator_ = 0, denominator_ = 1;
};

Fraction common_measure(const Fraction& a, const Fraction& b);

}  // namespace cognate::train
