#include "problems/mechanism/directions.hpp"

#include <cmath>

namespace cognate::problems::reading {

Vec2d unit_vector_at_degrees(double degrees) {
  int quarter = 0;
  const double rest = radians(std::remquo(degrees, 90.0, &quarter));
  const Vec2d turned{std::cos(rest), std::sin(rest)};
  switch (static_cast<unsigned>(quarter) % 4U) {
    case 1:
      return perp(turned);
    case 2:
      return -turned;
    case 3:
      return -perp(turned);
    default:
      return turned;
  }
}

double read_degrees(TableReader& table, std::string_view key, double otherwise) {
  return table.number(key, kAngle).value_or(otherwise);
}

bool are_parallel(Vec2d a, Vec2d b) {
  constexpr double kRounding = 1e-12;
  return std::abs(cross(a, b)) < kRounding;
}

}  // namespace cognate::problems::reading
