/// @file `type = "chain"`: a drive and dyads that join points by name, or joints as drawn.
#pragma once

#include <optional>

#include "problems/mechanism/part_names.hpp"
#include "problems/mechanism/read_extra_points.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// A chain as far as it has been read: the description says in the file's terms what `mechanism`
/// and `names` hold as bodies.
struct Chain {
  ChainDescription description;
  Mechanism<double> mechanism;
  PartNames names;
  std::vector<PointDescription> points;  ///< `[[point]]`, in the order of their placing
  std::vector<std::string> used;         ///< the points that a drive, a dyad or a slide names
  /// Of each body that never turns, its first axis; empty for those that may.
  std::vector<std::optional<Vec2d>> steady{Vec2d{1, 0}};
  /// Where its joints are given as drawn, what its drive is at there.
  std::optional<double> drawn;
};

/// The chain that `mechanism` (`[mechanism]`) and `document` define: its tables may stand in
/// either. With a fault, `names.incomplete` is set.
Chain read_chain(TableReader& document, TableReader& mechanism);

}  // namespace cognate::problems::reading
