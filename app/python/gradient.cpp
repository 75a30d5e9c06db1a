#include "app/python/gradient.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

#include "analysis/mechanism/convert.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/dual.hpp"
#include "app/python/written_dimensions.hpp"
#include "problems/mechanism/mechanism_types.hpp"

namespace cognate::python {
namespace {

using problems::NamedMechanism;

/// Lists the dimensions of one type, each as the mechanism that has it changed.
template <class Type>
class Lister {
 public:
  Lister(const NamedMechanism& mechanism, const Type& type) : mechanism_(mechanism), type_(type) {}

  std::vector<Dimension> list() {
    for (const auto& key : problems::TypeTraits<Type>::kKeys) {
      name_ = key.name;
      std::visit([&](const auto& holds) { add(holds); }, key.holds);
    }
    return std::move(all_);
  }

 private:
  // A step of the size of the mechanism: differences of what is linear have then no cancellation.
  double size() const {
    double size = 0;
    for (const auto& point : mechanism_.points) size = std::max(size, norm(point.at.at));
    return size > 0 ? size : 1;
  }

  // Numbers of a mechanism are linear in its dimensions (angles enter by their unit vectors, which
  // are moved along their tangents): their difference over the step is their derivative but for
  // roundings, however long the step.
  void add(const std::string& name, double step, const Type& changed) {
    const NamedMechanism moved = problems::named(changed);
    Dimension dimension{name, numbers_of(moved.mechanism), {}};
    const std::vector<double> before = numbers_of(mechanism_.mechanism);
    for (std::size_t i = 0; i < before.size(); ++i) {
      dimension.numbers[i] = (dimension.numbers[i] - before[i]) / step;
    }
    for (std::size_t i = 0; i < moved.points.size(); ++i) {
      dimension.points.push_back((1 / step) * (moved.points[i].at.at - mechanism_.points[i].at.at));
    }
    all_.push_back(std::move(dimension));
  }

  void add_number(double Type::*of) {
    Type changed = type_;
    const double step = size();
    changed.*of += step;
    add(name_, step, changed);
  }

  void add_place(const std::string& name, Vec2d Type::*of) {
    const double step = size();
    for (const int axis : {0, 1}) {
      Type changed = type_;
      changed.*of = changed.*of + (axis == 0 ? Vec2d{step, 0} : Vec2d{0, step});
      add(fmt::format("{}[{}]", name, axis), step, changed);
    }
  }

  void add_direction(Vec2d Type::*of) {
    Type changed = type_;
    changed.*of = changed.*of + perp(changed.*of);
    add(name_, 180 / kPi, changed);
  }

  void add(const problems::LengthKey<Type>& key) { add_number(key.of); }
  void add(const problems::OffsetKey<Type>& key) { add_number(key.of); }
  void add(const problems::NonzeroKey<Type>& key) { add_number(key.of); }
  void add(const problems::PlaceKey<Type>& key) { add_place(name_, key.of); }
  void add(const problems::PivotsKey<Type>& key) {
    const std::string name = name_;
    add_place(name + "[0]", key.first);
    add_place(name + "[1]", key.second);
  }
  void add(const problems::DirectionKey<Type>& key) { add_direction(key.of); }
  void add(const problems::InclinationKey<Type>& key) { add_direction(key.of); }
  void add(const problems::AssemblyKey<Type>& /*key*/) {}
  void add(const problems::PointKey<Type>& key) {
    if (!(type_.*key.of)) return;
    const double step = size();
    for (const int axis : {0, 1}) {
      Type changed = type_;
      changed.*key.of = *(type_.*key.of) + (axis == 0 ? Vec2d{step, 0} : Vec2d{0, step});
      add(fmt::format("{}[{}]", name_, axis), step, changed);
    }
  }

  const NamedMechanism& mechanism_;
  const Type& type_;
  std::string name_;
  std::vector<Dimension> all_;
};

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Whether all dyads on which `body` depends can be assembled. The roots of dual numbers take what
/// is below zero for rounding.
bool is_closed(const Mechanism<double>& mechanism, int body,
               const std::vector<DyadClosure<Dual>>& closures) {
  for (std::size_t k = 0; k < closures.size(); ++k) {
    if (first_body(mechanism, static_cast<int>(k)) > body) break;
    if (!(closures[k].discriminant.value >= 0)) return false;
  }
  return true;
}

}  // namespace

std::vector<Dimension> dimensions_of(const NamedMechanism& mechanism) {
  return std::visit(
      [&]<class Type>(const Type& type) {
        if constexpr (problems::SimpleType<Type>) {
          if (mechanism.extra_points.empty()) return Lister<Type>(mechanism, type).list();
        }
        return written_dimensions(mechanism);
      },
      mechanism.description);
}

void point_gradient(const NamedMechanism& mechanism, const Dimension& dimension, std::size_t index,
                    std::span<const double> angles, std::span<double> x, std::span<double> y) {
  std::size_t next = 0;
  const auto lift = [&](double value) { return Dual{value, dimension.numbers[next++]}; };
  const Mechanism<Dual> dual = convert<Dual>(mechanism.mechanism, lift);
  const Attached<double>& point = mechanism.points[index].at;
  const Vec2d rate = dimension.points[index];
  const Vec2<Dual> at{{point.at.x, rate.x}, {point.at.y, rate.y}};
  const std::vector<double> sides = cognate::sides(mechanism.mechanism);
  const std::vector<Dual> dual_sides(sides.begin(), sides.end());
  std::vector<BodyMotion<Dual, 0>> bodies(
      static_cast<std::size_t>(body_count(mechanism.mechanism)));
  std::vector<DyadClosure<Dual>> closures(sides.size());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const DrivePosition<double> drive = drive_position(mechanism.mechanism, angles[i]);
    const DrivePosition<Dual> position{{Dual(drive.direction.x), Dual(drive.direction.y)},
                                       Dual(drive.displacement)};
    evaluate<0, Dual>(dual, position, dual_sides, bodies, closures);
    const auto& body = bodies[static_cast<std::size_t>(point.body)];
    const Vec2<Dual> there = body.origin[0] + at * body.direction;
    x[i] = is_closed(mechanism.mechanism, point.body, closures) ? there.x.rate : kNone;
    y[i] = is_closed(mechanism.mechanism, point.body, closures) ? there.y.rate : kNone;
  }
}

}  // namespace cognate::python
