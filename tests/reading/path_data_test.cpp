// SVG path data: lengths in closed form, the same figure by other commands, and what is no path.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/path/curve/outline.hpp"
#include "problems/path/curve/svg_path_data.hpp"

namespace cognate::problems::reading::path_data_test {
namespace {

double length_of(const std::string& path_data) {
  const auto curve = closed_outline(path_data);
  if (!curve) ADD_FAILURE() << path_data << ": " << curve.error().message;
  return curve ? curve->length() : 0;
}

TEST(PathData, TheLengthOfACircleByArcs) {
  const std::string circle = "M 10 0 A 10 10 0 0 1 -10 0 A 10 10 0 0 1 10 0 Z";
  EXPECT_NEAR(length_of(circle) / (20 * kPi), 1, 1e-6);
}

TEST(PathData, TheLengthOfAParabolaByAQuadraticCurve) {
  // y = x² from -1 to 1, and the chord back.
  const double parabola = std::sqrt(5) + std::asinh(2) / 2;
  EXPECT_NEAR(length_of("M -1 1 Q 0 -1 1 1 Z"), parabola + 2, 1e-6);
}

TEST(PathData, TheLengthOfACubicCurveThatIsACuspidalOne) {
  // x = t², y = t³ for t from 0 to 1: ((4 + 9)^1.5 - 8) / 27. Back by two lines.
  EXPECT_NEAR(length_of("M 0 0 C 0 0 .333333333333333333 0 1 1 H 0 Z"),
              (std::pow(13, 1.5) - 8) / 27 + 2, 1e-6);
}

TEST(PathData, YIsTurnedUpwards) {
  const auto curve = closed_outline("M 0 0 L 4 0 L 0 3 Z");
  ASSERT_TRUE(curve);
  EXPECT_EQ(curve->vertices()[2], (Vec2d{0, -3}));
}

// Each arc from (x, y) to (x', y') runs on the turned ellipse, by the longer or shorter way and in
// the sense requested.
TEST(PathData, ArcsKeepToTheirEllipseWayAndSense) {
  for (const bool large : {false, true}) {
    for (const bool positive : {false, true}) {
      const std::string flags = std::to_string(int(large)) + std::to_string(int(positive));
      const auto paths = parse_path_data("M 1 2 A 5 3 30 " + flags + "4 4");
      ASSERT_TRUE(paths) << flags;
      const PathSegment& arc = paths->front().segments.front();
      const Vec2d axis{std::cos(kPi / 6), std::sin(kPi / 6)};
      double area = 0, way = 0;
      for (int i = 0; i <= 100; ++i) {
        const Vec2d p = conj(axis) * (arc.at(i / 100.0) - arc.centre);
        EXPECT_NEAR(p.x * p.x / 25 + p.y * p.y / 9, 1, 1e-12);
        if (i == 0) continue;
        const Vec2d before = arc.at((i - 1) / 100.0);
        area += cross(before - arc.centre, arc.at(i / 100.0) - arc.centre);
        way += norm(arc.at(i / 100.0) - before);
      }
      EXPECT_NEAR(norm(arc.at(0) - Vec2d{1, 2}), 0, 1e-12);
      EXPECT_NEAR(norm(arc.at(1) - Vec2d{4, 4}), 0, 1e-12);
      EXPECT_EQ(area > 0, positive) << flags;
      const double half_round = 12.763;  // half the circumference of the ellipse
      EXPECT_EQ(way > half_round, large) << flags;
    }
  }
}

TEST(PathData, RadiiTooShortAreEnlargedAndNoneMakeALine) {
  EXPECT_NEAR(length_of("M 0 0 A 1 1 0 0 1 10 0 Z"), 5 * kPi + 10, 1e-5);
  EXPECT_NEAR(length_of("M 0 0 A 0 1 0 0 1 3 0 L 3 4 Z"), 12, 1e-12);
}

struct Same {
  const char *one, *other;
};

TEST(PathData, CommandsThatSayTheSameDrawTheSame) {
  const Same same_texts[] = {
      {"M1 2 3 4 5 7Z", "M 1 2 L 3 4 L 5 7 Z"},
      {"m1 2 3 4 5 7z", "M 1,2 L 4,6 L 9,13 Z"},
      {"M1 2H5V9h-4z", "M1 2L5 2L5 9L1 9z"},
      {"M0 0v3h2z", "M0 0L0 3L2 3z"},
      {"M0 0c1 2 3 4 5 0s3 4 5 0z", "M0 0C1 2 3 4 5 0C7 -4 8 4 10 0z"},
      {"M0 0S3 4 5 0z", "M0 0C0 0 3 4 5 0z"},
      {"M0 0q1 2 3 0t3 0z", "M0 0Q1 2 3 0Q5 -2 6 0z"},
      {"M0 0L3 0T5 5z", "M0 0L3 0Q3 0 5 5z"},
      {"M0 0a5 3 30 114 4z", "M0,0 A5,3,30,1,1,4,4 Z"},
      {"M-1-2.5.5e1+3z", "M -1 -2.5 L 5 3 Z"},
      {"M1 1m2 2l3 0 0 3zm5 5", "M3 3L6 3L6 6z"},
  };
  for (const Same& same : same_texts) {
    const auto one = parse_path_data(same.one), other = parse_path_data(same.other);
    ASSERT_TRUE(one && other) << same.one;
    ASSERT_EQ(one->size(), 1U) << same.one;
    ASSERT_EQ(other->size(), 1U) << same.other;
    const auto &a = one->front().segments, &b = other->front().segments;
    ASSERT_EQ(a.size(), b.size()) << same.one;
    EXPECT_EQ(one->front().closed, other->front().closed) << same.one;
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (const double t : {0.0, 0.3, 0.8, 1.0}) {
        EXPECT_NEAR(norm(a[i].at(t) - b[i].at(t)), 0, 1e-14) << same.one << " piece " << i;
      }
    }
  }
}

struct Bad {
  const char* text;
  std::size_t offset;
  const char* says;
};

TEST(PathData, WhatIsNoClosedCurveIsReportedAtItsPlace) {
  const Bad bad_texts[] = {
      {"", 0, "draws nothing"},
      {"M 0 0", 0, "draws nothing"},
      {"L 0 0", 0, "begin with a move"},
      {"M 0 0 B 1 1", 6, "no command"},
      {"M 0 0 L 1", 9, "no number here; L takes two"},
      {"M 0 0 C 1 1 2 2 3", 17, "no number"},
      {"M 0 0 L 1 inf", 10, "no number"},
      {"M 0 0 L 1 nan", 10, "no number"},
      {"M 0 0 L 1 1e999", 10, "beyond bounds"},
      {"M 0 0 L 1 1e101", 10, "beyond bounds"},
      {"M 0 0 A 1 1 0 2 0 3 3 Z", 14, "no flag"},
      {"M 0 0 L 1 1 0 1", 15, "ends 1 from its beginning"},
      {"M 0 0 L 1 0 0 1 Z M 5 5 L 6 5 5 6 Z", 0, "draws 2 curves"},
      {"M 0 0 L 1 0 0 1 Z L 6 5 5 6 Z", 0, "draws 2 curves"},
      {"M 0 0 L 1 0 Z", 0, "fewer than 3 different points"},
      {"M 0 0 L 0 0 0 0 Z", 0, "fewer than 3 different points"},
      {"M 1e12 0 l 1 0 0 1 Z", 0, "is 1 wide at a distance of up to 1000000000001"},
      {"M 0 0 L 1 0 0 1 Z 5", 18, "no command"},
  };
  for (const Bad& bad : bad_texts) {
    const auto curve = closed_outline(bad.text);
    ASSERT_FALSE(curve) << bad.text;
    EXPECT_EQ(curve.error().offset, bad.offset) << bad.text << ": " << curve.error().message;
    EXPECT_NE(curve.error().message.find(bad.says), std::string::npos)
        << bad.text << ": " << curve.error().message;
    EXPECT_NE(curve.error().message.find("; "), std::string::npos) << curve.error().message;
  }
}

// Characters of a sound text exchanged, dropped and doubled at random.
TEST(PathData, EveryTextIsACurveOrAFault) {
  const std::string sound =
      "M 1e1 2 h-3.5 V.5 c1 2 3 4 5 0S3 4 5 0q1 2 3 0 T 9,9 a5 3 30 1 1 4 4 l 7 7 Z";
  const std::string characters = "MmZzLlHhVvCcSsQqTtAa0123456789.-+eE, \n;x";
  std::mt19937_64 random(11);
  int curves = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::string text = sound;
    for (std::uint64_t change = 1 + random() % 3; change > 0; --change) {
      const std::size_t at = random() % text.size();
      const std::size_t kind = random() % 3;
      if (kind == 0) text[at] = characters[random() % characters.size()];
      if (kind == 1) text.erase(at, 1);
      if (kind == 2) text.insert(at, 1, text[at]);
    }
    const auto curve = closed_outline(text);
    if (curve) {
      EXPECT_TRUE(std::isfinite(curve->length()) && curve->length() > 0) << text;
      ++curves;
    } else {
      EXPECT_LE(curve.error().offset, text.size()) << text;
      EXPECT_NE(curve.error().message.find("; "), std::string::npos) << curve.error().message;
    }
  }
  EXPECT_GT(curves, 100);
  EXPECT_LT(curves, 1900);
}

TEST(PathData, SegmentsAreLimited) {
  std::string many = "M 0 0 L";
  for (int i = 0; i <= 20'000; ++i) many += " 1 " + std::to_string(i);
  const auto paths = parse_path_data(many);
  ASSERT_FALSE(paths);
  EXPECT_NE(paths.error().message.find("20000 segments"), std::string::npos);
}

TEST(PathData, AnEndThatMeetsItsBeginningClosesIt) {
  EXPECT_NEAR(length_of("M 0 0 L 3 0 L 3 4 L 0 0"), 12, 1e-12);
  EXPECT_NEAR(length_of("M 0 0 L 3 0 L 3 4 L 0.000001 0"), 12, 1e-5);
}

}  // namespace
}  // namespace cognate::problems::reading::path_data_test
