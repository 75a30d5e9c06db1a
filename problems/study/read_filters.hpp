/// @file `[filter]` of a study.
#pragma once

#include <string>
#include <vector>

#include "problems/study/read_metrics.hpp"
#include "problems/study/study.hpp"
#include "problems/toml/document.hpp"
#include "problems/toml/fault_list.hpp"

namespace cognate::problems::reading {

/// The filters in `table`. A name with dots may be in quotation marks or a dotted key.
std::vector<StudyFilter> read_filters(const Table& table, const StudyNames& names,
                                      FaultList& faults);

}  // namespace cognate::problems::reading
