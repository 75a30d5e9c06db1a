/// @file Designs of the same links: mirror images and twins.
#pragma once

#include <vector>

#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Says of each four-bar whose links have, to within 1e-6 of the longest, the lengths of a design
/// before it which that is and in what the two differ: of one that is put together the other way
/// with its coupler point on the other side, which moves as the other does in a mirror,
/// `mirror_of`; of any other `twin_of`. Cognates are left as they are, and of mirror images that
/// are known as such only the differences are filled in.
void mark_twins(std::vector<Design>& designs);

}  // namespace cognate::problems
