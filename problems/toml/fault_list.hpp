/// @file Where faults of a file are collected while it is read.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "problems/toml/fault.hpp"

namespace cognate::problems::reading {

/// A position in a file. Lines and columns count from 1, columns in characters (code points).
struct Where {
  std::size_t line = 1;
  std::size_t column = 1;

  auto operator<=>(const Where&) const = default;
};

/// The faults found so far, in the order of their finding.
class FaultList {
 public:
  /// `message`: what is wrong; what is allowed.
  void add(Where where, std::string message);

  bool empty() const { return faults_.empty(); }
  std::size_t size() const { return faults_.size(); }

  /// The faults in the order of the file, the first `kMost` of them.
  std::vector<Fault> sorted() &&;

  /// No more faults than this are reported, and no more of one array are collected.
  static constexpr std::size_t kMost = 100;

 private:
  std::vector<Fault> faults_;
};

}  // namespace cognate::problems::reading
