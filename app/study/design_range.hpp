/// @file Some designs of a study, by their numbers.
#pragma once

#include <cstdint>

namespace cognate::app {

/// The designs `first` … `first + count − 1`.
struct DesignRange {
  std::int64_t first = 0;
  std::int64_t count = 0;
  bool operator==(const DesignRange&) const = default;
};

}  // namespace cognate::app
