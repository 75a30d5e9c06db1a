// Files that are no problem files, and texts made to exhaust a parser.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "problems/read.hpp"

namespace cognate::problems::read_files_test {
namespace {

class ReadFilesTest : public ::testing::Test {
 protected:
  ReadFilesTest()
      : folder_(std::filesystem::temp_directory_path() /
                ("cognate_read_files_" + std::to_string(getpid()))) {
    std::filesystem::create_directory(folder_);
  }
  ~ReadFilesTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& text) const {
    const auto file = folder_ / "problem.toml";
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  std::filesystem::path folder_;
};

// The one fault of `result` and that it stands at 1:1.
std::string only_fault(const tl::expected<Task, std::vector<Fault>>& result) {
  EXPECT_FALSE(result);
  if (result || result.error().size() != 1) return "not one fault";
  EXPECT_EQ(result.error()[0].line, 1U);
  EXPECT_EQ(result.error()[0].column, 1U);
  return result.error()[0].message;
}

const std::string kLine = "kind = \"path-generation\"\n[target]\npoints = [[0,0],[1,0],[1,1]]\n";

TEST_F(ReadFilesTest, ReadsAFile) {
  EXPECT_TRUE(read_task(write(kLine)));
}

TEST_F(ReadFilesTest, ReadsWindowsText) {
  std::string text = "\xef\xbb\xbf" + kLine;
  for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 2)) {
    text.insert(i, 1, '\r');
  }
  EXPECT_TRUE(read_task(write(text)));
}

TEST_F(ReadFilesTest, Missing) {
  EXPECT_NE(only_fault(read_task(folder_ / "none.toml")).find("does not exist"), std::string::npos);
}

TEST_F(ReadFilesTest, Directory) {
  EXPECT_NE(only_fault(read_task(folder_)).find("is a directory"), std::string::npos);
}

TEST_F(ReadFilesTest, HundredMegabytes) {
  const auto file = write("");
  std::filesystem::resize_file(file, 100'000'000);  // sparse: takes no room on the disk
  EXPECT_NE(only_fault(read_task(file)).find("larger than 8 MiB"), std::string::npos);
}

TEST_F(ReadFilesTest, EndlessDevice) {
  if (!std::filesystem::exists("/dev/zero")) GTEST_SKIP() << "no such device here";
  EXPECT_NE(only_fault(read_task("/dev/zero")).find("larger than 8 MiB"), std::string::npos);
}

TEST_F(ReadFilesTest, EightMebibytesAreRead) {
  const std::string text = kLine + std::string((8U << 20U) - kLine.size(), '\n');
  EXPECT_TRUE(parse_task(text));
  EXPECT_FALSE(parse_task(text + "\n"));
}

std::string repeated(const std::string& part, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += part;
  return text;
}

TEST(ReadDeepTextTest, NestingEndsInAMessage) {
  const int deep = 500'000;
  for (const std::string& text :
       {"a = " + repeated("[", deep), "a = " + repeated("{a = ", deep),
        repeated("a.", deep) + "a = 1", "[" + repeated("a.", deep) + "a]",
        "a = " + repeated("{a.b.c.d.e.f.g.h.i.j.k = ", 10'000),
        "a = " + repeated("[", 256) + repeated("]", 256), "a = \"" + repeated("\\\"", deep)}) {
    const auto problem = parse_task(text);
    ASSERT_FALSE(problem);
    EXPECT_FALSE(problem.error().empty());
  }
}

TEST(ReadDeepTextTest, AtMostAHundredFaultsInOrder) {
  std::string points;
  for (int i = 0; i < 5000; ++i) points += "\"a\",\n";
  std::string keys;
  for (int i = 0; i < 5000; ++i) keys += "key" + std::to_string(i) + " = 1\n";
  const auto problem =
      parse_task("kind = \"path-generation\"\n" + keys + "[target]\npoints = [" + points + "]\n");
  ASSERT_FALSE(problem);
  ASSERT_EQ(problem.error().size(), 100U);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(problem.error()[i].line, i + 2);
}

TEST(ReadDeepTextTest, TooManyPointsAreOneFault) {
  const auto problem = parse_task("kind = \"path-generation\"\n[target]\npoints = [" +
                                  repeated("[0, 1],", 10'001) + "]\n");
  ASSERT_FALSE(problem);
  ASSERT_EQ(problem.error().size(), 1U);
  EXPECT_NE(problem.error()[0].message.find("10001 points; expected 3 to 10000"),
            std::string::npos);
}

}  // namespace
}  // namespace cognate::problems::read_files_test
