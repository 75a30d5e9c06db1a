/// @file Reading problem files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "problems/kinds.hpp"
#include "problems/toml/fault.hpp"

namespace cognate::problems {

/// The problem of a file, and the place of its `kind`, counted from 1.
struct TaskAt {
  Task task;
  std::size_t line = 1;
  std::size_t column = 1;
};

/// The problem in `text` (TOML), or every fault found in it, in the order of the file.
tl::expected<TaskAt, std::vector<Fault>> parse_task_at(std::string_view text);

/// As `parse_task_at`, for a file. One that cannot be read or is larger than 8 MiB is a fault at
/// 1:1.
/// A `length_unit` is that of a file that has none; that the file has another one is a fault.
tl::expected<TaskAt, std::vector<Fault>> read_task_at(const std::filesystem::path& file,
                                                      std::optional<LengthUnit> length_unit = {});

/// The same without the place.
tl::expected<Task, std::vector<Fault>> parse_task(std::string_view text);
tl::expected<Task, std::vector<Fault>> read_task(const std::filesystem::path& file);

/// `read`, where a problem of kind `Wanted` is: that a sound file is of another kind is a
/// fault at its `kind`.
template <class Wanted>
tl::expected<Wanted, std::vector<Fault>> only(TaskAt read) {
  if (auto* task = std::get_if<Wanted>(&read.task)) return std::move(*task);
  const auto asked =
      std::visit([]<class Kind>(const Kind&) { return KindTraits<Kind>::kWord; }, read.task);
  const auto quoted = [](std::string_view word) { return '"' + std::string(word) + '"'; };
  const auto wanted = KindTraits<Wanted>::kWord;
  return tl::unexpected(std::vector<Fault>{
      {read.line, read.column,
       asked == wanted ? "kind is " + quoted(asked) +
                             " of another mechanism; expected another "
                             "mechanism.type"
                       : "kind is " + quoted(asked) + "; expected kind = " + quoted(wanted)}});
}

/// As `parse_task` and `read_task`, where a problem of one kind is requested.
template <class Wanted>
tl::expected<Wanted, std::vector<Fault>> parse_task(std::string_view text) {
  return parse_task_at(text).and_then(only<Wanted>);
}
/// As `read_task`, where a problem of one kind is expected.
template <class Wanted>
tl::expected<Wanted, std::vector<Fault>> read_task(const std::filesystem::path& file) {
  return read_task_at(file).and_then(only<Wanted>);
}

}  // namespace cognate::problems
