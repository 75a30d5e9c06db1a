/// Gear trains against closed forms of the textbooks, and identities of power and torque.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "analysis/train/planets.hpp"
#include "analysis/train/train_loads.hpp"

namespace cognate::train::gear_train_test {
namespace {

constexpr int kSun = 0, kPlanet = 1, kCarrier = 2, kRing = 3;

GearTrain planetary(int sun, int planet, int ring, double first = 1, double second = 1) {
  return {4,
          {{{kSun, kPlanet}, {sun, planet}, kCarrier, -1, first},
           {{kPlanet, kRing}, {planet, ring}, kCarrier, 1, second}},
          {kRing},
          {}};
}

/// 1 and 3 are central gears, both in external mesh with a double planet.
GearTrain two_suns(int first, int planet_first, int planet_second, int second, double efficiency) {
  return {4,
          {{{kSun, kPlanet}, {first, planet_first}, kCarrier, -1, efficiency},
           {{kPlanet, kRing}, {planet_second, second}, kCarrier, -1, 1}},
          {kRing},
          {}};
}

std::vector<double> numbers(const TrainSpeeds& speeds, int members) {
  std::vector<double> all;
  for (int i = 0; i < members; ++i) all.push_back(speeds.speed(i, {1}));
  return all;
}

TEST(FractionTest, CommonMeasure) {
  EXPECT_EQ(common_measure(Fraction(3, 4), Fraction(5, 6)), Fraction(1, 12));
  EXPECT_EQ(common_measure(Fraction(0), Fraction(-5, 6)), Fraction(5, 6));
  EXPECT_EQ(common_measure(Fraction(-5, 6), Fraction(0)), Fraction(5, 6));
}

TEST(GearTrainTest, LongTrainsStayExact) {
  // Sixty pairs of 9973 and 9967 teeth, both prime, and back again by as many: each shaft's speed
  // is known by a fraction of 240 digits, and the last turns as the first does.
  GearTrain train{121, {}, {}, {}};
  for (int k = 0; k < 120; ++k) {
    const bool there = k < 60;
    train.meshes.push_back({{k, k + 1}, {there ? 9973 : 9967, there ? 9967 : 9973}});
  }
  const auto speeds = speeds_of(train, {0});
  const boost::multiprecision::cpp_int driven = pow(boost::multiprecision::cpp_int(9973), 60U);
  const boost::multiprecision::cpp_int driving = pow(boost::multiprecision::cpp_int(9967), 60U);
  EXPECT_EQ(speeds.shares[60][0], Fraction(driven, driving));
  EXPECT_EQ(speeds.shares[120][0], 1);
}

TEST(GearTrainTest, SunToCarrierIsOnePlusRingOverSun) {
  for (int sun = 12; sun < 60; ++sun) {
    const auto speeds = speeds_of(planetary(sun, 20, sun + 40), {kSun});
    ASSERT_TRUE(speeds.is_determined());
    EXPECT_EQ(speeds.freedom, 1);
    EXPECT_EQ(1 / speeds.shares[kCarrier][0], 1 + Fraction(sun + 40, sun));
  }
}

TEST(GearTrainTest, TenThousandToOne) {
  // 1 − (99·101)/(100·100): the textbooks' example of a great reduction by near equal gears.
  const auto speeds = speeds_of(two_suns(100, 101, 100, 99, 1), {kCarrier});
  EXPECT_EQ(1 / speeds.shares[kSun][0], 10000);
}

TEST(GearTrainTest, FergusonsParadox) {
  // One broad planet with wheels of 100, 99 and 101 teeth: the second and third turn in different
  // senses while the carrier turns and the first is held.
  GearTrain train{5, {}, {0}, {}};
  train.meshes = {{{0, 1}, {100, 20}, 4}, {{1, 2}, {20, 99}, 4}, {{1, 3}, {20, 101}, 4}};
  const auto speeds = speeds_of(train, {4});
  EXPECT_EQ(speeds.shares[2][0], Fraction(-1, 99));
  EXPECT_EQ(speeds.shares[3][0], Fraction(1, 101));
}

TEST(GearTrainTest, DegreesOfFreedom) {
  GearTrain open = planetary(24, 30, 84);
  open.fixed.clear();
  EXPECT_EQ(speeds_of(open, {kSun}).freedom, 2);
  EXPECT_FALSE(speeds_of(open, {kSun}).undetermined.empty());
  EXPECT_TRUE(speeds_of(open, {kSun, kRing}).is_determined());
  const auto excess = speeds_of(planetary(24, 30, 84), {kSun, kCarrier});
  EXPECT_EQ(excess.excess, std::vector<int>{1});
  EXPECT_TRUE(excess.locked.empty());
  GearTrain locked = planetary(24, 30, 84);
  locked.fixed.push_back(kCarrier);
  EXPECT_EQ(speeds_of(locked, {kSun}).locked, std::vector<int>{0});
}

TEST(GearTrainTest, ClutchedMembersTurnAsOne) {
  GearTrain train = planetary(24, 30, 84);
  train.fixed.clear();
  train.joined = {{kSun, kRing}};
  const auto speeds = speeds_of(train, {kSun});
  for (const auto& share : speeds.shares) EXPECT_EQ(share[0], Fraction(1));
}

TEST(TrainLoadsTest, EfficiencyOfAPlanetaryTrain) {
  const double one = 0.985, two = 0.99, eta = one * two, standing = -84.0 / 24;
  const GearTrain train = planetary(24, 30, 84, one, two);
  const auto speeds = numbers(speeds_of(train, {kSun}), 4);
  const auto forward = loads_of(train, speeds, {{kSun, 1}}, {kCarrier});
  ASSERT_TRUE(forward);
  EXPECT_NEAR(-forward->external[kCarrier] * speeds[kCarrier],
              (1 - standing * eta) / (1 - standing), 1e-14);
  EXPECT_NEAR(forward->external[kRing], 3.5 * eta, 1e-14);
  const auto back = loads_of(train, speeds, {{kSun, -1}}, {kCarrier});
  ASSERT_TRUE(back);
  EXPECT_NEAR(1 / (back->external[kCarrier] * speeds[kCarrier]),
              (1 - standing) / (1 - standing / eta), 1e-14);
}

TEST(TrainLoadsTest, AGreatReductionWastesNearlyAll) {
  const double eta = 0.98, standing = 0.9999;
  const GearTrain train = two_suns(100, 101, 100, 99, eta);
  const auto speeds = numbers(speeds_of(train, {kCarrier}), 4);
  const auto loads = loads_of(train, speeds, {{kCarrier, 1}}, {kSun});
  ASSERT_TRUE(loads);
  EXPECT_NEAR(-loads->external[kSun] * speeds[kSun], (1 - standing) / (1 - standing * eta), 1e-12);
}

TEST(TrainLoadsTest, TorquesAndPowersBalance) {
  for (const double eta : {1.0, 0.97, 0.9}) {
    for (const int sun : {18, 33, 60}) {
      const GearTrain train = planetary(sun, 21, sun + 42, eta, 0.99);
      const auto speeds = numbers(speeds_of(train, {kSun}), 4);
      const auto loads = loads_of(train, speeds, {{kSun, 2}}, {kCarrier});
      ASSERT_TRUE(loads);
      double torque = 0, power = 0;
      for (int i = 0; i < 4; ++i) {
        torque += loads->external[static_cast<std::size_t>(i)];
        power += loads->external[static_cast<std::size_t>(i)] * speeds[static_cast<std::size_t>(i)];
      }
      EXPECT_NEAR(torque, 0, 1e-12);
      EXPECT_NEAR(power, std::accumulate(loads->loss.begin(), loads->loss.end(), 0.0), 1e-12);
      EXPECT_EQ(power > 1e-12, eta < 1 || speeds[kPlanet] != speeds[kCarrier]);
    }
  }
}

/// By trial: turn the carrier by a share of a turn with the first gear held; a planet that meshes
/// there can be put in where some of its angles, a tooth of its first gear apart, meets the second.
bool fits_by_trial(int a, int p, int q, int b, int sense_a, int sense_b, int count) {
  for (int place = 1; place < count; ++place) {
    const double carrier = double(place) / count;
    bool found = false;
    for (int tooth = 0; tooth < p && !found; ++tooth) {
      const double planet = (-sense_a * a * carrier + tooth) / p;  // to the carrier, in turns
      const double teeth = sense_b * q * planet + b * carrier;
      found = std::abs(teeth - std::round(teeth)) < 1e-9;
    }
    if (!found) return false;
  }
  return true;
}

TEST(PlanetsTest, AssemblyAgreesWithTrial) {
  int both = 0;
  for (const int count : {2, 3, 4, 5}) {
    for (int sun = 12; sun < 30; ++sun) {
      for (const int p : {10, 12, 15}) {
        for (const int q : {9, 12, 14}) {
          const int ring = sun + p + q;
          const std::vector<SizedMesh> meshes = {{{{0, 1}, {sun, p}, 2, -1}},
                                                 {{{1, 3}, {q, ring}, 2, 1}}};
          const auto found = assemblies(meshes, {{1, 2, count}});
          ASSERT_EQ(found.size(), 1U);
          EXPECT_EQ(found[0].fits, fits_by_trial(sun, p, q, ring, -1, 1, count))
              << sun << " " << p << " " << q << " " << count;
          both |= found[0].fits ? 1 : 2;
        }
      }
    }
  }
  EXPECT_EQ(both, 3);
}

TEST(PlanetsTest, NeighboursAndOrbits) {
  const std::vector<SizedMesh> meshes = {{{{0, 1}, {24, 30}, 2, -1}, 2},
                                         {{{1, 3}, {30, 84}, 2, 1}, 2}};
  const std::vector<Planet> planets = {{1, 2, 3}};
  EXPECT_EQ(orbit_radii(planets[0], meshes, planets), (std::vector<double>{54, 54}));
  EXPECT_NEAR(*neighbour_clearance(planets[0], meshes, planets), 108 * std::sqrt(0.75) - 64, 1e-12);
}

}  // namespace
}  // namespace cognate::train::gear_train_test
