/// @file Rows of one study that were computed in several places.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "app/study/database.hpp"
#include "app/study/lock.hpp"

namespace cognate::app {

/// Another file of a study, which no other process runs while this is there.
class OtherStudyFile {
 public:
  /// Throws a StudyFileError where `file` is not there, is `own`, is in use, damaged, or of another
  /// study, text, version or seed.
  OtherStudyFile(const std::filesystem::path& file, const std::filesystem::path& own,
                 const problems::Study& study, const StudyOrigin& origin);

  /// Stores in `own` those of its blocks of which no design is there, until `stopped`, and calls
  /// `progress` after each; how many designs these were. Throws as StudyDatabase does.
  std::int64_t store_in(StudyDatabase& own, const std::atomic<bool>& stopped,
                        const std::function<void()>& progress);

  const std::filesystem::path& file() const { return database_->file(); }
  /// As of StudyDatabase.
  std::int64_t unchecked_blocks() const { return database_->unchecked_blocks(); }

 private:
  std::optional<StudyLock> lock_;
  std::optional<StudyDatabase> database_;
};

}  // namespace cognate::app
