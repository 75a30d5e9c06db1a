/// @file `[[point]]`: points of links other than their joints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/mechanism/mechanism_description.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// A `[[point]]` that waits for its body: a later dyad may join it, and an earlier one carry it.
struct WaitingPoint {
  PointDescription description;
  std::vector<Mention> on;
};

/// The tables `[[point]]` of `table`, their names announced. Of a faulty one the name is announced
/// and `names` is incomplete.
std::vector<WaitingPoint> read_extra_points(TableReader& table, PartNames& names);

/// Places those of `waiting` whose bodies are known by now, in the order of the file, and takes
/// them out of it; returns their descriptions.
std::vector<PointDescription> place_extra_points(std::vector<WaitingPoint>& waiting,
                                                 PartNames& names);

/// A fault for each of `waiting`, whose bodies are not known once all are.
void fault_unplaced(const std::vector<WaitingPoint>& waiting, const PartNames& names,
                    FaultList& faults);

}  // namespace cognate::problems::reading
