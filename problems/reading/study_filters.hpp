/// @file `[filter]` of a study.
#pragma once

#include <string>
#include <vector>

#include "problems/reading/document.hpp"
#include "problems/reading/fault_list.hpp"
#include "problems/reading/study_metrics.hpp"
#include "problems/study/study.hpp"

namespace cognate::problems::reading {

/// The filters in `table`. A name with dots may be in quotation marks or a dotted key.
std::vector<StudyFilter> read_filters(const Table& table, const StudyNames& names,
                                      FaultList& faults);

}  // namespace cognate::problems::reading
