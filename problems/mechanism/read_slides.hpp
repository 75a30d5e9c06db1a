/// @file `slide = {through, direction_deg, offset, on}`: straight guides of a chain.
#pragma once

#include <optional>

#include "problems/mechanism/read_chain.hpp"

namespace cognate::problems::reading {

/// A guide, and how the file describes it.
struct ReadSlide {
  SlideDescription description;
  Guide<double> guide;
};

/// The guide in `table`, on a body that `chain` has already; empty where a fault was added or the
/// body was left out because of one.
std::optional<ReadSlide> read_slide(TableReader& table, Chain& chain);

/// As `read_slide`, for the table `slide` of `table`, which must be there.
std::optional<ReadSlide> read_slide_of(TableReader& table, Chain& chain);

}  // namespace cognate::problems::reading
