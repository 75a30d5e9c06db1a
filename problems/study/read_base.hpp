/// @file The base file of a study.
#pragma once

#include <filesystem>
#include <optional>

#include "problems/study/read.hpp"
#include "problems/study/study.hpp"
#include "problems/toml/document.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// A base file and what can be varied and asked of it.
struct BaseFile {
  Table document;
  std::vector<std::string> number_keys;
  MetricNames metrics;
};

/// The base that `study.base` names, looked for in `folder`; fills in the parts of `study` about
/// it. Empty, with a fault, where there is none or it cannot be read as a problem or a mechanism.
std::optional<BaseFile> read_base(TableReader& study_file, const std::filesystem::path& folder,
                                  const MetricCatalogue& metrics, Study& study);

}  // namespace cognate::problems::reading
