/// @file How the enums of studies are written.
#pragma once

#include "problems/basics/names.hpp"
#include "problems/study/block.hpp"
#include "problems/study/study.hpp"

namespace cognate::problems {

template <>
std::span<const Named<Sampling>> names<Sampling>();
template <>
std::span<const Named<RunStatus>> names<RunStatus>();

}  // namespace cognate::problems
