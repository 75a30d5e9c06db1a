#include "problems/chain/three_pin/group.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace cognate::problems {
namespace {

constexpr int kPins = 3;

/// The points that hold its pins, as lines.
std::array<int, kPins> holders(const Topology& topology, int last) {
  const auto from = [&](int line) {
    return topology.lines[static_cast<std::size_t>(line)].line.first;
  };
  return {from(last - 2), from(last - 1), from(last - synthesis::kThirdPin)};
}

/// The axes of a body from one point towards another.
Placement placement(const Vec2d& from, const Vec2d& to) {
  const Vec2d way = to - from;
  return {from, (1 / norm(way)) * way};
}

}  // namespace

std::vector<std::string> three_pin_names(const Topology& topology, int last) {
  const auto name = [&](int line) { return topology.lines[static_cast<std::size_t>(line)].name; };
  const auto from = holders(topology, last);
  std::vector<std::string> names;
  for (int pin = 0; pin < kPins; ++pin) {
    names.push_back(link_name(name(from[static_cast<std::size_t>(pin)]), name(last - 2 + pin)));
  }
  const std::string two = link_name(name(last - 2), name(last - 1)), third = name(last);
  const bool letters = two.size() == 2 && third.size() == 1;
  names.push_back(letters ? two + third : fmt::format("{}-{}", two, third));
  return names;
}

ThreePinGroup three_pin_group(const Topology& topology, const ChainPlaces& places, int last,
                              const std::vector<Vec2d>& at,
                              const std::vector<std::string>& bodies) {
  const auto name = [&](int line) { return topology.lines[static_cast<std::size_t>(line)].name; };
  const auto stands = [&](int line) { return at[static_cast<std::size_t>(line)]; };
  const auto from = holders(topology, last);
  ThreePinGroup made;
  GroupDescription& description = made.description;
  description.names = three_pin_names(topology, last);
  const int first = static_cast<int>(places.place(last - 2).first), own = first + kPins;
  for (int pin = 0; pin < kPins; ++pin) {
    const auto i = static_cast<std::size_t>(pin);
    const int line = last - 2 + pin;
    const auto [body, held] = places.place(from[i]);
    made.group.joints.push_back({{body, held}, {first + pin, {}}});
    description.joints.push_back({name(from[i]),
                                  {bodies[static_cast<std::size_t>(body)], description.names[i]},
                                  {held, {}},
                                  {}});
    description.drawn.push_back(placement(stands(from[i]), stands(line)));
  }
  for (int pin = 0; pin < kPins; ++pin) {
    const auto i = static_cast<std::size_t>(pin);
    const int line = last - 2 + pin;
    const Vec2d end = *places.find(first + pin, line), pinned = *places.find(own, line);
    made.group.joints.push_back({{first + pin, end}, {own, pinned}});
    description.joints.push_back(
        {name(line), {description.names[i], description.names.back()}, {end, pinned}, {}});
  }
  description.drawn.push_back(placement(stands(last - 2), stands(last - 1)));
  made.group.drawn = description.drawn;
  return made;
}

std::vector<double> three_pin_parameters(const Group& group) {
  const auto length = [&](std::size_t pin) { return group.joints[kPins + pin].first.at.x; };
  const auto& [first, axis] = group.drawn.back();
  const double distance = group.joints[kPins + 1].second.at.x;
  const Vec2d second = first + distance * axis, third = group.joints[kPins + 2].second.at;
  return {length(2), first.x,   first.y,  second.x, second.y,
          length(0), length(1), distance, third.x,  third.y};
}

}  // namespace cognate::problems
