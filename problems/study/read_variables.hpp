/// @file `[[vary]]` of a study.
#pragma once

#include "problems/study/read_base.hpp"
#include "problems/study/study.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Reads what varies into `study`: keys that are numbers in `base` (any, where that could not be
/// read), each once, as a grid or together as samples; not too many designs.
void read_variables(TableReader& study_file, const BaseFile* base, Study& study);

}  // namespace cognate::problems::reading
