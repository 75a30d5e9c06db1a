#include "app/documents/output_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>

namespace cognate::app::output_files_test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A folder of each test's own, removed at its end.
class OutputFiles : public ::testing::Test {
 protected:
  OutputFiles() {
    std::string name = (fs::temp_directory_path() / "cognate-test-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~OutputFiles() override { fs::remove_all(folder_); }

  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

TEST_F(OutputFiles, ReplacesAFileAndLeavesNothingElse) {
  const std::string text(100000, 'x');
  ASSERT_TRUE(write_file(folder_ / "a.json", "first").has_value());
  ASSERT_TRUE(write_file(folder_ / "a.json", text).has_value());
  EXPECT_EQ(text_of(folder_ / "a.json"), text);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFiles, PreparesFoldersWithoutLeavingATrace) {
  ASSERT_TRUE(prepare_folder(folder_ / "new" / "newer", {"a.json"}).has_value());
  EXPECT_TRUE(fs::is_empty(folder_ / "new" / "newer"));
}

TEST_F(OutputFiles, RefusesAFolderBelowAFile) {
  ASSERT_TRUE(write_file(folder_ / "file", "x").has_value());
  const auto prepared = prepare_folder(folder_ / "file" / "below", {"a.json"});
  ASSERT_FALSE(prepared.has_value());
  EXPECT_EQ(prepared.error(), "cannot make the folder '" + (folder_ / "file" / "below").string() +
                                  "': Not a directory");
  EXPECT_FALSE(prepare_folder(folder_ / "file", {"a.json"}).has_value());
}

TEST_F(OutputFiles, RefusesANameThatIsAFolderOrTooLong) {
  fs::create_directory(folder_ / "a.json");
  EXPECT_FALSE(prepare_folder(folder_, {"a.json"}).has_value());
  EXPECT_FALSE(prepare_folder(folder_, {std::string(300, 'n')}).has_value());
  EXPECT_TRUE(prepare_folder(folder_, {"b.json"}).has_value());
}

TEST_F(OutputFiles, AFailedWriteLeavesTheFolderAsItWas) {
  fs::create_directory(folder_ / "a.json");
  const auto written = write_file(folder_ / "a.json", "text");
  ASSERT_FALSE(written.has_value());
  EXPECT_NE(written.error().find("a.json"), std::string::npos);
  EXPECT_EQ(entries(), 1u);
}

}  // namespace
}  // namespace cognate::app::output_files_test
