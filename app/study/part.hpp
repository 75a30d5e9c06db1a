/// @file A study in parts, each of which one machine evaluates.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "app/study/design_range.hpp"

namespace cognate::app {

/// Part `number` of `count`, from 1, of the designs of a study.
struct StudyPart {
  std::int64_t number = 1, count = 1;
};

/// "2/5": at most a million parts.
tl::expected<StudyPart, std::string> parse_part(std::string_view text);

/// The designs of a part: of equal size but for one, and each design in one of them.
DesignRange designs_of(const StudyPart& part, std::int64_t designs);

/// What of `ranges` is in `part`.
std::vector<DesignRange> within(const std::vector<DesignRange>& ranges, const DesignRange& part);

}  // namespace cognate::app
