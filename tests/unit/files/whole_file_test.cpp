/// What is asked of the system when a file is replaced, in which order, and what is left where one
/// of these calls fails. The calls are caught by functions of this program with the names of those
/// of the C library, which they call.
#include "synthesis/whole_file.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "synthesis/exact/nine_point/number_file.hpp"

namespace {

namespace fs = std::filesystem;

enum class Call { sync_file, sync_folder, rename };

struct Caught {
  Call call;
  std::string name;     // of a rename: the new one
  std::string content;  // of the file at this moment
};

std::vector<Caught> caught;
int failing = -1;  // the number of the call that fails
int error_of_failing = EIO;
int raised = 0;  // a signal sent at each call
volatile std::sig_atomic_t heard = 0;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Notes a call; whether it is to fail.
bool fails(Call call, const fs::path& file, const fs::path& content) {
  caught.push_back({call, file.filename().string(),
                    call == Call::sync_folder ? std::string() : text_of(content)});
  if (raised != 0) {
    ::raise(raised);
    EXPECT_EQ(heard, 0);
  }
  if (failing != static_cast<int>(caught.size()) - 1) return false;
  errno = error_of_failing;
  return true;
}

template <class Function>
Function* of_the_system(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" int fsync(int descriptor) {
  const fs::path file = fs::read_symlink("/proc/self/fd/" + std::to_string(descriptor));
  const auto call = fs::is_directory(file) ? Call::sync_folder : Call::sync_file;
  return fails(call, file, file) ? -1 : of_the_system<int(int)>("fsync")(descriptor);
}

extern "C" int rename(const char* from, const char* to) noexcept {
  if (fails(Call::rename, to, from)) return -1;
  return of_the_system<int(const char*, const char*)>("rename")(from, to);
}

namespace cognate::whole_file_test {
namespace {

class WholeFile : public ::testing::Test {
 protected:
  WholeFile() {
    std::string name = (fs::temp_directory_path() / "cognate-test-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    file_ = folder_ / "a.json";
    std::ofstream(file_) << "old";
    caught.clear();
    failing = -1;
    error_of_failing = EIO;
  }
  ~WholeFile() override { fs::remove_all(folder_); }

  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  /// That the bytes were on the disk before they had the name, and the name before the end.
  void expect_order(const std::string& bytes) const {
    ASSERT_EQ(caught.size(), 3u);
    EXPECT_EQ(caught[0].call, Call::sync_file);
    EXPECT_NE(caught[0].name, file_.filename());
    EXPECT_EQ(caught[0].content, bytes);
    EXPECT_EQ(caught[1].call, Call::rename);
    EXPECT_EQ(caught[1].name, file_.filename());
    EXPECT_EQ(caught[1].content, bytes);
    EXPECT_EQ(caught[2].call, Call::sync_folder);
    EXPECT_EQ(caught[2].name, folder_.filename());
  }

  fs::path folder_, file_;
};

TEST_F(WholeFile, IsOnTheDiskBeforeItHasItsName) {
  const std::string bytes(300'000, 'x');
  ASSERT_EQ(write_whole_file(file_, bytes), 0);
  expect_order(bytes);
  EXPECT_EQ(text_of(file_), bytes);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WholeFile, OfNumbersIsSyncedToo) {
  const synthesis::nine_point::FileKey key{1, 2, 3};
  const std::vector<double> numbers{0.5, -3, 1e300};
  ASSERT_TRUE(synthesis::nine_point::write_numbers(file_, key, numbers));
  expect_order(text_of(file_));
  EXPECT_EQ(synthesis::nine_point::read_numbers(file_, key, 3), numbers);
}

TEST_F(WholeFile, IsTheOldOneWhereTheDiskOrTheNameFails) {
  int tested = 0;
  for (const int error : {EIO, ENOSPC, EDQUOT}) {
    for (failing = 0; failing < 2; ++failing) {
      caught.clear();
      error_of_failing = error;
      EXPECT_EQ(write_whole_file(file_, "new"), error);
      EXPECT_EQ(caught.size(), static_cast<std::size_t>(failing + 1));
      EXPECT_EQ(text_of(file_), "old");
      EXPECT_EQ(entries(), 1u);
      ++tested;
    }
  }
  EXPECT_EQ(tested, 6);
}

TEST_F(WholeFile, SaysWhenItsNameMayBeLostAgain) {
  failing = 2;
  error_of_failing = EIO;
  EXPECT_EQ(write_whole_file(file_, "new"), EIO);
  EXPECT_EQ(text_of(file_), "new");
  // A file system that cannot sync folders has nothing to sync.
  caught.clear();
  error_of_failing = EINVAL;
  EXPECT_EQ(write_whole_file(file_, "newer"), 0);
  EXPECT_EQ(caught.size(), 3u);
}

TEST_F(WholeFile, SignalsWaitUntilItIsWhole) {
  int tested = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto before = std::signal(signal, [](int) { heard = heard + 1; });
    for (const int failure : {-1, 0, 1}) {
      raised = signal;
      failing = failure;
      heard = 0;
      caught.clear();
      EXPECT_EQ(write_whole_file(file_, "new"), failure == -1 ? 0 : EIO);
      EXPECT_EQ(heard, 1);
      EXPECT_EQ(entries(), 1u);
      ++tested;
    }
    std::signal(signal, before);
  }
  raised = 0;
  EXPECT_EQ(tested, 9);
}

TEST_F(WholeFile, HasThePermissionsOfAnyNewFile) {
  std::ofstream(folder_ / "plain") << "x";
  ASSERT_EQ(write_whole_file(file_, "new"), 0);
  EXPECT_EQ(fs::status(file_).permissions(), fs::status(folder_ / "plain").permissions());
}

TEST_F(WholeFile, TryingAFolderLeavesItAsItWas) {
  EXPECT_EQ(try_to_write_in(folder_), 0);
  EXPECT_EQ(try_to_write_in(file_), ENOTDIR);
  EXPECT_EQ(try_to_write_in(folder_ / "none"), ENOENT);
  EXPECT_EQ(entries(), 1u);
}

}  // namespace
}  // namespace cognate::whole_file_test
