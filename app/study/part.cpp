#include "app/study/part.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace cognate::app {
namespace {

constexpr std::int64_t kMostParts = 1'000'000;

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace

tl::expected<StudyPart, std::string> parse_part(std::string_view text) {
  const auto slash = std::min(text.find('/'), text.size());
  const auto number = whole_number(text.substr(0, slash));
  const auto count = whole_number(text.substr(std::min(slash + 1, text.size())));
  if (!number || !count || *number < 1 || *number > *count || *count > kMostParts) {
    return tl::unexpected(
        fmt::format("--part: '{}' is not allowed; expected which part of how many, such as 2/5, of "
                    "at most {}",
                    text, kMostParts));
  }
  return StudyPart{*number, *count};
}

DesignRange designs_of(const StudyPart& part, std::int64_t designs) {
  // number · designs / count without overflow
  const auto end_of = [&](std::int64_t number) {
    return designs / part.count * number + designs % part.count * number / part.count;
  };
  const std::int64_t first = end_of(part.number - 1);
  return {first, end_of(part.number) - first};
}

std::vector<DesignRange> within(const std::vector<DesignRange>& ranges, const DesignRange& part) {
  std::vector<DesignRange> found;
  for (const DesignRange& range : ranges) {
    const auto first = std::max(range.first, part.first);
    const auto end = std::min(range.first + range.count, part.first + part.count);
    if (end > first) found.push_back({first, end - first});
  }
  return found;
}

}  // namespace cognate::app
