/// @file What the kernel of the pages leaves out of machines: that a problem is sound, which its
/// reader has just seen, other files, as results hold the trains of motors by their tables, and the
/// reader of functions that are designed, but for its words.
#include <fmt/core.h>

#include <cmath>

#include "problems/function/read_target.hpp"
#include "problems/machine/problem.hpp"
#include "problems/toml/file_text.hpp"
#include "problems/toml/text_check.hpp"
#include "problems/train/problem.hpp"

namespace cognate::problems {

std::string reading::value_in_words(double value) {
  return std::isnan(value) ? "not a number (NaN)" : fmt::format("{}", value);
}

tl::expected<MachineProblem, std::vector<std::string>> KindTraits<MachineProblem>::checked(
    const MachineProblem& problem) {
  return problem;
}

tl::expected<std::string, std::string> reading::text_of(const std::filesystem::path& /*file*/,
                                                        NamedBy /*named_by*/) {
  return tl::unexpected(std::string("a page reads no files"));
}

std::optional<Fault> reading::check_is_text(std::string_view /*text*/) {
  return std::nullopt;
}

std::optional<Fault> reading::check_key_depth(std::string_view /*text*/) {
  return std::nullopt;
}

tl::expected<reading::Table, Fault> reading::parse_document(std::string_view /*text*/) {
  return Table{};
}

}  // namespace cognate::problems
