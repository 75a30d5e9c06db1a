/// Figures of tolerances at single positions: printed ones to their last digit, and the partials of
/// a thousand mechanisms against differences in 113 bits.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/tolerance/sensitivity.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/read.hpp"
#include "problems/tolerance/dimensions.hpp"
#include "problems/tolerance/figures.hpp"
#include "tests/support/quad_mechanisms.hpp"

namespace cognate::problems::tolerance_oracle_test {
namespace {

using test::Quad;
using test::QuadNumbers;

constexpr double kDegree = 180 / kPi;

AnalysisProblem problem_of(const std::string& mechanism, const std::string& tolerance) {
  const auto read = parse_task<AnalysisProblem>("kind = \"analysis\"\n[tolerance]\n" + tolerance +
                                                "\n[mechanism]\n" + mechanism + "\n");
  if (read) return *read;
  ADD_FAILURE() << read.error().front().message << '\n' << mechanism;
  return {};
}

Station station_at(const NamedMechanism& mechanism, double degrees) {
  return {drive_position(mechanism.mechanism, degrees / kDegree), sides(mechanism.mechanism)};
}

/// Of the output, or of the point that is judged, at one crank angle.
ToleranceFigures figures_at(const std::string& mechanism, const std::string& tolerance,
                            double degrees) {
  const AnalysisProblem problem = problem_of(mechanism, tolerance);
  const NamedMechanism& named = problem.mechanism;
  ToleranceQuestion question;
  question.drive = question.motion_drive = {degrees / kDegree};
  question.stations = question.motion = {station_at(named, degrees)};
  ToleranceQuantity quantity{
      .name = "output", .response = travel_response(named.mechanism, named.output), .judged = true};
  for (std::size_t i = 0; i < named.points.size(); ++i) {
    if (named.points[i].name != problem.tolerances->of) continue;
    quantity.response = {};
    quantity.response.type = ResponseType::point;
    quantity.response.index = i;
  }
  question.quantities.push_back(quantity);
  const auto result = tolerance_figures(named, *problem.tolerances, {}, question, {.threads = 1});
  if (!result.refused) return result.quantities.at(0);
  ADD_FAILURE() << *result.refused;
  return {.positions = {{}}};
}

double partial(const ToleranceFigures& figures, const std::string& name) {
  for (const auto& one : figures.contributions) {
    if (one.dimension == name) return one.sensitivity;
  }
  ADD_FAILURE() << name;
  return NAN;
}

std::string four_bar(double crank, double coupler, double rocker, double frame) {
  return fmt::format(
      "type = \"four-bar\"\nfixed_pivots = [[0, 0], [{}, 0]]\ncrank = {}\ncoupler = {}\nrocker = "
      "{}",
      frame, crank, coupler, rocker);
}

const char* const kNames[] = {"crank", "coupler", "rocker", "frame"};
const std::string kRocker = four_bar(40, 120, 80, 110);

TEST(ToleranceOracle, TheRockerAt0DegreesToTheLastDigit) {
  const auto at =
      figures_at(kRocker, "length = 0.1\ndistribution = \"uniform\"\nsamples = 1000000", 0);
  const double printed[] = {-0.98108, -1.27768, 1.05808, 0.98108};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(partial(at, kNames[i]), printed[i], 5e-6);
  const PositionFigures& position = at.positions.front();
  EXPECT_NEAR(position.linear, 0.42979, 5e-6);
  EXPECT_NEAR(position.low, -0.43176, 5e-6);
  EXPECT_NEAR(position.high, 0.42785, 5e-6);
  EXPECT_NEAR(position.rss, 0.21626, 5e-6);
  // A printed figure of few samples: of 0.21626/sqrt(3) = 0.12486 it is 0.7 % off.
  EXPECT_NEAR(position.sigma, position.rss / std::sqrt(3.0), 1e-3 * position.sigma);
  EXPECT_NEAR(position.sigma, 0.1257, 0.01 * 0.1257);
}

TEST(ToleranceOracle, TheRockerAt60DegreesHasTheSpreadOfItsPartials) {
  const auto at =
      figures_at(kRocker, "length = 0.1\ndistribution = \"uniform\"\nsamples = 1000000", 60);
  const PositionFigures& position = at.positions.front();
  EXPECT_NEAR(position.sigma, position.rss / std::sqrt(3.0), 1e-3 * position.sigma);
  const test::QuadDimensions d{40, 120, 80, 110, 0, 0};
  for (int i = 0; i < 4; ++i) {
    const auto exact = static_cast<double>(test::quad_rocker_rate(d, i, test::in_radians(60), 1));
    EXPECT_NEAR(partial(at, kNames[i]) / kDegree, exact, 1e-9);
  }
}

TEST(ToleranceOracle, TheSliderAndTheCouplerPointToTheLastDigit) {
  const auto slider = figures_at("type = \"slider-crank\"\ncrank = 50\ncoupler = 150\noffset = 10",
                                 "length = 0.05", 0);
  EXPECT_NEAR(slider.positions.front().linear, 0.10346, 2e-5);
  EXPECT_NEAR(std::max(slider.positions.front().high, -slider.positions.front().low), 0.10346,
              5e-6);
  EXPECT_NEAR(slider.positions.front().rss, 0.07087, 5e-6);
  const std::string point = four_bar(1, 3, 2.5, 3.2) + "\ncoupler_point = [1.5, 1]";
  const auto at = figures_at(point, "length = 0.01\nof = \"P\"\nsamples = 0", 0);
  EXPECT_NEAR(at.positions.front().high, 0.0381, 5e-5);
}

TEST(ToleranceOracle, NearADeadPointToTheLastDigit) {
  const auto at = figures_at(four_bar(1, 3, 2, 3.99), "length = 0.001\nsamples = 0", 178);
  EXPECT_NEAR(at.positions.front().linear, 0.866, 5e-4);
  EXPECT_NEAR(at.positions.front().low, -0.796, 5e-4);
  EXPECT_NEAR(at.positions.front().high, 0.970, 5e-4);
  const test::QuadDimensions d{1, 3, 2, Quad("3.99"), 0, 0};
  for (int i = 0; i < 4; ++i) {
    const double found = partial(at, kNames[i]) / kDegree;
    const auto exact = static_cast<double>(test::quad_rocker_rate(d, i, test::in_radians(178), 1));
    EXPECT_NEAR(std::abs(found) * kDegree, 217, 2);  // printed for all four alike
    EXPECT_NEAR(found, exact, 1e-9 * std::abs(exact));
  }
}

/// The roller's centre is the pin of a link e − c from the cage's centre on the line a + c above
/// it: the radius of the roller is in both.
TEST(ToleranceOracle, TheOneWayClutchHasChasesFigures) {
  const double d[] = {27.645, 11.43, 50.8};
  MechanismWithPoints<double> clutch;
  clutch.mechanism.drive = Crank<double>{{}, 1};
  Rrp<double> link;
  link.length = d[2] - d[1];
  link.guide.offset = d[0] + d[1];
  clutch.mechanism.dyads.push_back(link);
  const std::vector<double> numbers = AffineMechanism::numbers(clutch);
  std::vector<std::vector<double>> slopes;
  for (int i = 0; i < 3; ++i) {
    auto changed = clutch;
    auto& moved = std::get<Rrp<double>>(changed.mechanism.dyads.front());
    moved.length += i == 2 ? 1 : i == 1 ? -1 : 0;
    moved.guide.offset += i < 2 ? 1 : 0;
    slopes.push_back(AffineMechanism::numbers(changed));
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      slopes.back()[k] = std::round(slopes.back()[k] - numbers[k]);
    }
  }
  Response angle;
  angle.index = 2;
  const std::vector stations{Station{drive_position(clutch.mechanism, 0), {1}}};
  const std::vector responses{angle};
  const auto table = sensitivities(AffineMechanism(clutch, slopes), responses, stations);
  // φ is counted from the line's normal, the link's angle from the line.
  const Vec2d along = table.value(0, 0);
  EXPECT_NEAR(std::atan2(along.x, along.y) * kDegree, 7.0184, 5e-5);
  const double printed[] = {-0.2079, -0.4142, 0.2063};
  const QuadNumbers exact{Quad("27.645"), Quad("11.43"), Quad("50.8")};
  for (std::size_t i = 0; i < 3; ++i) {
    const double found = -table.rates(0, 0)[i].x;
    EXPECT_NEAR(found, printed[i], 5e-5);
    EXPECT_NEAR(found, test::quad_rate(test::quad_clutch, exact, i), 1e-9);
  }
}

/// A file's mechanism at a crank angle, and the same in 113 bits.
struct RandomMechanism {
  std::string text;
  std::vector<std::string> names;
  QuadNumbers numbers;
  std::function<Quad(const QuadNumbers&)> output;
};

std::vector<double> lengths(std::mt19937_64& random, std::size_t count) {
  std::uniform_real_distribution<double> length(1, 4);
  std::vector<double> all(count);
  for (double& one : all) one = length(random);
  return all;
}

RandomMechanism random_mechanism(std::mt19937_64& random, int type, double degrees) {
  const Quad angle = Quad(degrees / kDegree);
  if (type == 0) {
    const auto d = lengths(random, 4);
    return {four_bar(d[0], d[1], d[2], d[3]),
            {kNames, kNames + 4},
            {d.begin(), d.end()},
            [angle](const QuadNumbers& q) {
              return test::quad_position({q[0], q[1], q[2], q[3], 0, 0}, angle, 1).rocker;
            }};
  }
  if (type == 1) {
    auto d = lengths(random, 3);
    d[2] -= 2.5;
    return {fmt::format("type = \"slider-crank\"\ncrank = {}\ncoupler = {}\noffset = {}", d[0],
                        d[1], d[2]),
            {"crank", "coupler", "offset"},
            {d.begin(), d.end()},
            [angle](const QuadNumbers& q) { return test::quad_slider(q, angle); }};
  }
  const auto d = lengths(random, 7);
  const double g = d[5] + d[6];
  return {fmt::format(
              "type = \"chain\"\npivot = [{{name = \"A\", at = [0, 0]}}, {{name = \"D\", at = [{}, "
              "0]}}, {{name = \"G\", at = [{}, 0]}}]\ncrank = {{at = \"A\", pin = \"B\", length = "
              "{}}}\ndyad = [{{type = \"RRR\", joins = [\"B\", \"D\"], lengths = [{}, {}], new = "
              "\"C\", names = [\"coupler\", \"rocker\"]}}, {{type = \"RRR\", joins = [\"C\", "
              "\"G\"], lengths = [{}, {}], new = \"E\", names = [\"rod\", \"arm\"]}}]",
              d[5], g, d[0], d[1], d[2], d[3], d[4]),
          {"crank", "coupler", "rocker", "rod", "arm"},
          {d.begin(), d.begin() + 5},
          [angle, a = Quad(d[5]), g = Quad(g)](const QuadNumbers& q) {
            return test::quad_second_rocker(q, a, g, angle);
          }};
}

TEST(ToleranceOracle, PartialsOfAThousandMechanismsAreThoseOf113Bits) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> turn(-180, 180);
  int compared[3] = {};
  for (int trial = 0; compared[0] + compared[1] + compared[2] < 1000; ++trial) {
    const double degrees = turn(random);
    const RandomMechanism own = random_mechanism(random, trial % 3, degrees);
    if (!std::isfinite(static_cast<double>(own.output(own.numbers)))) continue;
    const AnalysisProblem problem = problem_of(own.text, "length = 0.001");
    const auto made = toleranced(problem.mechanism, *problem.tolerances, {});
    ASSERT_TRUE(made) << made.error().reason;
    const std::vector responses{
        travel_response(problem.mechanism.mechanism, problem.mechanism.output)};
    const std::vector stations{station_at(problem.mechanism, degrees)};
    const auto table = sensitivities(made->mechanism, responses, stations);
    std::size_t found = 0;
    for (std::size_t k = 0; k < made->dimensions.size(); ++k) {
      for (std::size_t i = 0; i < own.names.size(); ++i) {
        if (made->dimensions[k].name != own.names[i]) continue;
        ++found;
        const double exact = test::quad_rate(own.output, own.numbers, i);
        ASSERT_NEAR(table.rates(0, 0)[k].x, exact, 1e-9 * std::max(1.0, std::abs(exact)))
            << own.text << "\nat " << degrees << " deg, " << own.names[i];
      }
    }
    ASSERT_EQ(found, own.names.size()) << own.text;
    ++compared[trial % 3];
  }
  for (const int count : compared) EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace cognate::problems::tolerance_oracle_test
