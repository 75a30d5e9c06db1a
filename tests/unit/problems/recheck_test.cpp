// The check of certificates: its intervals hold what they must, and it tells right proofs from
// wrong.
#include "problems/certificate/recheck.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <random>
#include <string>

#include "analysis/linkage/motion.hpp"
#include "problems/certificate/subdivision.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::recheck_test {
namespace {

using synthesis::Interval;
using synthesis::ProportionBox;
using synthesis::Proportions;

PathProblem of_library(const std::string& name) {
  return read_task<PathProblem>(std::filesystem::path(kLibraryFolder) / "path" / name).value();
}

/// Over few links, so that the proof is quickly done.
PathProblem short_links() {
  PathProblem problem = of_library("textbook-eight-points.toml");
  problem.crank_sense = CrankSense::ccw;
  problem.constraints.link_ratio_max = 4;
  return problem;
}

constexpr double kBestOfShortLinks = 0.6010945318;

RecheckOptions options_of(std::size_t sample, std::uint64_t seed, int threads) {
  RecheckOptions options;
  options.sample = sample;
  options.seed = seed;
  options.threads = threads;
  return options;
}

class Boxes {
 public:
  explicit Boxes(int seed) : random_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  ProportionBox box() {
    constexpr std::array kAll{Proportions::crank_shortest, Proportions::frame_shortest,
                              Proportions::any};
    ProportionBox box;
    box.proportions = kAll[std::uniform_int_distribution<std::size_t>(0, 2)(random_)];
    box.assembly = uniform(0, 1) < 0.5 ? 1 : -1;
    const bool any = box.proportions == Proportions::any;
    const double half = std::pow(10.0, uniform(-7, -0.7));
    const std::array<std::array<double, 2>, 4> limits{
        {{box.proportions == Proportions::crank_shortest ? 0.5 : 0.02,
          box.proportions == Proportions::frame_shortest ? 0.5 : 0.98},
         {any ? -1.0 : 0.0, any ? 1.0 : kPi},
         {0.02, any ? 0.6 : kPi / 2},
         {0, kTurn}}};
    for (int i = 0; i < 4; ++i) {
      const auto [low, high] = limits[i];
      const double middle = uniform(0, 1) < 0.1 ? low : uniform(low, high);
      box.side[i] = Interval(std::max(low, middle - half), std::min(high, middle + half));
    }
    return box;
  }

  QuadBox point_in(const QuadBox& box) {
    QuadBox point = box;
    for (QuadInterval& side : point.side) {
      const double share = uniform(0, 1) < 0.2 ? std::round(uniform(0, 1)) : uniform(0, 1);
      side = QuadInterval(side.low + share * (side.high - side.low));
    }
    return point;
  }

 private:
  std::mt19937_64 random_;
};

Quad number(const QuadInterval& value) {
  return value.middle();
}

// Any point of a box has the angle at its middle, and what the slopes add.
TEST(LinkAngles, HoldTheAnglesOfAllLinkagesOfABox) {
  Boxes boxes(1);
  int known = 0;
  double most_used = 0;
  for (int i = 0; i < 400; ++i) {
    const QuadBox box(boxes.box()), middle = box.middle();
    const LinkAngles over(box);
    for (const bool rocker : {false, true}) {
      const CrankAngle crank(Quad(boxes.uniform(0, kTurn)));
      const LinkAngle link = over.at(crank, rocker);
      if (!link.known) continue;
      for (int k = 0; k < 4; ++k) {
        const QuadBox point = boxes.point_in(box);
        const LinkAngle at = LinkAngles(point).at(crank, rocker);
        if (!at.known) continue;
        QuadInterval change;
        Quad radius = 0;
        for (int side = 0; side < 4; ++side) {
          const Quad step = number(point.side[side]) - number(middle.side[side]);
          change += link.slope[side] * QuadInterval(step);
        }
        if (change.magnitude() > 3) continue;
        const QuadComplex turn = conjugate(link.middle) * at.middle;
        const Quad angle = atan2(number(turn.im), number(turn.re));
        ASSERT_GE(angle, change.low - 1e-25) << i;
        ASSERT_LE(angle, change.high + 1e-25) << i;
        radius = (change.high - change.low) / 2;
        if (radius > 0) {
          most_used =
              std::max(most_used, static_cast<double>(abs(angle - change.middle()) / radius));
        }
        ++known;
      }
    }
  }
  EXPECT_GT(known, 1000);
  EXPECT_GT(most_used, 0.3);  // not wider than they need be by far
}

// The kernel's own pose.
TEST(LinkAngles, AreThoseOfTheKernel) {
  Boxes boxes(2);
  int closed = 0;
  for (int i = 0; i < 300; ++i) {
    const QuadBox point = QuadBox(boxes.box()).middle();
    const QuadProportions p(point);
    const double sum = static_cast<double>(1 / number(p.inverse));
    const double difference = static_cast<double>(number(p.difference));
    const double frame = static_cast<double>(number(p.frame)), angle = boxes.uniform(0, kTurn);
    const FourBar linkage{.pivot_a = {0, 0},
                          .pivot_d = {frame, 0},
                          .crank = 1 - frame,
                          .coupler = (sum + difference) / 2,
                          .rocker = (sum - difference) / 2,
                          .assembly = point.assembly > 0 ? Assembly::open : Assembly::crossed,
                          .coupler_point = {}};
    const auto pose = Motion(linkage).at(angle + static_cast<double>(number(point.side[3])));
    const LinkAngle coupler = LinkAngles(point).at(CrankAngle(Quad(angle)), false);
    const LinkAngle rocker = LinkAngles(point).at(CrankAngle(Quad(angle)), true);
    if (!pose || !coupler.known || !rocker.known) continue;
    ++closed;
    const Vec2d along = (1 / linkage.coupler) * (pose->c - pose->b);
    const Vec2d output = (1 / linkage.rocker) * (pose->c - linkage.pivot_d);
    EXPECT_NEAR(along.x, static_cast<double>(number(coupler.middle.re)), 1e-6) << i;
    EXPECT_NEAR(along.y, static_cast<double>(number(coupler.middle.im)), 1e-6) << i;
    EXPECT_NEAR(output.x, static_cast<double>(number(rocker.middle.re)), 1e-6) << i;
    EXPECT_NEAR(output.y, static_cast<double>(number(rocker.middle.im)), 1e-6) << i;
  }
  EXPECT_GT(closed, 150);
}

TEST(BoxForm, IsShownToExceedOnlyWhatItExceeds) {
  Boxes boxes(3);
  int shown = 0;
  for (int i = 0; i < 500; ++i) {
    BoxForm form;
    for (int a = 0; a < 5; ++a) {
      for (int b = 0; b <= a; ++b) {
        form[a][b] = form[b][a] = QuadInterval((a == b ? 1.5 : 0.0) + boxes.uniform(-1, 1));
      }
    }
    double least = kInfinity;
    for (int k = 0; k < 300; ++k) {
      std::array<double, 5> t{1};
      for (int a = 1; a < 5; ++a)
        t[a] = boxes.uniform(0, 1) < 0.5 ? (k >> a & 1 ? 1 : -1) : boxes.uniform(-1, 1);
      double value = 0;
      for (int a = 0; a < 5; ++a) {
        for (int b = 0; b < 5; ++b) value += t[a] * t[b] * static_cast<double>(number(form[a][b]));
      }
      least = std::min(least, value);
    }
    const FormMinimum minimum = form_minimum(form);
    EXPECT_LE(minimum.value, least + 1e-9);
    EXPECT_FALSE(surely_exceeds(form, minimum.multiplier, QuadInterval(least + 1e-6)));
    shown += surely_exceeds(form, minimum.multiplier, QuadInterval(minimum.value - 1e-6));
  }
  EXPECT_GT(shown, 480);
}

// A box about a linkage whose error is known: just above that nothing is shown, and the linkage is
// found; just below, the box that holds it alone is shown.
TEST(PathBoxes, ShowNothingAboveTheErrorOfALinkage) {
  Boxes boxes(4);
  const PathProblem problem = of_library("textbook-eight-points.toml");
  const PathDomain domain = path_domain(problem);
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    ProportionBox box = domain.roots[i % 2];
    for (Interval& side : box.side) side = Interval(boxes.uniform(side.low, side.high));
    const auto best = PathBoxes(problem, false, 1e9).counterexample(QuadBox(box));
    if (!best) continue;
    ++found;
    EXPECT_TRUE(PathBoxes(problem, false, best->error * (1 - 1e-6))(QuadBox(box)).shown);
    ProportionBox about = box;
    const double half = std::pow(10.0, boxes.uniform(-9, -1));
    for (Interval& side : about.side) side = Interval(side.low - half, side.high + half);
    const PathBoxes above(problem, false, best->error * (1 + 1e-12));
    EXPECT_FALSE(above(QuadBox(about)).shown);
    EXPECT_TRUE(above.counterexample(QuadBox(box)).has_value());
  }
  EXPECT_GT(found, 100);
}

TEST(Recheck, ConfirmsAProof) {
  const Recheck found = recheck(short_links(), 0.7 * kBestOfShortLinks, options_of(40, 1, 0));
  EXPECT_TRUE(found.holds());
  EXPECT_EQ(found.confirmed, 40u);
  EXPECT_GT(found.parts, 40u);
  EXPECT_EQ(found.boxes, 2 * found.discarded - 2);  // of two roots
}

TEST(Recheck, ConfirmsNothingThatTimeDidNotAllow) {
  bool over = false;
  RecheckOptions options = options_of(10, 1, 1);
  options.progress = [&](double share) { over = share > 0.5; };
  options.stop = [&] { return over; };
  const Recheck found = recheck(short_links(), 0.3 * kBestOfShortLinks, options);
  EXPECT_EQ(found.sampled, 1u);
  EXPECT_EQ(found.undecided, 0u);
  EXPECT_TRUE(found.covers);
  EXPECT_FALSE(found.holds());
}

TEST(Recheck, TakesTheSameSampleWithAnyNumberOfThreads) {
  const auto with = [](int threads, std::uint64_t seed) {
    return recheck(short_links(), 0.3 * kBestOfShortLinks, options_of(10, seed, threads));
  };
  const Recheck one = with(1, 1), many = with(4, 1), other = with(1, 2);
  EXPECT_EQ(one.parts, many.parts);
  EXPECT_EQ(one.boxes, many.boxes);
  EXPECT_EQ(one.boxes, other.boxes);
}

TEST(Recheck, RefutesABoundAboveALinkage) {
  const PathProblem problem = short_links();
  ProportionBox box = path_domain(problem).roots.front();
  for (Interval& side : box.side) side = Interval(0.75 * side.low + 0.25 * side.high);
  const auto linkage = PathBoxes(problem, false, 1e9).counterexample(QuadBox(box));
  ASSERT_TRUE(linkage.has_value());
  EXPECT_FALSE(better_linkage(problem, linkage->error * (1 - 1e-9), {*linkage}).has_value());
  EXPECT_TRUE(better_linkage(problem, linkage->error * (1 + 1e-9), {*linkage}).has_value());
}

TEST(Recheck, SeesBoxesThatDoNotCover) {
  const PathProblem problem = short_links();
  PathDomain domain = path_domain(problem);
  EXPECT_TRUE(covers_domain(problem, domain));
  for (int side = 0; side < 4; ++side) {
    PathDomain narrower = domain;
    narrower.roots[0].side[side].high -= 1e-6;
    EXPECT_FALSE(covers_domain(problem, narrower)) << side;
  }
  domain.roots.pop_back();
  EXPECT_FALSE(covers_domain(problem, domain));
}

TEST(Recheck, CountsVolumesExactly) {
  std::array<std::uint64_t, kMostHalvings> count{};
  count[1] = 1;
  count[60] = 2;
  for (int depth = 2; depth < 60; ++depth) count[depth] = 1;
  EXPECT_TRUE(volumes_add_up(count, 1));
  EXPECT_FALSE(volumes_add_up(count, 2));
  --count[60];
  EXPECT_FALSE(volumes_add_up(count, 1));
}

TEST(Recheck, RefusesWhatItDoesNotCheck) {
  PathProblem problem = short_links();
  EXPECT_EQ(recheck_refusal(problem), "");
  problem.constraints.required_class = RequiredClass::rocker_crank;
  EXPECT_NE(recheck_refusal(problem), "");
}

}  // namespace
}  // namespace cognate::problems::recheck_test
