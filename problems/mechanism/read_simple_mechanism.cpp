#include "problems/mechanism/read_simple_mechanism.hpp"

#include <fmt/core.h>

#include <cmath>
#include <variant>

#include "problems/mechanism/directions.hpp"
#include "problems/mechanism/mechanism_types.hpp"
#include "problems/mechanism/quantity_rules.hpp"

namespace cognate::problems::reading {
namespace {

double required_length(TableReader& table, std::string_view key) {
  if (!table.has(key)) {
    table.fault(key, fmt::format("is missing; expected {}", kLinkLength.allowed));
  }
  return table.number(key, kLinkLength).value_or(0);
}

double read_nonzero(TableReader& table, std::string_view key) {
  constexpr NumberRule kOffset{[](double x) { return x != 0 && is_quantity(x); },
                               "the distance of the slide line from the pivot, not 0,"};
  if (!table.has(key)) table.fault(key, fmt::format("is missing; expected {}", kOffset.allowed));
  return table.number(key, kOffset).value_or(1);
}

Vec2d read_place(TableReader& table, std::string_view key) {
  const Two place = table.two(key, kQuantity, "[x, y]").value_or(Two{});
  return {place[0], place[1]};
}

void read_pivots(TableReader& table, std::string_view key, Vec2d& first, Vec2d& second) {
  constexpr std::string_view kForm = "[[x, y], [x, y]]";
  if (!table.has(key)) table.fault(key, fmt::format("is missing; expected {}", kForm));
  const auto pivots = table.twos(key, kQuantity, kForm, {2, 2, "pivots"});
  if (!pivots) return;
  first = {pivots->front()[0], pivots->front()[1]};
  second = {pivots->back()[0], pivots->back()[1]};
  const Vec2d between = second - first;
  if (!is_positive_quantity(std::hypot(between.x, between.y))) {
    table.fault(key, "coincide; expected two different points");
  }
}

// The direction of a second line or slot from the first.
Vec2d read_second_direction(TableReader& table, std::string_view key, std::string_view first) {
  const double degrees = read_degrees(table, key, 90);
  const Vec2d direction = unit_vector_at_degrees(degrees);
  if (are_parallel(direction, {1, 0})) {
    table.fault(key,
                fmt::format("is {}, parallel to {}, so that nothing would drive; expected an angle "
                            "that is no multiple of 180",
                            degrees, first));
  }
  return direction;
}

/// Reads what one key holds into the mechanism.
template <class Type>
struct ReadKey {
  TableReader& table;
  std::string_view key;
  Type& made;

  void operator()(const LengthKey<Type>& length) const {
    made.*length.of = required_length(table, key);
  }
  void operator()(const OffsetKey<Type>& offset) const {
    made.*offset.of = table.number(key, kQuantity).value_or(0);
  }
  void operator()(const NonzeroKey<Type>& offset) const {
    made.*offset.of = read_nonzero(table, key);
  }
  void operator()(const PlaceKey<Type>& place) const { made.*place.of = read_place(table, key); }
  void operator()(const PivotsKey<Type>& pivots) const {
    read_pivots(table, key, made.*pivots.first, made.*pivots.second);
  }
  void operator()(const DirectionKey<Type>& direction) const {
    made.*direction.of = unit_vector_at_degrees(read_degrees(table, key, 0));
  }
  void operator()(const InclinationKey<Type>& line) const {
    made.*line.of = read_second_direction(table, key, line.from);
  }
  void operator()(const AssemblyKey<Type>& assembly) const {
    made.*assembly.of = table.choice<Assembly>(key).value_or(Assembly::open);
  }
  void operator()(const PointKey<Type>& point) const {
    if (!table.has(key)) return;
    const Two at = table.two(key, kQuantity, "[u, v]").value_or(Two{});
    made.*point.of = Vec2d{at[0], at[1]};
  }
};

// Rules between the keys of a type.
template <class Type>
void check(TableReader&, const Type&) {}

template <class GuideBarLike>
void check_guide_bar(TableReader& table, const GuideBarLike& mechanism) {
  if (mechanism.offset != 0 || mechanism.assembly != Assembly::crossed) return;
  table.fault("assembly",
              "is \"crossed\" without an offset, where there is but one assembly; expected an "
              "offset that is not 0, or no assembly");
}

void check(TableReader& table, const GuideBar& mechanism) {
  check_guide_bar(table, mechanism);
}

void check(TableReader& table, const OscillatingBlock& mechanism) {
  check_guide_bar(table, mechanism);
}

template <class Type>
ReadMechanism read_whole(TableReader& table) {
  const std::size_t before = table.faults().size();
  Type made;
  for (const auto& key : TypeTraits<Type>::kKeys) {
    std::visit(ReadKey<Type>{table, key.name, made}, key.holds);
  }
  check(table, made);
  const bool sound = table.faults().size() == before;
  return {made, as_mechanism(made), TypeTraits<Type>::parts(made), TypeTraits<Type>::kOutput,
          sound};
}

}  // namespace

ReadMechanism read_simple_mechanism(TableReader& mechanism, MechanismType type) {
  ReadMechanism read;
  for_each_mechanism_type([&]<class Type>(std::type_identity<Type>) {
    if constexpr (SimpleType<Type>) {
      if (TypeTraits<Type>::kWord == to_string(type)) read = read_whole<Type>(mechanism);
    }
  });
  return read;
}

}  // namespace cognate::problems::reading
