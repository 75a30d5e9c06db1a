/// @file How often memory was allocated: link count_allocations.cpp, which replaces operator new.
#pragma once

#include <cstddef>

namespace cognate::test {

/// Since the program began, by operator new.
std::size_t allocations();

}  // namespace cognate::test
