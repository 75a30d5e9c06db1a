#include "problems/basics/degrees.hpp"

#include <array>
#include <charconv>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {

double degrees(double radians) {
  constexpr int kDigits = 15;
  const double nearest = radians * (180.0 / kPi);
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), nearest,
                                 std::chars_format::general, kDigits)
                       .ptr;
  double rounded = nearest;
  std::from_chars(text.data(), end, rounded);
  const bool reads_back = rounded * (kPi / 180.0) == radians;
  return reads_back ? rounded : nearest;
}

}  // namespace cognate::problems
