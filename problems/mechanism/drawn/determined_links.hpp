/// @file Links of a drawing that what moves already determines together.
#pragma once

#include <cstddef>
#include <vector>

#include "problems/mechanism/drawn/drawing.hpp"

namespace cognate::problems::reading {

/// The fewest links that the links `moves` determine by the joints between them all, in ascending
/// order; empty where there are none. It counts: whether the joints are independent, the places
/// say.
///
/// Every equation of a joint is matched to a coordinate of a link, or of a pin whose links move all
/// with one another. What a link's equations depend on must be in the group, too: the groups are
/// the strong components of that relation (Dulmage & Mendelsohn 1958), of which the first has no
/// other before it.
std::vector<std::size_t> determined_links(const Drawing& drawing, const std::vector<bool>& moves);

}  // namespace cognate::problems::reading
