#include "app/documents/file_watch.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string_view>

namespace cognate::app::file_watch_test {
namespace {

namespace fs = std::filesystem;

/// A file of each test's own, removed at its end.
class FileWatches : public ::testing::Test {
 protected:
  FileWatches() {
    std::string name = (fs::temp_directory_path() / "cognate-test-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    file_ = folder_ / "a.toml";
    write("first");
  }
  ~FileWatches() override { fs::remove_all(folder_); }

  void write(std::string_view text) const { std::ofstream(file_, std::ios::binary) << text; }

  fs::path folder_, file_;
};

TEST_F(FileWatches, ReportASaveOnceItHasSettled) {
  FileWatch watch(file_);
  EXPECT_FALSE(watch.has_changed());
  write("longer than the first");
  EXPECT_FALSE(watch.has_changed());
  EXPECT_TRUE(watch.has_changed());
  EXPECT_TRUE(watch.is_as_reported());
  EXPECT_FALSE(watch.has_changed());
}

// Programs that save in place empty the file first.
TEST_F(FileWatches, KnowThatAReportedSaveIsBeingWrittenOver) {
  FileWatch watch(file_);
  write("longer than the first");
  watch.has_changed();
  ASSERT_TRUE(watch.has_changed());
  fs::resize_file(file_, 0);
  EXPECT_FALSE(watch.is_as_reported());
  write("and longer than that again");
  EXPECT_FALSE(watch.has_changed());
  EXPECT_TRUE(watch.has_changed());
}

TEST_F(FileWatches, ReportAFileThatWasTakenAwayOnlyWhenAnotherTakesItsName) {
  FileWatch watch(file_);
  fs::remove(file_);
  EXPECT_FALSE(watch.has_changed());
  EXPECT_FALSE(watch.has_changed());
  write("put in its place");
  EXPECT_FALSE(watch.has_changed());
  EXPECT_TRUE(watch.has_changed());
}

}  // namespace
}  // namespace cognate::app::file_watch_test
