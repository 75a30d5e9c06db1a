// What the report of a cam draws, held against what a cam is.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "analysis/cam/contact.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/kinds/kinds.hpp"
#include "app/report/cam_report_data.hpp"
#include "tests/browser/sample_cams.hpp"

namespace cognate::app::cam_report_test {
namespace {

using nlohmann::ordered_json;
using problems::SampleCam;

SampleCam sample(const std::string& name) {
  for (SampleCam& cam : problems::sample_cams()) {
    if (cam.name == name) return std::move(cam);
  }
  ADD_FAILURE() << name;
  return {};
}

ordered_json data_of(const SampleCam& cam) {
  return cam_report_data(cam.problem, cam.result);
}

std::vector<double> numbers(const ordered_json& list) {
  return list.get<std::vector<double>>();
}

std::vector<Vec2d> points(const ordered_json& curve) {
  const auto x = numbers(curve["x"]), y = numbers(curve["y"]);
  std::vector<Vec2d> all;
  for (std::size_t i = 0; i < x.size(); ++i) all.push_back({x[i], y[i]});
  return all;
}

Vec2d turned(const Vec2d& p, double angle) {
  return p * Vec2d{std::cos(angle), std::sin(angle)};
}

double distance_to_segment(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  const Vec2d along = b - a;
  const double t = std::clamp(dot(p - a, along) / squared_norm(along), 0.0, 1.0);
  return norm(p - a - t * along);
}

double distance(const Vec2d& p, const std::vector<Vec2d>& closed) {
  double least = norm(p - closed.back());
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const Vec2d& next = closed[(i + 1) % closed.size()];
    if (norm(next - closed[i]) > 0) {
      least = std::min(least, distance_to_segment(p, closed[i], next));
    }
  }
  return least;
}

/// Calls `visit` for every number of a document.
template <class Visit>
void each_number(const ordered_json& value, const Visit& visit) {
  if (value.is_number()) visit(value.get<double>());
  if (value.is_structured()) {
    for (const auto& part : value) each_number(part, visit);
  }
}

// The specification's formulas, s₀ = √(40² − 15²): x = (s₀ + s) sin δ + e cos δ.
TEST(CamReport, DrawsThePitchCurveOfTheWorkedExample) {
  const auto data = data_of(sample("translating-roller"));
  const auto pitch = data["designs"][0]["pitch"];
  const auto at = points(pitch);
  const auto deg = numbers(pitch["deg"]);
  const double start = std::sqrt(40.0 * 40 - 15 * 15);
  for (std::size_t i = 0; i < at.size(); ++i) {
    double s = 0;
    if (deg[i] <= 50) {
      s = 2 * 60 * std::pow(deg[i] / 100, 2);
    } else if (deg[i] <= 100) {
      s = 60 - 2 * 60 * std::pow(1 - deg[i] / 100, 2);
    } else if (deg[i] <= 160) {
      s = 60;
    } else if (deg[i] <= 250) {
      s = 30 * (1 + std::cos(kPi * (deg[i] - 160) / 90));
    }
    const double angle = kDegree * deg[i];
    EXPECT_NEAR(at[i].x, (start + s) * std::sin(angle) + 15 * std::cos(angle), 2e-4) << deg[i];
    EXPECT_NEAR(at[i].y, (start + s) * std::cos(angle) - 15 * std::sin(angle), 2e-4) << deg[i];
  }
  EXPECT_GE(at.size(), 700u);
}

// A roller's profile is everywhere its radius away from the pitch curve as a whole; an outer wall
// on the other side of it.
TEST(CamReport, DrawsProfilesAtTheRollersRadiusFromThePitchCurve) {
  for (const char* name : {"translating-roller", "oscillating-roller", "groove"}) {
    const SampleCam cam = sample(name);
    const double radius = cam.result.designs[0].cam.system.follower.dimensions.roller_radius;
    const auto design = data_of(cam)["designs"][0];
    const auto pitch = points(design["pitch"]);
    std::vector<std::vector<Vec2d>> curves = {points(design["profile"])};
    if (design.contains("outer")) curves.push_back(points(design["outer"]));
    EXPECT_EQ(curves.size(), std::string(name) == "groove" ? 2u : 1u);
    for (const auto& curve : curves) {
      for (std::size_t i = 0; i < curve.size(); i += 7) {
        EXPECT_NEAR(distance(curve[i], pitch), radius, 2e-3) << name << ' ' << i;
      }
    }
  }
}

// Seen from the cam, every contact lies on the drawn profile.
TEST(CamReport, PutsTheContactOnTheProfile) {
  for (const SampleCam& cam : problems::sample_cams()) {
    const auto design = data_of(cam)["designs"][0];
    const auto profile = points(design["profile"]);
    const auto& table = design["table"];
    const auto deg = numbers(table["deg"]), x = numbers(table["contact_x"]),
               y = numbers(table["contact_y"]);
    ASSERT_GE(deg.size(), 721u);
    EXPECT_EQ(deg.front(), 0);
    EXPECT_EQ(deg.back(), 360);
    for (std::size_t i = 0; i < deg.size(); i += 11) {
      EXPECT_LT(distance(turned({x[i], y[i]}, -kDegree * deg[i]), profile), 2e-3)
          << cam.name << ' ' << deg[i];
    }
  }
}

// The example's printed values: 38.71° at 50° and 52.16° at 160° + 61.39°.
TEST(CamReport, ShowsThePressureAngleOfTheWorkedExample) {
  const auto table = data_of(sample("translating-roller"))["designs"][0]["table"];
  const auto deg = numbers(table["deg"]), angle = numbers(table["pressure_deg"]);
  const auto most = std::ranges::max_element(angle) - angle.begin();
  const auto least = std::ranges::min_element(angle) - angle.begin();
  EXPECT_NEAR(angle[most], 38.71, 0.005);
  EXPECT_NEAR(deg[most], 50, 0.5);
  EXPECT_NEAR(angle[least], -52.16, 0.005);
  EXPECT_NEAR(deg[least], 221.39, 0.5);
}

// Both sides of a jump have a row: the acceleration of 4·60/β² turns to −4·60/β² at 50°.
TEST(CamReport, HasBothSidesOfAJump) {
  const auto table = data_of(sample("translating-roller"))["designs"][0]["table"];
  const auto deg = numbers(table["deg"]), acceleration = numbers(table["acceleration"]);
  const double size = 4 * 60 / std::pow(100 * kDegree, 2);
  std::vector<double> there;
  for (std::size_t i = 0; i < deg.size(); ++i) {
    if (std::abs(deg[i] - 50) < 1e-9) there.push_back(acceleration[i]);
  }
  ASSERT_GE(there.size(), 2u);
  EXPECT_NEAR(there.front(), size, 1e-4);
  EXPECT_NEAR(there.back(), -size, 1e-4);
}

TEST(CamReport, ShowsStrokesSegmentsLimitsAndProof) {
  const auto data = data_of(sample("translating-roller"));
  const auto& design = data["designs"][0];
  ASSERT_EQ(design["strokes"].size(), 4u);
  EXPECT_EQ(design["strokes"][2]["stroke"], "return");
  EXPECT_NEAR(design["strokes"][2]["from_deg"].get<double>(), 160, 1e-6);
  ASSERT_EQ(design["segments"].size(), 4u);
  EXPECT_EQ(design["segments"][0]["law"], "constant-acceleration");
  EXPECT_NEAR(design["segments"][2]["from_deg"].get<double>(), 160, 1e-6);
  EXPECT_NEAR(design["segments"][2]["factors"]["velocity"].get<double>(), 1.570796, 1e-5);
  EXPECT_NEAR(data["limits"]["rise_deg"].get<double>(), 35, 1e-9);
  EXPECT_TRUE(data["limits"]["pressure_deg"].is_null());
  EXPECT_NEAR(design["proof"]["positions"][0]["deg"].get<double>(), 50, 1e-9);
  EXPECT_EQ(design["constraints"][0]["satisfied"], false);
  EXPECT_TRUE(design["table"].contains("stress"));
}

// A dwell from a cusp has no finite curvature somewhere, a straight flank no finite radius; the
// page still has numbers alone.
TEST(CamReport, HasFiniteNumbersAlone) {
  for (const SampleCam& cam : problems::sample_cams()) {
    std::size_t count = 0;
    each_number(data_of(cam), [&](double value) {
      ++count;
      EXPECT_TRUE(std::isfinite(value)) << cam.name;
    });
    EXPECT_GT(count, 10'000u);
  }
}

// |offset| > base radius: there is no such cam.
TEST(CamReport, BearsACamThatCannotBePutTogether) {
  SampleCam cam = sample("translating-roller");
  auto& system = cam.result.designs[0].cam.system;
  system.follower.dimensions.base_radius = 10;
  system.start = starting_place(system.follower);
  ASSERT_FALSE(std::isfinite(system.start));
  const auto data = data_of(cam);
  each_number(data, [&](double value) { EXPECT_TRUE(std::isfinite(value)); });
  EXPECT_TRUE(data["designs"][0]["table"]["contact_x"][0].is_null());
}

TEST(CamReport, StaysSmallHoweverManySegmentsAndDesignsThereAre) {
  SampleCam cam = sample("translating-flat");
  constexpr int kSegments = 100'000;
  std::vector<cam::MotionSegment> motion;
  for (int i = 0; i < kSegments; ++i) {
    motion.push_back({.law = cam::MotionLaw::cycloidal,
                      .over = kTurn / kSegments,
                      .rise = i % 2 ? -1e-6 : 1e-6});
  }
  cam.result.designs[0].motion = motion;
  cam.result.designs[0].cam.programme = *programme_of(motion);
  cam.result.segments.assign(kSegments, {});
  EXPECT_LT(data_of(cam).dump().size(), 1'200'000u);
  SampleCam many = sample("conjugate");
  many.result.designs.resize(10, many.result.designs[0]);
  EXPECT_LT(data_of(many).dump().size(), 1'200'000u);
}

TEST(CamReport, LeavesVeryLongListsOutOfTheResult) {
  constexpr std::size_t kPage = 900'000;  // with the kernel; three lists of 1 MB are left out
  const SampleCam cam = sample("translating-flat");
  const ordered_json list(30'000, ordered_json{{"law", "cycloidal"}, {"over_deg", 0.012}});
  ordered_json document = {{"problem", {{"title", "Long"}, {"motion", list}}},
                           {"segments", list},
                           {"designs", {{{"mechanism", {{"type", "cam"}, {"motion", list}}}}}}};
  EXPECT_LT(report_html(document, cam.problem, cam.result).size(), kPage);
}

TEST(CamReport, IsAPageThatHoldsTextAsText) {
  SampleCam cam = sample("oscillating-flat");
  const ordered_json document = {{"problem", {{"title", "</script><b>"}}}, {"status", "solved"}};
  const std::string page = report_html(document, cam.problem, cam.result);
  EXPECT_EQ(page.find("</script><b>"), std::string::npos);
  EXPECT_EQ(page.find("@DATA@"), std::string::npos);
  EXPECT_NE(page.find("Kinematic inversion"), std::string::npos);
}

}  // namespace
}  // namespace cognate::app::cam_report_test
