/// @file A problem as text: what it asks for, what is wrong with it, its computation.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "app/commands/computation.hpp"
#include "app/console/options.hpp"
#include "problems/study/read.hpp"

namespace cognate::app {

/// The same, or what is wrong with a file that it names.
tl::expected<problems::TaskOrStudy, std::vector<problems::Fault>> with_sound_files(
    problems::TaskOrStudy read);

/// What it asks for, in a line.
std::string description(const problems::TaskOrStudy& read);

/// What `text` asks for, in a line, or every fault in it. Files that it names are looked for in
/// `folder`; it may name none where that is empty.
tl::expected<std::string, std::vector<problems::Fault>> check_text(
    std::string_view text, const std::filesystem::path& folder);

/// What `cognate solve`, or of a mechanism `cognate analyze`, computes of a file with `text`, or
/// every fault in it; `folder` as in `check_text`. A study is a fault: it takes a file.
tl::expected<Computation, std::vector<problems::Fault>> text_computation(
    std::string_view text, const std::filesystem::path& folder, const Options& options);

}  // namespace cognate::app
