/// @file When a load acts.
#pragma once

#include "problems/basics/names.hpp"

namespace cognate::problems {

/// `advance`: while the body it acts on moves in its positive sense (along its guide, or
/// counter-clockwise), `retreat` (written "return"): in the negative sense.
enum class LoadSense { always, advance, retreat };

template <>
std::span<const Named<LoadSense>> names<LoadSense>();

}  // namespace cognate::problems
