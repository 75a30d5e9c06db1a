#include "problems/mechanism/named_mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "analysis/linkage/four_bar.hpp"
#include "problems/mechanism/mechanism_types.hpp"
#include "problems/mechanism/quantity_rules.hpp"

namespace cognate::problems {
namespace {

void set_parts(NamedMechanism& mechanism, const NamedParts& parts) {
  for (const Body& body : parts.bodies) mechanism.bodies.push_back(body.name);
  for (const PointOnLink& point : parts.points) {
    mechanism.points.push_back({point.name, point.on.front()});
  }
}

}  // namespace

NamedMechanism named(const MechanismDescription& description) {
  NamedMechanism mechanism;
  mechanism.description = description;
  std::visit(
      [&]<class Type>(const Type& dimensions) {
        if constexpr (SimpleType<Type>) {
          mechanism.mechanism = as_mechanism(dimensions);
          set_parts(mechanism, TypeTraits<Type>::parts(dimensions));
          mechanism.output = TypeTraits<Type>::kOutput;
        }
      },
      description);
  return mechanism;
}

void add_point(NamedMechanism& mechanism, const std::string& name, const std::string& body,
               const Vec2d& at) {
  const auto found = std::ranges::find(mechanism.bodies, body);
  const auto number = static_cast<int>(found - mechanism.bodies.begin());
  // What rounding has left of 0 is no number that a file may have.
  const auto written = [](double x) {
    return reading::is_quantity(x) || !(std::abs(x) < 1) ? x : 0;
  };
  const Vec2d place{written(at.x), written(at.y)};
  mechanism.points.push_back({name, {number, place}});
  mechanism.extra_points.push_back({name, {body}, place});
}

}  // namespace cognate::problems
