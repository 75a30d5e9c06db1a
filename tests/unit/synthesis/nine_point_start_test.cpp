/// Start sets: complete, exact, the same for any number of threads, and kept in files that cannot
/// harm.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <fstream>
#include <thread>

#include "synthesis/exact/nine_point/refine.hpp"
#include "synthesis/exact/nine_point/start_cache.hpp"
#include "synthesis/exact/nine_point/start_set.hpp"

namespace cognate::synthesis::nine_point::nine_point_start_test {
namespace {

bool same_bits(const std::vector<Pair>& a, const std::vector<Pair>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Pair)) == 0;
}

TrackingOptions means_of(int threads, std::optional<InstructionSet> set = {}) {
  TrackingOptions means;
  means.threads = threads;
  means.set = set;
  return means;
}

// Brake et al. (J. Mech. Rob. 8, 2016) count 2224, 402, 60 and 16 solutions, with both orders of
// the dyads; the 16 of five poses include the four of a dyad with itself, which is no linkage.
TEST(NinePointStart, HasTheKnownNumbersOfSolutions) {
  const int raw[] = {0, 0, 2224, 402, 60, 16 - 4};
  for (int poses = 2; poses <= 5; ++poses) {
    const PathClass kind{poses, 10 - 2 * poses};
    const auto set = find_start_set(kind, means_of(2));
    ASSERT_TRUE(set);
    EXPECT_EQ(2 * set->count(), raw[poses]);
    FingerprintIndex index;
    for (int i = 0; i < set->count(); ++i) {
      const Fingerprint print = fingerprint(kind, set->root(i));
      EXPECT_LT(index.find(print, 1e-8), 0) << i;
      index.add(print);
    }
    // Some pivots are far away, and their rounding misses the positions by as much more.
    const auto qualities = measure(set->roots, set->data, means_of(2));
    for (int i = 0; i < set->count(); ++i) {
      double far = 1;
      for (const Pair& z : set->root(i).first(kPivots)) far = std::max(far, std::abs(number(z)));
      EXPECT_LT(qualities[i].residual, 1e-13 * far) << i;
      EXPECT_LT(qualities[i].correction, 1e-11) << i;
    }
  }
}

TEST(NinePointStart, IsTheSameWhateverTheThreads) {
  const auto one = find_start_set({3, 4}, means_of(1)), three = find_start_set({3, 4}, means_of(3));
  ASSERT_TRUE(one && three);
  EXPECT_TRUE(same_bits(one->roots, three->roots));
}

TEST(NinePointStart, IsFoundByEveryInstructionSet) {
  for (const InstructionSet set : instruction_sets()) {
    const auto found = find_start_set({4, 2}, means_of(1, set));
    ASSERT_TRUE(found) << name(set);
    EXPECT_EQ(found->count(), 30) << name(set);
  }
}

TEST(NinePointStart, StopsWhenAsked) {
  int asked = 0;
  const std::function<bool()> ask = [&] { return ++asked > 20; };
  StopToken stop(ask);
  TrackingOptions means = means_of(2);
  means.stop = &stop;
  EXPECT_FALSE(find_start_set({3, 4}, means));
  EXPECT_LT(asked, 40);
}

class StartFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("cognate-start-" + std::to_string(getpid()) + "-" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name());
    file_ = folder_ / "within" / "set";
    set_ = *find_start_set(kKind, means_of(1));
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string bytes() const {
    std::ifstream in(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& bytes) const {
    std::ofstream(file_, std::ios::binary | std::ios::trunc) << bytes;
  }

  static constexpr PathClass kKind{4, 2};
  std::filesystem::path folder_, file_;
  StartSet set_;
};

TEST_F(StartFile, GivesBackWhatWasWritten) {
  ASSERT_TRUE(write_start_set(file_, set_));
  const auto read = read_start_set(file_, kKind);
  ASSERT_TRUE(read);
  EXPECT_TRUE(same_bits(read->roots, set_.roots));
  EXPECT_EQ(read->data.d, set_.data.d);
  EXPECT_EQ(read->data.d_bar, set_.data.d_bar);
  EXPECT_EQ(read->data.t, set_.data.t);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file_.parent_path()), {}), 1);
}

TEST_F(StartFile, IsWholeWhereManyThreadsWriteIt) {
  std::vector<std::thread> threads;
  std::atomic<int> written{0};
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 20; ++k) written += write_start_set(file_, set_);
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(written, 160);
  EXPECT_TRUE(read_start_set(file_, kKind));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file_.parent_path()), {}), 1);
}

TEST_F(StartFile, IsRefusedWhereDamaged) {
  ASSERT_TRUE(write_start_set(file_, set_));
  const std::string whole = bytes();
  for (std::size_t at = 0; at < whole.size(); at += 97) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    write(damaged);
    EXPECT_FALSE(read_start_set(file_, kKind)) << "byte " << at;
  }
  write(whole.substr(0, whole.size() - 1));
  EXPECT_FALSE(read_start_set(file_, kKind));
  write("");
  EXPECT_FALSE(read_start_set(file_, kKind));
  write(whole);
  EXPECT_FALSE(read_start_set(file_, {5, 0})) << "another class";
  EXPECT_TRUE(read_start_set(file_, kKind));
}

TEST_F(StartFile, IsNoConditionForASet) {
  // A file in place of the folder: it can be neither read nor written.
  std::filesystem::create_directories(folder_);
  std::ofstream(folder_ / "within") << "no folder";
  EXPECT_FALSE(write_start_set(file_, set_));
  const auto found = start_set({5, 0}, folder_ / "within", means_of(1));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->count(), 6);
}

TEST_F(StartFile, IsWrittenAndThenRead) {
  // Classes and sets that no other test of this process has requested, so that memory has none.
  const TrackingOptions means = means_of(1, InstructionSet::scalar);
  const auto file = start_file(folder_, kKind, means);
  ASSERT_TRUE(start_set(kKind, folder_, means));
  ASSERT_TRUE(std::filesystem::exists(file));
  EXPECT_TRUE(read_start_set(file, kKind));
}

}  // namespace
}  // namespace cognate::synthesis::nine_point::nine_point_start_test
