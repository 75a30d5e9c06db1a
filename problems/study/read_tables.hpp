/// @file The tables of a study file.
#pragma once

#include <filesystem>

#include "problems/study/read.hpp"
#include "problems/study/study.hpp"
#include "problems/toml/document.hpp"
#include "problems/toml/fault_list.hpp"

namespace cognate::problems::reading {

/// The study that `document` describes; only where `faults` stays empty is it whole. The base file
/// is looked for in `folder`, and `metrics` are those of its problem.
Study read_study(const Table& document, const std::filesystem::path& folder,
                 const MetricCatalogue& metrics, FaultList& faults);

}  // namespace cognate::problems::reading
