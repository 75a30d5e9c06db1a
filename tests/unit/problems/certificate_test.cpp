// Certificates hold for planted linkages, whose roots are known, and for nothing beside them.
#include "synthesis/exact/nine_point/certificate.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <tuple>

#include "synthesis/exact/nine_point/ball.hpp"
#include "tests/support/planted_path.hpp"

namespace cognate::synthesis::certificate_test {
namespace {

using Complex = std::complex<double>;

struct PlantedRoot {
  PathSystem system;
  PathRoot root;
};

Complex complex_of(const Vec2d& v) {
  return {v.x, v.y};
}

Dyad<Complex> real_dyad(Complex moving, Complex fixed) {
  return {moving, std::conj(moving), fixed, std::conj(fixed)};
}

/// The system of a planted path, its first position the reference, with its root to double.
<<<<<<< HEAD
PlantedRoot plant(const planting::PlantedPath& path, int poses) {
=======
PlantedRoot plant(const test::PlantedPath& path, int poses) {
>>>>>>> 4d5ca09
  const Motion motion(path.linkage);
  std::vector<cognate::Pose> at;
  for (const double angle : path.crank_angles) at.push_back(motion.at(angle).value());
  PlantedRoot planted;
  PathSystem& system = planted.system;
  system.origin = *at[0].coupler_point;
  system.kind = {poses, int(at.size()) - poses};
  double squares = 0;
  for (std::size_t j = 1; j < at.size(); ++j) {
    squares += squared_norm(*at[j].coupler_point - system.origin);
  }
  system.scale = std::sqrt(squares / double(at.size() - 1));
  const auto scaled = [&](const Vec2d& p) { return complex_of(p - system.origin) / system.scale; };
  planted.root.first = real_dyad(scaled(at[0].b), scaled(path.linkage.pivot_a));
  planted.root.second = real_dyad(scaled(at[0].c), scaled(path.linkage.pivot_d));
  for (std::size_t j = 1; j < at.size(); ++j) {
    system.d.push_back(scaled(*at[j].coupler_point));
    system.order.push_back(int(j));
    const Complex turn = complex_of(at[j].c - at[j].b) / complex_of(at[0].c - at[0].b);
    planted.root.rotations.push_back(turn / std::abs(turn));
    if (int(j) < poses) system.t.push_back(planted.root.rotations.back());
  }
  return planted;
}

/// Roberts' next cognate: the fixed pivot of the first dyad becomes that of the second.
PathRoot next_cognate(const PathSystem& system, const PathRoot& root) {
  const auto map = [](Complex x, Complex a, Complex y, Complex b) {
    return std::array{(x - a) * y / (x - y), (b * x - a * y) / (x - y), a - x, a};
  };
  const auto& [p, q] = std::tie(root.first, root.second);
  const auto z = map(p.moving, p.fixed, q.moving, q.fixed);
  const auto bar = map(p.moving_bar, p.fixed_bar, q.moving_bar, q.fixed_bar);
  PathRoot next{{z[0], bar[0], z[1], bar[1]}, {z[2], bar[2], z[3], bar[3]}, {}};
  for (std::size_t j = 0; j < system.d.size(); ++j) {
    next.rotations.push_back((p.moving * root.rotations[j] + system.d[j] - p.fixed) /
                             (p.moving - p.fixed));
  }
  return next;
}

TEST(Ball, HoldsTheResultsOfAllItsMembers) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  using Long = boost::multiprecision::cpp_bin_float_100;
  using Exact = std::pair<Long, Long>;
  const auto times = [](const Exact& a, const Exact& b) {
    return Exact{a.first * b.first - a.second * b.second, a.first * b.second + a.second * b.first};
  };
  for (int i = 0; i < 2000; ++i) {
    const auto ball = [&] {
      return Ball<double>(uniform(random), uniform(random), 0.1 * (1 + uniform(random)) * (i % 3));
    };
    const Ball<double> a = ball(), b = ball();
    const auto member = [&](const Ball<double>& of) {
      const double angle = 3.2 * uniform(random);
      return Exact{Long(of.re) + Long(of.radius) * cos(Long(angle)),
                   Long(of.im) + Long(of.radius) * sin(Long(angle))};
    };
    const auto holds = [](const Ball<double>& of, const Exact& z) {
      const Long re = z.first - of.re, im = z.second - of.im;
      return sqrt(re * re + im * im) <= Long(of.radius);
    };
    const Exact p = member(a), q = member(b);
    EXPECT_TRUE(holds(a + b, {p.first + q.first, p.second + q.second}));
    EXPECT_TRUE(holds(a - b, {p.first - q.first, p.second - q.second}));
    EXPECT_TRUE(holds(a * b, times(p, q)));
    const Long square = p.first * p.first + p.second * p.second;
    EXPECT_TRUE(holds(inverse(a), {p.first / square, -p.second / square}));
  }
  EXPECT_TRUE(std::isinf(inverse(Ball<double>(0.1, 0.1, 0.2)).radius));
}

class PlantedCertificates : public ::testing::TestWithParam<int> {};

TEST_P(PlantedCertificates, HoldForTheLinkageThatWasPlanted) {
  const int poses = GetParam();
  const int count = poses + 8 - 2 * (poses - 1);
  std::mt19937_64 random(17);
  int certified = 0;
  constexpr int kTries = 40;
  for (int i = 0; i < kTries; ++i) {
<<<<<<< HEAD
    const PlantedRoot planted = plant(planting::random_crank_rocker(random, count, 1), poses);
=======
    const PlantedRoot planted = plant(test::random_crank_rocker(random, count, 1), poses);
>>>>>>> 4d5ca09
    const RootCertificate found = certify(planted.system, planted.root);
    certified += found.certified;
    if (!found.certified) continue;
    EXPECT_TRUE(found.real);
    EXPECT_LT(found.radius, 1e-15);
    EXPECT_LT(found.radius, found.unique_within);
    EXPECT_LT(found.distance, found.unique_within + found.radius);
    EXPECT_LT(found.distance, 1e-8);
  }
  EXPECT_EQ(certified, kTries);
}

INSTANTIATE_TEST_SUITE_P(OfEachClass, PlantedCertificates, ::testing::Values(1, 2, 3, 4));

TEST(Certificate, IsRefusedToWhatIsNoRoot) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 50; ++i) {
<<<<<<< HEAD
    PlantedRoot planted = plant(planting::random_crank_rocker(random, 9, 1), 1);
=======
    PlantedRoot planted = plant(test::random_crank_rocker(random, 9, 1), 1);
>>>>>>> 4d5ca09
    const auto any = [&] {
      return real_dyad({normal(random), normal(random)}, {normal(random), normal(random)});
    };
    planted.root.first = any();
    planted.root.second = any();
    EXPECT_FALSE(certify(planted.system, planted.root).certified);
  }
}

TEST(Certificate, IsRefusedOutsideOfItsPolydisc) {
  std::mt19937_64 random(9);
  for (int i = 0; i < 20; ++i) {
<<<<<<< HEAD
    const PlantedRoot planted = plant(planting::random_crank_rocker(random, 9, 1), 1);
=======
    const PlantedRoot planted = plant(test::random_crank_rocker(random, 9, 1), 1);
>>>>>>> 4d5ca09
    const RootCertificate proof = certify(planted.system, planted.root);
    ASSERT_TRUE(proof.certified);
    const auto moved = [&](double by) {
      PathRoot root = proof.refined;
      const Complex step = by * (1 + std::abs(root.first.fixed));
      root.first.fixed += step;
      root.first.fixed_bar += step;
      return certify(planted.system, root);
    };
    const RootCertificate inside = moved(0.4 * proof.unique_within);
    if (inside.certified) {
      EXPECT_GT(inside.distance, 0.39 * proof.unique_within);
      EXPECT_LT(std::abs(inside.refined.first.fixed - proof.refined.first.fixed), 1e-12);
    }
    EXPECT_FALSE(moved(8 * proof.unique_within).certified) << proof.unique_within;
  }
}

TEST(Certificate, IsRefusedWithoutNumbers) {
  std::mt19937_64 random(10);
<<<<<<< HEAD
  PlantedRoot planted = plant(planting::random_crank_rocker(random, 9, 1), 1);
=======
  PlantedRoot planted = plant(test::random_crank_rocker(random, 9, 1), 1);
>>>>>>> 4d5ca09
  PathRoot broken = planted.root;
  broken.second.moving = std::nan("");
  EXPECT_FALSE(certify(planted.system, broken).certified);
  broken = planted.root;
  broken.rotations.pop_back();
  EXPECT_FALSE(certify(planted.system, broken).certified);
  broken = planted.root;
  broken.rotations[3] = 0;
  EXPECT_FALSE(certify(planted.system, broken).certified);
}

/// Both dyads in one place: a link that turns about a fixed pivot, its equations doubled.
TEST(Certificate, IsRefusedToSingularRoots) {
  std::mt19937_64 random(11);
<<<<<<< HEAD
  PlantedRoot planted = plant(planting::random_crank_rocker(random, 9, 1), 1);
=======
  PlantedRoot planted = plant(test::random_crank_rocker(random, 9, 1), 1);
>>>>>>> 4d5ca09
  planted.root.second = planted.root.first;
  EXPECT_FALSE(certify(planted.system, planted.root).certified);
}

TEST(Certificate, HoldsForCognates) {
  std::mt19937_64 random(12);
<<<<<<< HEAD
  const PlantedRoot planted = plant(planting::random_crank_rocker(random, 9, 1), 1);
=======
  const PlantedRoot planted = plant(test::random_crank_rocker(random, 9, 1), 1);
>>>>>>> 4d5ca09
  const PathRoot cognate = next_cognate(planted.system, planted.root);
  EXPECT_TRUE(certify(planted.system, cognate).real);
}

TEST(Overlap, NamesOneRootGivenTwiceAndCognates) {
  std::mt19937_64 random(13);
<<<<<<< HEAD
  const PlantedRoot planted = plant(planting::random_crank_rocker(random, 9, 1), 1);
=======
  const PlantedRoot planted = plant(test::random_crank_rocker(random, 9, 1), 1);
>>>>>>> 4d5ca09
  const PathRoot second = next_cognate(planted.system, planted.root);
  const PathRoot third = next_cognate(planted.system, second);
  PathRoot swapped = planted.root;
  std::swap(swapped.first, swapped.second);
  std::vector<RootCertificate> all;
  for (const PathRoot& root : {planted.root, planted.root, second, third, swapped}) {
    all.push_back(certify(planted.system, root));
    ASSERT_TRUE(all.back().certified);
  }
  const auto pairs = overlapping(all, RootSymmetry::none);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0], (std::array{0, 1}));
  EXPECT_EQ(count_distinct(all, RootSymmetry::none), 4);
  EXPECT_EQ(count_distinct(all, RootSymmetry::swapped_dyads), 3);
  EXPECT_EQ(count_distinct(all, RootSymmetry::cognates), 1);
}

}  // namespace
}  // namespace cognate::synthesis::certificate_test
