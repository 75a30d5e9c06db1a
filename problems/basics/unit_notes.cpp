#include "problems/basics/unit_notes.hpp"

#include <fmt/core.h>

#include <cmath>

namespace cognate::problems {
namespace {

constexpr double kEarth = 9.80665;  // m/s²
constexpr double kLongInMetres = 20;

/// Within a fiftieth: 9.8 and 10 count as well.
bool is_near(double value, double wanted) {
  constexpr double kNear = 0.02;
  return std::abs(value - wanted) <= kNear * wanted;
}

}  // namespace

std::vector<std::string> unit_notes(const WeighedLengths& lengths) {
  const double gravity = norm(lengths.gravity);
  if (lengths.unit) {
    const double earth = kEarth / metres(lengths.unit);
    if (earth == kEarth || !is_near(gravity, kEarth)) return {};
    return {
        fmt::format("gravity is {:.6g} {}/s², far below the Earth's, which is {:.6g} in this unit "
                    "of length.",
                    gravity, to_string(*lengths.unit), earth)};
  }
  if (is_near(gravity, kEarth * 1000)) {
    return {
        fmt::format("gravity is {:.6g}, the Earth's in mm/s², but forces count lengths as m; "
                    "length_unit = \"mm\" at the top of the file makes them right.",
                    gravity)};
  }
  if (!(lengths.longest > kLongInMetres)) return {};
  return {
      fmt::format("a link is {:.6g} long, and forces count lengths as m; length_unit = \"mm\", "
                  "\"cm\", \"m\" or "
                  "\"in\" at the top of the file says what they are in.",
                  lengths.longest)};
}

}  // namespace cognate::problems
