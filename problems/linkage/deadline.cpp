#include "problems/linkage/deadline.hpp"

#include <limits>

#include "problems/linkage/result.hpp"

namespace cognate::problems {

Deadline::Deadline(const Run& run)
    : synthesis::Deadline(run.time_limit.value_or(std::numeric_limits<double>::infinity()),
                          run.interrupted) {}

}  // namespace cognate::problems
