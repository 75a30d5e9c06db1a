#include "problems/mechanism/named_mechanism.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "analysis/linkage/four_bar.hpp"
#include "problems/mechanism/mechanism_types.hpp"

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
  mechanism.points.push_back({name, {number, at}});
  mechanism.extra_points.push_back({name, {body}, at});
}

}  // namespace cognate::problems
