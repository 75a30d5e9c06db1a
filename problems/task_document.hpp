/// @file The task of a document, apart from the text in which it is written.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "problems/read.hpp"
#include "problems/toml/document.hpp"

namespace cognate::problems::reading {

inline constexpr std::string_view kKind = "kind";
inline constexpr std::string_view kLengthUnit = "length_unit";
inline constexpr std::string_view kStudyKind = "study";

/// The document in `text`, which is small enough, is text and is not blank; else why not.
tl::expected<Table, std::vector<Fault>> read_text(std::string_view text);

/// The document of a file, and where files that it names are looked for.
struct Source {
  Table document;
  std::filesystem::path folder;
};

/// The same of `file`, if it can be read.
tl::expected<Source, std::vector<Fault>> read_source(const std::filesystem::path& file);

/// The task of `document`, or every fault found in it. Files that it names are looked for in
/// `folder`; there are none where that is empty.
tl::expected<TaskAt, std::vector<Fault>> read_task(const Table& document,
                                                   const std::filesystem::path& folder);

/// `document` with `length_unit` where it has none, or the fault that it has another one.
tl::expected<Table, std::vector<Fault>> with_length_unit(Table document,
                                                         std::optional<LengthUnit> length_unit);

/// Whether `document` is a study: `kind = "study"`, or no kind and a `base`.
bool is_study(const Table& document);

}  // namespace cognate::problems::reading
