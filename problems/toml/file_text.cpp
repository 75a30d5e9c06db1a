#include "problems/toml/file_text.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <vector>

#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {

namespace {

/// Whether what is neither a file nor a directory can be read to an end.
bool is_stream(const std::filesystem::file_status& status) {
  return std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status);
}

/// The problem file in the same folder whose name is nearest to that of `file`; empty where none is
/// near.
std::string similar_file(const std::filesystem::path& file) {
  constexpr int kMost = 10'000;
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  std::vector<std::string> names;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end;
       !error && entry != end && names.size() < kMost; entry.increment(error)) {
    if (entry->path().extension() == ".toml") names.push_back(entry->path().stem().string());
  }
  std::ranges::sort(names);
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto meant = nearest(file.stem().string(), known);
  const bool is_other = meant && file.extension() == ".toml" && file.stem() != *meant;
  return is_other ? (file.parent_path() / *meant).string() + ".toml" : "";
}

}  // namespace

tl::expected<std::string, std::string> text_of(const std::filesystem::path& file,
                                               NamedBy named_by) {
  const auto refusal = [](const char* message) { return tl::unexpected(std::string(message)); };
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    auto named = file;
    named += ".toml";
    if (std::filesystem::is_regular_file(named, error)) {
      return tl::unexpected("the file does not exist; " + named.string() +
                            " is there and may be meant");
    }
    if (const auto meant = similar_file(file); !meant.empty()) {
      return tl::unexpected("the file does not exist; did you mean " + meant + "?");
    }
    return refusal(
        "the file does not exist or cannot be reached; expected the path of a problem file");
  }
  if (std::filesystem::is_directory(status)) {
    return refusal("this is a directory; expected the path of a problem file");
  }
  const bool may_stream = named_by == NamedBy::command_line && is_stream(status);
  if (!std::filesystem::is_regular_file(status) && !may_stream) {
    return refusal("this is a pipe, a device or a socket; expected a regular file");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return refusal("the file cannot be opened; expected a file that can be read");
  // One byte more than allowed is enough to refuse, however large the file: a pipe has no size.
  std::string text;
  std::array<char, 1 << 16> part{};
  while (text.size() <= kMostBytes && stream) {
    stream.read(part.data(), part.size());
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return refusal("the file cannot be read to its end; expected a whole file");
  if (text.size() > kMostBytes) {
    return refusal("the file is larger than 8 MiB; at most 8 MiB are allowed");
  }
  return text;
}

}  // namespace cognate::problems::reading
