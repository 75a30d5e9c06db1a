#include "analysis/train/fraction.hpp"

#include <algorithm>

namespace cognate::train {
namespace {

WideInteger magnitude(WideInteger x) {
  return x < 0 ? -x : x;
}

WideInteger common_divisor(WideInteger a, WideInteger b) {
  a = magnitude(a);
  b = magnitude(b);
  while (b != 0) {
    const WideInteger rest = a % b;
    a = b;
    b = rest;
  }
  return a;
}

/// So far from the ends that a sign or an absolute value cannot leave the range.
bool is_in_range(WideInteger x) {
  constexpr WideInteger kGreatest = static_cast<WideInteger>(1) << 126;
  return x < kGreatest && x > -kGreatest;
}

std::string digits_of(WideInteger x) {
  std::string text;
  for (WideInteger rest = magnitude(x); rest != 0 || text.empty(); rest /= 10) {
    text += static_cast<char>('0' + static_cast<int>(rest % 10));
  }
  if (x < 0) text += '-';
  std::ranges::reverse(text);
  return text;
}

}  // namespace

Fraction Fraction::not_a_number() {
  Fraction none;
  none.denominator_ = 0;
  return none;
}

Fraction Fraction::reduced(WideInteger numerator, WideInteger denominator) {
  if (denominator == 0 || !is_in_range(numerator) || !is_in_range(denominator)) {
    return not_a_number();
  }
  const WideInteger divisor = common_divisor(numerator, denominator);
  Fraction made;
  made.numerator_ = (denominator < 0 ? -numerator : numerator) / divisor;
  made.denominator_ = magnitude(denominator) / divisor;
  return made;
}

Fraction::Fraction(std::int64_t numerator, std::int64_t denominator)
    : Fraction(reduced(numerator, denominator)) {}

double Fraction::value() const {
  return static_cast<double>(numerator_) / static_cast<double>(denominator_);
}

std::string Fraction::text() const {
  if (!is_number()) return {};
  return is_whole() ? digits_of(numerator_) : digits_of(numerator_) + '/' + digits_of(denominator_);
}

Fraction Fraction::operator-() const {
  Fraction made = *this;
  made.numerator_ = -numerator_;
  return made;
}

Fraction Fraction::inverse() const {
  return is_number() ? reduced(denominator_, numerator_) : not_a_number();
}

Fraction operator+(const Fraction& a, const Fraction& b) {
  if (!a.is_number() || !b.is_number()) return Fraction::not_a_number();
  const WideInteger shared = common_divisor(a.denominator_, b.denominator_);
  WideInteger left = 0, right = 0, numerator = 0, denominator = 0;
  const bool overflows =
      __builtin_mul_overflow(a.numerator_, b.denominator_ / shared, &left) ||
      __builtin_mul_overflow(b.numerator_, a.denominator_ / shared, &right) ||
      __builtin_add_overflow(left, right, &numerator) ||
      __builtin_mul_overflow(a.denominator_, b.denominator_ / shared, &denominator);
  return overflows ? Fraction::not_a_number() : Fraction::reduced(numerator, denominator);
}

Fraction operator*(const Fraction& a, const Fraction& b) {
  if (!a.is_number() || !b.is_number()) return Fraction::not_a_number();
  // Reduced across first, so that no product is greater than it must be.
  const Fraction left = Fraction::reduced(a.numerator_, b.denominator_);
  const Fraction right = Fraction::reduced(b.numerator_, a.denominator_);
  WideInteger numerator = 0, denominator = 0;
  const bool overflows =
      __builtin_mul_overflow(left.numerator_, right.numerator_, &numerator) ||
      __builtin_mul_overflow(left.denominator_, right.denominator_, &denominator);
  return overflows ? Fraction::not_a_number() : Fraction::reduced(numerator, denominator);
}

Fraction common_measure(const Fraction& a, const Fraction& b) {
  if (!a.is_number() || !b.is_number()) return Fraction::not_a_number();
  const Fraction quotient = b.is_zero() ? Fraction(0) : a / b;
  if (b.is_zero()) return a.sign() < 0 ? -a : a;
  if (!quotient.is_number()) return quotient;
  // Of b·p/q and b with p/q reduced it is b/q.
  const Fraction measure = b * Fraction::reduced(1, quotient.denominator_);
  return measure.sign() < 0 ? -measure : measure;
}

}  // namespace cognate::train
