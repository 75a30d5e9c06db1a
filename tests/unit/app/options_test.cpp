#include "app/console/options.hpp"

#include <gtest/gtest.h>

#include <string>

namespace cognate::app::options_test {
namespace {

TEST(Options, TakeWhatIsAllowed) {
  EXPECT_EQ(parse_seed("0"), 0u);
  EXPECT_EQ(parse_seed("9007199254740991"), 9007199254740991u);
  EXPECT_EQ(parse_threads("1"), 1);
  EXPECT_EQ(parse_threads("1024"), 1024);
  EXPECT_EQ(parse_time_limit("0.25"), 0.25);
  EXPECT_EQ(parse_time_limit("1e9"), 1e9);
  EXPECT_EQ(parse_folder("a/b"), std::filesystem::path("a/b"));
}

TEST(Options, RefuseTheRestAndSayWhatIsAllowed) {
  for (const std::string text : {"", "-1", "1.5", "x", "1 ", " 1", "+1", "9007199254740992",
                                 "99999999999999999999999", "0x10", "nan"}) {
    ASSERT_FALSE(parse_seed(text).has_value()) << text;
    EXPECT_EQ(parse_seed(text).error(), "--seed: '" + text +
                                            "' is not possible; allowed is a whole number from 0 "
                                            "to 9007199254740991");
  }
  for (const char* text : {"", "0", "-1", "1025", "99999999999", "2.0", "two"}) {
    EXPECT_FALSE(parse_threads(text).has_value()) << text;
  }
  for (const char* text : {"", "0", "-0", "-1", "nan", "inf", "1e10", "1e999", "1s", "1e-999"}) {
    EXPECT_FALSE(parse_time_limit(text).has_value()) << text;
  }
  EXPECT_FALSE(parse_folder("").has_value());
}

}  // namespace
}  // namespace cognate::app::options_test
