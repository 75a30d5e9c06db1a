#include "app/study/merge.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "app/study/design_range.hpp"
#include "app/study/read_columns.hpp"

namespace cognate::app {
namespace {

namespace fs = std::filesystem;

/// Whether a block lies in one of the ascending `gaps`.
bool is_missing(const std::vector<DesignRange>& gaps, const problems::StudyBlock& block) {
  return std::ranges::any_of(gaps, [&](const DesignRange& gap) {
    return block.first >= gap.first && block.first + block.count <= gap.first + gap.count;
  });
}

}  // namespace

OtherStudyFile::OtherStudyFile(const fs::path& file, const fs::path& own,
                               const problems::Study& study, const StudyOrigin& origin) {
  std::error_code error;
  const auto target = final_target(file);
  if (!fs::is_regular_file(target, error)) {
    throw StudyFileError(fmt::format("--merge: '{}' is no file", file.string()));
  }
  if (fs::equivalent(target, own, error)) {
    throw StudyFileError(
        fmt::format("--merge: '{}' is the file of this run; name others", file.string()));
  }
  if (fs::file_size(target, error) == 0) {
    throw StudyFileError(fmt::format("--merge: '{}' is empty", file.string()));
  }
  // Columns are written whole, and no run goes on with them.
  if (!is_columns_file(target)) {
    auto lock = StudyLock::take(lock_file(target));
    if (!lock) throw StudyFileError(lock.error());
    lock_.emplace(*std::move(lock));
  }
  database_.emplace(target, study, origin, SqliteDatabase::Access::read);
}

std::int64_t OtherStudyFile::store_in(StudyDatabase& own, const std::atomic<bool>& stopped,
                                      const std::function<void()>& progress) {
  const auto gaps = own.missing();
  std::int64_t stored = 0;
  database_->for_each_block([&](const problems::StudyBlock& block) {
    if (is_missing(gaps, block)) {
      own.store(block);
      own.tick();
      stored += block.count;
      progress();
    }
    return !stopped;
  });
  own.commit();
  return stored;
}

}  // namespace cognate::app
