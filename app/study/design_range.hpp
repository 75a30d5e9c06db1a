/// @file Some designs of a study, by their numbers.
#pragma once

#include <cstdint>
#include <limits>

namespace cognate::app {

/// The designs `first` … `first + count − 1`.
struct DesignRange {
  std::int64_t first = 0;
  std::int64_t count = 0;
  bool operator==(const DesignRange&) const = default;
};

/// Of any study.
inline constexpr DesignRange kAllDesigns{0, std::numeric_limits<std::int64_t>::max()};

}  // namespace cognate::app
