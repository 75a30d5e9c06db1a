#include "problems/mechanism/read_simple_mechanism.hpp"

#include <fmt/core.h>

#include <cmath>

#include "analysis/linkage/four_bar.hpp"
#include "problems/mechanism/directions.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/mechanism/simple_parts.hpp"

namespace cognate::problems::reading {
namespace {

double required_length(TableReader& table, std::string_view key) {
  if (!table.has(key)) {
    table.fault(key, fmt::format("is missing; {} is wanted", kLinkLength.allowed));
  }
  return table.number(key, kLinkLength).value_or(0);
}

double read_offset(TableReader& table) {
  return table.number("offset", kQuantity).value_or(0);
}

Vec2d read_place(TableReader& table, std::string_view key) {
  const Two place = table.two(key, kQuantity, "[x, y]").value_or(Two{});
  return {place[0], place[1]};
}

Assembly read_assembly(TableReader& table) {
  return table.choice<Assembly>("assembly").value_or(Assembly::open);
}

Vec2d read_direction(TableReader& table) {
  return unit_vector_at_degrees(read_degrees(table, "direction_deg", 0));
}

void read_fixed_pivots(TableReader& table, Vec2d& first, Vec2d& second) {
  constexpr std::string_view kKey = "fixed_pivots";
  constexpr std::string_view kForm = "[[x, y], [x, y]]";
  if (!table.has(kKey)) table.fault(kKey, fmt::format("is missing; {} is wanted", kForm));
  const auto pivots = table.twos(kKey, kQuantity, kForm, {2, 2, "pivots"});
  if (!pivots) return;
  first = {pivots->front()[0], pivots->front()[1]};
  second = {pivots->back()[0], pivots->back()[1]};
  const Vec2d between = second - first;
  if (!is_positive_quantity(std::hypot(between.x, between.y))) {
    table.fault(kKey, "coincide; two different points are wanted");
  }
}

// The direction of a second line or slot from the first.
Vec2d read_second_direction(TableReader& table, std::string_view key, std::string_view first) {
  const double degrees = read_degrees(table, key, 90);
  const Vec2d direction = unit_vector_at_degrees(degrees);
  if (are_parallel(direction, {1, 0})) {
    table.fault(key, fmt::format("is {}, parallel to {}, so that nothing would drive; an angle "
                                 "that is no multiple of 180 is wanted",
                                 degrees, first));
  }
  return direction;
}

void read(TableReader& table, FourBar& linkage) {
  read_fixed_pivots(table, linkage.pivot_a, linkage.pivot_d);
  linkage.crank = required_length(table, "crank");
  linkage.coupler = required_length(table, "coupler");
  linkage.rocker = required_length(table, "rocker");
  linkage.assembly = read_assembly(table);
  if (table.has("coupler_point")) {
    const Two point = table.two("coupler_point", kQuantity, "[u, v]").value_or(Two{});
    linkage.coupler_point = Vec2d{point[0], point[1]};
  }
}

template <class Any>
void read_slider_crank(TableReader& table, Any& mechanism) {
  mechanism.pivot = read_place(table, "pivot");
  mechanism.crank = required_length(table, "crank");
  mechanism.coupler = required_length(table, "coupler");
  mechanism.offset = read_offset(table);
  mechanism.direction = read_direction(table);
  mechanism.assembly = read_assembly(table);
}

void read(TableReader& table, SliderCrank& mechanism) {
  read_slider_crank(table, mechanism);
}

void read(TableReader& table, FixedBlock& mechanism) {
  read_slider_crank(table, mechanism);
}

template <class Any>
void read_guide_bar(TableReader& table, Any& mechanism) {
  read_fixed_pivots(table, mechanism.pivot_a, mechanism.pivot_c);
  mechanism.crank = required_length(table, "crank");
  mechanism.offset = read_offset(table);
  mechanism.assembly = read_assembly(table);
  if (mechanism.offset == 0 && mechanism.assembly == Assembly::crossed) {
    table.fault("assembly",
                "is \"crossed\" without an offset, where there is but one assembly; an offset that "
                "is not 0, or no assembly, is wanted");
  }
}

void read(TableReader& table, GuideBar& mechanism) {
  read_guide_bar(table, mechanism);
}

void read(TableReader& table, OscillatingBlock& mechanism) {
  read_guide_bar(table, mechanism);
}

void read(TableReader& table, ScotchYoke& mechanism) {
  mechanism.pivot = read_place(table, "pivot");
  mechanism.crank = required_length(table, "crank");
  mechanism.offset = read_offset(table);
  mechanism.direction = read_direction(table);
  mechanism.slot = read_second_direction(table, "slot_deg", "the slide line");
}

void read(TableReader& table, TangentGenerator& mechanism) {
  constexpr std::string_view kKey = "offset";
  constexpr NumberRule kOffset{[](double x) { return x != 0 && is_quantity(x); },
                               "the distance of the slide line from the pivot, not 0,"};
  if (!table.has(kKey)) table.fault(kKey, fmt::format("is missing; {} is wanted", kOffset.allowed));
  mechanism.pivot = read_place(table, "pivot");
  mechanism.offset = table.number(kKey, kOffset).value_or(1);
  mechanism.direction = read_direction(table);
}

void read(TableReader& table, EllipticTrammel& mechanism) {
  mechanism.centre = read_place(table, "centre");
  mechanism.length = required_length(table, "length");
  mechanism.direction = read_direction(table);
  mechanism.second_line = read_second_direction(table, "second_line_deg", "the first line");
}

void read(TableReader& table, OldhamCoupling& mechanism) {
  read_fixed_pivots(table, mechanism.pivot_a, mechanism.pivot_d);
  mechanism.slot = read_second_direction(table, "slot_deg", "the first tongue");
}

template <class Dimensions>
ReadMechanism read_whole(TableReader& table) {
  const std::size_t before = table.faults().size();
  Dimensions dimensions;
  read(table, dimensions);
  const bool sound = table.faults().size() == before;
  return {dimensions, as_mechanism(dimensions), parts_of(dimensions), sound};
}

}  // namespace

ReadMechanism read_simple_mechanism(TableReader& mechanism, MechanismType type) {
  switch (type) {
    case MechanismType::four_bar:
      return read_whole<FourBar>(mechanism);
    case MechanismType::slider_crank:
      return read_whole<SliderCrank>(mechanism);
    case MechanismType::guide_bar:
      return read_whole<GuideBar>(mechanism);
    case MechanismType::oscillating_block:
      return read_whole<OscillatingBlock>(mechanism);
    case MechanismType::fixed_block:
      return read_whole<FixedBlock>(mechanism);
    case MechanismType::scotch_yoke:
      return read_whole<ScotchYoke>(mechanism);
    case MechanismType::tangent_generator:
      return read_whole<TangentGenerator>(mechanism);
    case MechanismType::elliptic_trammel:
      return read_whole<EllipticTrammel>(mechanism);
    case MechanismType::oldham_coupling:
      return read_whole<OldhamCoupling>(mechanism);
    case MechanismType::chain:
      break;
  }
  return {};
}

}  // namespace cognate::problems::reading
