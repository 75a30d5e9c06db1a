/// @file Whether a design passes the filters of its study.
#pragma once

#include "problems/study/block.hpp"
#include "problems/study/study.hpp"

namespace cognate::problems {

/// Whether `value` is what `filter` lets pass; no value never is.
bool passes(const StudyFilter& filter, const Cell& value);

}  // namespace cognate::problems
