/// @file In the place of the program's analysis/numbers/parallel.hpp in the kernel of the pages,
/// which has one thread and no exceptions.
#pragma once

namespace cognate {

inline int thread_count(int /*asked*/) {
  return 1;
}

/// Calls `body(index, 0)` once for each index in [0, count), in order.
template <class Body>
void parallel_for(int count, int /*threads*/, Body&& body) {
  for (int index = 0; index < count; ++index) body(index, 0);
}

}  // namespace cognate
