/// @file Reading study files.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "problems/read.hpp"
#include "problems/study/metric_names.hpp"
#include "problems/study/study.hpp"

namespace cognate::problems {

/// The metrics of the problem of a base file.
using MetricCatalogue = std::function<MetricNames(const Task& base)>;

/// The study in `text` (TOML), or every fault found in it, in the order of the file. Its base file
/// is looked for in `folder`; a base that cannot be read, or is itself faulty, is a fault at
/// `base`.
tl::expected<Study, std::vector<Fault>> parse_study(std::string_view text,
                                                    const std::filesystem::path& folder,
                                                    const MetricCatalogue& metrics);

/// As `parse_study`, for a file. One that cannot be read or is larger than 8 MiB is a fault at 1:1.
tl::expected<Study, std::vector<Fault>> read_study(const std::filesystem::path& file,
                                                   const MetricCatalogue& metrics);

/// Any content of a file.
using TaskOrStudy = std::variant<Task, Study>;

/// What `text` (TOML) holds, a task or a study, or every fault found in it. Files that it names are
/// looked for in `folder`; where that is empty, a task names none.
tl::expected<TaskOrStudy, std::vector<Fault>> parse_task_or_study(
    std::string_view text, const std::filesystem::path& folder, const MetricCatalogue& metrics);

/// What `file` holds, a task or a study, or every fault found in it.
tl::expected<TaskOrStudy, std::vector<Fault>> read_task_or_study(const std::filesystem::path& file,
                                                                 const MetricCatalogue& metrics);

}  // namespace cognate::problems
