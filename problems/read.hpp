/// @file Reading problem files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "problems/kinds.hpp"
#include "problems/toml/fault.hpp"

namespace cognate::problems {

/// What `text` (TOML) asks for, or every fault found in it, in the order of the file.
tl::expected<Task, std::vector<Fault>> parse_task(std::string_view text);

/// As `parse_task`, for a file. A file that cannot be read or is larger than 8 MiB is a fault at
/// 1:1.
tl::expected<Task, std::vector<Fault>> read_task(const std::filesystem::path& file);

/// As `parse_task` and `read_task`, where the design of a linkage is wanted: that a sound file asks
/// for something else is then a fault at its `kind`.
tl::expected<Problem, std::vector<Fault>> parse_problem(std::string_view text);
tl::expected<Problem, std::vector<Fault>> read_problem(const std::filesystem::path& file);

/// The same where an analysis is wanted.
tl::expected<AnalysisProblem, std::vector<Fault>> parse_analysis(std::string_view text);
tl::expected<AnalysisProblem, std::vector<Fault>> read_analysis(const std::filesystem::path& file);

/// The same where a running machine is wanted.
tl::expected<MachineProblem, std::vector<Fault>> parse_machine(std::string_view text);
tl::expected<MachineProblem, std::vector<Fault>> read_machine(const std::filesystem::path& file);

/// The same where a cam is wanted.
tl::expected<CamProblem, std::vector<Fault>> parse_cam(std::string_view text);
tl::expected<CamProblem, std::vector<Fault>> read_cam(const std::filesystem::path& file);

/// The same where a gear is wanted.
tl::expected<GearProblem, std::vector<Fault>> parse_gear(std::string_view text);
tl::expected<GearProblem, std::vector<Fault>> read_gear(const std::filesystem::path& file);

/// The same where a pair of gears is wanted.
tl::expected<GearPairProblem, std::vector<Fault>> parse_gear_pair(std::string_view text);
tl::expected<GearPairProblem, std::vector<Fault>> read_gear_pair(const std::filesystem::path& file);

}  // namespace cognate::problems
