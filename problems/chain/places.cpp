#include "problems/chain/places.hpp"

#include <algorithm>
#include <array>

namespace cognate::problems {

using synthesis::ChainLine;
using synthesis::LineType;

/// A link with three pins, by its last line and the points that hold it; of its parameters those
/// that are no places.
struct ChainPlaces::ThreePins {
  int last;
  std::array<int, 3> from;
  std::array<double, 3> lengths;
  double distance;
  Vec2d third;
};

void ChainPlaces::add_three_pins(const ThreePins& link) {
  const int first = link.last - 2;
  for (int pin = 0; pin < 3; ++pin) {
    const auto i = static_cast<std::size_t>(pin);
    bodies_.push_back({{link.from[i], {}}, {first + pin, {link.lengths[i], 0}}});
  }
  bodies_.push_back({{first, {}}, {first + 1, {link.distance, 0}}, {link.last, link.third}});
}

ChainPlaces::ChainPlaces(std::span<const ChainLine> lines, std::span<const double> parameters)
    : bodies_(2) {
  std::size_t next = 0;
  for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
    const auto& [type, first, second] = lines[static_cast<std::size_t>(i)];
    const auto parameter = [&](std::size_t k) {
      return parameters.empty() ? 0.0 : parameters[next + k];
    };
    switch (type) {
      case LineType::pivot:
        bodies_[0].push_back({i, {parameter(0), parameter(1)}});
        break;
      case LineType::crank:
        bodies_[1] = {{first, {}}, {i, {parameter(0), 0}}};
        break;
      case LineType::dyad:
        bodies_.push_back({{first, {}}, {i, {parameter(0), 0}}});
        bodies_.push_back({{second, {}}, {i, {parameter(1), 0}}});
        break;
      case LineType::guide:
      case LineType::heading:
      case LineType::third_link:
      case LineType::drawn:
      case LineType::first_pin:
      case LineType::second_pin:
        break;
      case LineType::third_pin: {
        const auto from = [&](int back) {
          const int line = i - back;
          return lines[static_cast<std::size_t>(line)].first;
        };
        const auto before = [&](std::size_t count) {
          return parameters.empty() ? 0.0 : parameters[next - count];
        };
        add_three_pins({i,
                        {from(2), from(1), from(synthesis::kThirdPin)},
                        {before(3), before(2), before(8)},
                        before(1),
                        {parameter(0), parameter(1)}});
        break;
      }
      case LineType::slider:
        bodies_.push_back({{first, {}}, {i, {parameter(0), 0}}});
        bodies_.push_back({{i, {}}});
        break;
      case LineType::attached:
        if (const auto body = common_body(first, second)) {
          const Vec2d at = in_body(first, second, {parameter(0), parameter(1)});
          bodies_[static_cast<std::size_t>(*body)].push_back({i, at});
        }
        break;
    }
    next += static_cast<std::size_t>(parameter_count(type));
  }
}

std::optional<Vec2d> ChainPlaces::find(int body, int line) const {
  for (const auto& [point, at] : bodies_[static_cast<std::size_t>(body)]) {
    if (point == line) return at;
  }
  return std::nullopt;
}

std::optional<int> ChainPlaces::common_body(int first, int second) const {
  for (int body = body_count() - 1; body >= 0; --body) {
    if (find(body, first) && find(body, second)) return body;
  }
  return std::nullopt;
}

std::pair<int, Vec2d> ChainPlaces::place(int line) const {
  for (int body = 0; body < body_count(); ++body) {
    if (const auto at = find(body, line)) return {body, *at};
  }
  return {};
}

std::pair<Vec2d, Vec2d> ChainPlaces::axes(int first, int second) const {
  const auto body = common_body(first, second);
  if (!body) return {{}, {1, 0}};
  const Vec2d origin = *find(*body, first), along = *find(*body, second) - origin;
  const double distance = norm(along);
  return {origin, distance > 0 ? (1 / distance) * along : Vec2d{1, 0}};
}

Vec2d ChainPlaces::in_body(int first, int second, const Vec2d& at) const {
  const auto [origin, direction] = axes(first, second);
  return origin + direction * at;
}

Vec2d ChainPlaces::in_axes(int first, int second, const Vec2d& place) const {
  const auto [origin, direction] = axes(first, second);
  return conj(direction) * (place - origin);
}

}  // namespace cognate::problems
