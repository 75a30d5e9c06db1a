/// @file The keys of a `[[dyad]]`: what it joins, its lengths and slides, and whether it may move.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "problems/mechanism/read_chain.hpp"
#include "problems/mechanism/read_slides.hpp"

namespace cognate::problems::reading {

/// The places in the list of points of the `count` points that `joins` names; empty where one is
/// wrong or unknown. `form` is how the key is written.
std::vector<std::size_t> read_joins(TableReader& table, Chain& chain, std::size_t count,
                                    std::string_view form, DyadDescription& dyad);

/// `lengths = [...]`, for one also `length`.
std::optional<std::vector<double>> read_lengths(TableReader& table, std::size_t count);

/// The two slides of a PRP; fewer where one is wrong or unknown.
std::vector<ReadSlide> read_two_slides(TableReader& table, Chain& chain);

void read_assembly(TableReader& table, DyadDescription& dyad);
void read_new(TableReader& table, DyadDescription& dyad);

/// Whether the outer joints of a dyad depend on different bodies: between two points of one body, a
/// point and a slide, or two slides, it would only be one more rigid part of that body. A fault
/// where they do not.
bool may_move(TableReader& table, const Chain& chain, const std::vector<std::size_t>& joins);
bool may_move(TableReader& table, const Chain& chain, std::size_t joined, int guide_body);

/// The same for two slides, which must not stay parallel either.
bool may_move(TableReader& table, const Chain& chain, const Guide<double>& first,
              const Guide<double>& second);

/// The direction of a guide on a body that never turns; empty where it may.
std::optional<Vec2d> steady_direction(const Chain& chain, const Guide<double>& guide);

}  // namespace cognate::problems::reading
