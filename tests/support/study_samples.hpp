/// @file Studies whose rows are known without the program: a made-up function of the design's
/// number takes the place of mechanisms.
#pragma once

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

#include "problems/study/block.hpp"
#include "problems/study/study.hpp"

namespace cognate::tests {

/// A folder of its own, removed at the end.
class TestFolder {
 public:
  TestFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "cognate-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  ~TestFolder() { std::filesystem::remove_all(path_); }
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// `designs` values of one key; the metrics "a.first", "second" and the word "class".
inline problems::Study sample_study(std::int64_t designs,
                                    std::vector<problems::StudyObjective> objectives = {}) {
  problems::Study study{.title = "Sample", .base = "base.toml", .base_text = "crank = 1\n"};
  problems::StudyVariable variable{.key = "mechanism.crank", .path = {"mechanism", "crank"}};
  for (std::int64_t i = 0; i < designs; ++i) variable.values.push_back(static_cast<double>(i));
  study.variables.push_back(std::move(variable));
  study.metrics = {"a.first", "second", "class"};
  study.objectives = std::move(objectives);
  return study;
}

/// In [0, 1), scattered, the same everywhere.
inline double scattered(std::int64_t id, std::uint64_t salt) {
  std::uint64_t x = static_cast<std::uint64_t>(id) * 0x9E3779B97F4A7C15U + salt;
  x ^= x >> 31U;
  x *= 0xBF58476D1CE4E5B9U;
  x ^= x >> 29U;
  return static_cast<double>(x >> 11U) * 0x1p-53;
}

/// The rows of `sample_study`: every seventh design is filtered and not kept, every fifth of the
/// others has no "second".
inline problems::StudyBlock sample_block(std::int64_t first, std::int64_t count) {
  problems::StudyBlock block{.first = first, .count = count};
  for (std::int64_t id = first; id < first + count; ++id) {
    if (id % 7 == 0) {
      ++block.filtered;
      continue;
    }
    block.ids.push_back(id);
    block.statuses.push_back(id % 11 == 0 ? problems::RunStatus::infeasible
                                          : problems::RunStatus::solved);
    block.cells.emplace_back(static_cast<double>(id));
    block.cells.emplace_back(scattered(id, 1));
    block.cells.emplace_back();
    if (id % 5 != 0) block.cells.back() = scattered(id, 2);
    block.cells.emplace_back(std::string(id % 2 == 0 ? "even" : "odd"));
  }
  return block;
}

}  // namespace cognate::tests
