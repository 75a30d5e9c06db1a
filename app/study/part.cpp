#include "app/study/part.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "app/console/option_text.hpp"

namespace cognate::app {
namespace {

constexpr std::int64_t kMostParts = 1'000'000;

}  // namespace

tl::expected<StudyPart, std::string> parse_part(std::string_view text) {
  const auto slash = std::min(text.find('/'), text.size());
  const auto number = parse_all<std::int64_t>(text.substr(0, slash));
  const auto count = parse_all<std::int64_t>(text.substr(std::min(slash + 1, text.size())));
  if (!number || !count || *number < 1 || *number > *count || *count > kMostParts) {
    return refusal("--part", text,
                   fmt::format("which part of how many, such as 2/5, of at most {}", kMostParts));
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
