/// @file `[mechanism]` and `[bounds]`: what is given of a linkage, and what limits the rest.
#pragma once

#include "problems/linkage/class_feasibility.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The tables of a file that describes a linkage.
struct LinkageTables {
  TableReader target, mechanism, bounds, constraints, solve;

  explicit LinkageTables(TableReader& document)
      : target(document.table("target")),
        mechanism(document.table("mechanism")),
        bounds(document.table("bounds")),
        constraints(document.table("constraints")),
        solve(document.table("solve")) {}

  /// Faults every key that was never requested.
  void finish() {
    for (TableReader* table : {&target, &mechanism, &bounds, &constraints, &solve}) {
      table->finish();
    }
  }
};

/// Whether `point` lies in `box` or on its edge.
bool contains(const Box& box, Vec2d point);

/// `mechanism.type`: only "four-bar" is available, which may be left out.
void read_mechanism_type(TableReader& mechanism);

/// The lengths and the assembly that `[mechanism]` gives.
void read_given_links(TableReader& mechanism, Given& given);

/// The pivots (also as `fixed_pivots`), the frame's direction and the coupler point.
void read_given_places(TableReader& mechanism, Given& given);

/// The limits of the links, `length` merged into each.
void read_length_bounds(TableReader& bounds, Bounds& limits);

/// The limits of the pivots, the frame's direction and the coupler point.
void read_place_bounds(TableReader& bounds, Bounds& limits);

/// Faults everything that `[mechanism]` gives twice and differently, or outside its bounds.
void check_given(TableReader& mechanism, const Given& given, const Bounds& limits);

/// Within which limits each link lies, by `[mechanism]` (pivots given both fix the frame) and
/// `[bounds]`; an empty interval, already faulted, becomes the given length.
LengthLimits length_limits(const Given& given, const Bounds& limits);

}  // namespace cognate::problems::reading
