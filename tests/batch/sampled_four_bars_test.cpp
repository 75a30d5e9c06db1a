/// Samples of four-bars: those of the batches' kernel against those of the general one, which a
/// point that only the latter has makes run, on every instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/tolerance/sampling.hpp"
#include "analysis/tolerance/sensitivity.hpp"

namespace cognate {
namespace {

/// Lengths, the frame along its line, and both coordinates of a coupler point may change.
constexpr std::size_t kDimensions = 6;

MechanismWithPoints<double> linkage_of(const std::vector<double>& d, const Vec2d& frame, int side) {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0.5, -0.25}, d[0]};
  mechanism.dyads.push_back(Rrr<double>{.first = {1, {d[0], 0}},
                                        .second = {0, Vec2d{0.5, -0.25} + d[3] * frame},
                                        .first_length = d[1],
                                        .second_length = d[2],
                                        .assembly = side > 0 ? Assembly::open : Assembly::crossed});
  return {mechanism, {{2, {d[4], d[5]}}, {3, {0.3, 0.2}}}};
}

struct Case {
  AffineMechanism mechanism;
  std::vector<Station> stations;
  double tolerance = 0;
};

Case random_case(std::mt19937_64& random) {
  std::uniform_real_distribution<double> length(1, 3), turn(-kPi, kPi), exponent(-4, -0.8);
  const int side = random() % 2 == 0 ? 1 : -1;
  const double slant = turn(random), first = turn(random);
  const Vec2d frame{std::cos(slant), std::sin(slant)};
  std::vector<double> d;
  for (std::size_t i = 0; i < kDimensions; ++i) d.push_back(length(random));
  d[3] = std::max(1.2, d[1] + d[2] - d[0] - 0.5);
  const auto nominal = linkage_of(d, frame, side);
  const auto numbers = AffineMechanism::numbers(nominal);
  std::vector<std::vector<double>> slopes;
  for (std::size_t i = 0; i < kDimensions; ++i) {
    auto moved = d;
    moved[i] += 1;
    slopes.push_back(AffineMechanism::numbers(linkage_of(moved, frame, side)));
    for (std::size_t k = 0; k < numbers.size(); ++k) slopes.back()[k] -= numbers[k];
  }
  Case one{AffineMechanism(nominal, slopes), {}, std::pow(10, exponent(random))};
  ChangedMechanism<double> closing(nominal);
  for (int k = 0; k < 40; ++k) {
    const Station station{drive_position(nominal.mechanism, first + 0.05 * k),
                          {static_cast<double>(side)}};
    closing.move_to(station);
    if (closing.closures()[0].discriminant > 0) one.stations.push_back(station);
  }
  return one;
}

Response of(ResponseType type, std::size_t index) {
  Response response;
  response.type = type;
  response.index = index;
  return response;
}

SampleStatistics sampled(const Case& one, std::vector<Response> responses, InstructionSet set) {
  const auto table = sensitivities(one.mechanism, responses, one.stations);
  std::vector<JudgedResponse> judged;
  for (std::size_t r = 0; r < responses.size(); ++r) {
    judged.push_back({.response = responses[r], .offset = std::vector(one.stations.size(), 0.01)});
    for (std::size_t s = 0; s < one.stations.size(); ++s) {
      judged.back().reference.push_back(table.value(s, r));
    }
  }
  SamplingOptions options{.samples = 500, .instruction_set = set};
  options.draw = [&](std::size_t first, std::size_t count, std::span<double> changes) {
    for (std::size_t d = 0; d < kDimensions; ++d) {
      for (std::size_t i = 0; i < count; ++i) {
        const double share = std::fmod(0.618034 * static_cast<double>((first + i) * (d + 1)), 1);
        changes[d * count + i] = one.tolerance * (2 * share - 1);
      }
    }
  };
  return sample(one.mechanism, judged, one.stations, options);
}

TEST(SampledFourBars, AreThoseOfTheGeneralKernelOnEveryInstructionSet) {
  std::mt19937_64 random(3);
  const std::vector<Response> few{of(ResponseType::angle, 3), of(ResponseType::point, 0),
                                  of(ResponseType::transmission, 0)};
  auto more = few;
  more.push_back(of(ResponseType::point, 1));  // the rocker's, which batches do not have
  int open = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Case one = random_case(random);
    if (one.stations.empty()) continue;
    const auto reference = sampled(one, more, InstructionSet::scalar);
    open += reference.assembled < reference.samples ? 1 : 0;
    for (const InstructionSet set : instruction_sets()) {
      SCOPED_TRACE(name(set));
      for (const auto& found : {sampled(one, few, set), sampled(one, more, set)}) {
        ASSERT_EQ(found.assembled, reference.assembled) << trial;
        for (std::size_t r = 0; r < few.size(); ++r) {
          // Near dead points rounding is enlarged as everything else.
          const double near = 1e-11 * std::max(1.0, one.tolerance / 1e-3);
          for (std::size_t s = 0; s < one.stations.size(); ++s) {
            const auto &a = found.responses[r].stations[s], &b = reference.responses[r].stations[s];
            ASSERT_NEAR(a.mean, b.mean, near) << trial << ' ' << r << ' ' << s;
            ASSERT_NEAR(a.standard_deviation, b.standard_deviation, near) << trial << ' ' << r;
          }
          for (std::size_t i = 0; i < found.assembled; ++i) {
            ASSERT_NEAR(found.responses[r].extremes[i], reference.responses[r].extremes[i], near);
          }
        }
      }
    }
  }
  EXPECT_GT(open, 5);
}

}  // namespace
}  // namespace cognate
