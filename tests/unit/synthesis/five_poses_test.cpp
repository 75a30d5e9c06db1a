#include "synthesis/exact/motion/five_poses.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "analysis/linkage/double_slider.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/guide_bar.hpp"
#include "analysis/linkage/slider_crank.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/count_allocations.hpp"

namespace cognate::synthesis::five_poses_test {
namespace {

constexpr double degree = kPi / 180;
using Poses = std::array<Pose, 5>;

/// What rounding of the poses may do, relative to their extent, before the condition.
constexpr double rounding = 2e-15;

struct Random {
  std::mt19937_64 engine;
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  Vec2d vector(double size) { return {(*this)(-size, size), (*this)(-size, size)}; }
};

/// The poses of body `number` of a chain at drive positions, the guided body's origin at `origin`.
std::optional<Poses> poses_of(const Mechanism<double>& chain, std::size_t number,
                              const std::array<double, 5>& drive, const Vec2d& origin,
                              double angle) {
  MechanismMotion<0> motion(chain);
  Poses poses;
  for (std::size_t j = 0; j < 5; ++j) {
    if (!motion.move_to(drive[j])) return std::nullopt;
    const auto& body = motion.bodies()[number];
    poses[j].at = motion.point({static_cast<int>(number), origin})[0];
    poses[j].angle = std::atan2(body.direction.y, body.direction.x) + angle;
  }
  return poses;
}

double distance(const Vec2d& a, const Vec2d& b) {
  return norm(a - b);
}

/// Whether a dyad with these pivots, as they stand at the first pose, is among those found, within
/// rounding times its condition.
[[nodiscard]] bool has_link(const DyadSolutions& found, const Vec2d& moving, const Vec2d& fixed,
                            double size) {
  for (const GuidingDyad& dyad : found.dyads()) {
    if (dyad.kind != DyadKind::rr) continue;
    const double error = distance(dyad.moving, moving) + distance(dyad.fixed, fixed);
    if (error <= 100 * rounding * dyad.condition * size) return true;
  }
  return false;
}

/// As above for a slide: the kind, the line's direction up to its sense, and for a slider its
/// pivot.
[[nodiscard]] bool has_slide(const DyadSolutions& found, DyadKind kind, const Vec2d& pivot,
                             const Vec2d& direction, double size) {
  for (const GuidingDyad& dyad : found.dyads()) {
    if (dyad.kind != kind) continue;
    const Vec2d& at = kind == DyadKind::pr ? dyad.moving : dyad.fixed;
    const double error = distance(at, pivot) + size * std::abs(cross(dyad.direction, direction));
    if (error <= 100 * rounding * dyad.condition * size) return true;
  }
  return false;
}

void expect_small_residuals(const DyadSolutions& found, const Poses& poses) {
  for (const GuidingDyad& dyad : found.dyads()) {
    EXPECT_LE(dyad.residual, 4 * rounding * (1 + dyad.condition));
    EXPECT_LE(dyad.residual, 1e-12);
    EXPECT_EQ(dyad.residual, guidance_residual(dyad, poses));
  }
}

std::array<double, 5> five_of(double start, double way) {
  return {start, start + 0.3 * way, start + 0.5 * way, start + 0.8 * way, start + way};
}

/// Answer first: a four-bar, five poses of its coupler, and the four-bar again.
TEST(FivePoses, RecoverPlantedFourBars) {
  int tested = 0;
  Random random{std::mt19937_64(1)};
  int tried = 0;
  std::array<int, 5> counts{};
  while (tried < 4000) {
    const FourBar linkage{random.vector(3), random.vector(3), random(0.3, 3), random(0.3, 3),
                          random(0.3, 3),   Assembly::open,   std::nullopt};
    const auto drive = five_of(random(0, 6.28), random(0.5, 5));
    const auto chain = as_mechanism(linkage);
    const auto poses = poses_of(chain, 2, drive, random.vector(2), random(0, 6));
    if (!poses) continue;
    ++tested;
    MechanismMotion<0> motion(chain);
    motion.move_to(drive[0]);
    const Vec2d b = motion.bodies()[2].origin[0], c = motion.point({2, {linkage.coupler, 0}})[0];
    const DyadSolutions found = dyads_of_five_poses(*poses);
    ASSERT_EQ(found.status, GuidanceStatus::found);
    expect_small_residuals(found, *poses);
    ++counts[static_cast<std::size_t>(found.count)];
    EXPECT_TRUE(has_link(found, b, linkage.pivot_a, 6)) << tried;
    EXPECT_TRUE(has_link(found, c, linkage.pivot_d, 6)) << tried;
    ++tried;
  }
  EXPECT_EQ(counts[1] + counts[3], 0);  // complex dyads come in pairs
  EXPECT_GT(counts[2], 400);
  EXPECT_GT(counts[4], 400);
  EXPECT_GE(tested, 3600);
}

TEST(FivePoses, RecoverPlantedSliderCranks) {
  int tested = 0;
  Random random{std::mt19937_64(2)};
  for (int tried = 0; tried < 2000;) {
    const double angle = random(0, 6.28);
    const SliderCrank linkage{random.vector(2),
                              random(0.3, 3),
                              random(0.3, 3),
                              random(-1, 1),
                              {std::cos(angle), std::sin(angle)},
                              Assembly::open};
    const auto drive = five_of(random(0, 6.28), random(0.5, 5));
    const auto chain = as_mechanism(linkage);
    const auto poses = poses_of(chain, 2, drive, random.vector(2), random(0, 6));
    if (!poses) continue;
    ++tested;
    MechanismMotion<0> motion(chain);
    motion.move_to(drive[0]);
    const Vec2d b = motion.bodies()[2].origin[0], c = motion.point({2, {linkage.coupler, 0}})[0];
    const DyadSolutions found = dyads_of_five_poses(*poses);
    EXPECT_TRUE(has_link(found, b, linkage.pivot, 6)) << tried;
    EXPECT_TRUE(has_slide(found, DyadKind::pr, c, linkage.direction, 6)) << tried;
    expect_small_residuals(found, *poses);
    ++tried;
  }
  EXPECT_GE(tested, 1800);
}

TEST(FivePoses, RecoverPlantedOscillatingBlocks) {
  int tested = 0;
  Random random{std::mt19937_64(3)};
  for (int tried = 0; tried < 2000;) {
    const OscillatingBlock linkage{random.vector(2), random.vector(2), random(0.3, 3),
                                   random(-1, 1), Assembly::open};
    const auto drive = five_of(random(0, 6.28), random(0.5, 5));
    const auto chain = as_mechanism(linkage);
    const double angle = random(0, 6);
    const auto poses = poses_of(chain, 3, drive, random.vector(2), angle);
    if (!poses) continue;
    ++tested;
    MechanismMotion<0> motion(chain);
    motion.move_to(drive[0]);
    const DyadSolutions found = dyads_of_five_poses(*poses);
    const Vec2d rod{std::cos(angle), -std::sin(angle)};
    EXPECT_TRUE(has_link(found, motion.bodies()[3].origin[0], linkage.pivot_a, 6)) << tried;
    EXPECT_TRUE(has_slide(found, DyadKind::rp, linkage.pivot_c, rod, 6)) << tried;
    expect_small_residuals(found, *poses);
    ++tried;
  }
  EXPECT_GE(tested, 1800);
}

/// The McCarthy challenge (ASME DETC 2002), eleven poses as used by Hayes et al. 2004.
constexpr std::array<std::array<double, 3>, 11> challenge{{{-1.0, -1.0, 90.0},
                                                           {-1.239, -0.5529, 77.3621},
                                                           {-1.4204, 0.3232, 55.0347},
                                                           {-1.1668, 1.2858, 30.1974},
                                                           {-0.5657, 1.8871, 10.021},
                                                           {-0.0292, 1.9547, 1.712},
                                                           {0.2632, 1.5598, 10.03},
                                                           {0.5679, 0.9339, 30.1974},
                                                           {1.0621, 0.3645, 55.0346},
                                                           {1.6311, 0.0632, 77.362},
                                                           {2.0, 0.0, 90.0}}};

Poses challenge_poses(const std::array<int, 5>& numbers) {
  Poses poses;
  for (std::size_t j = 0; j < 5; ++j) {
    const auto& pose = challenge[static_cast<std::size_t>(numbers[j] - 1)];
    poses[j] = {{pose[0], pose[1]}, pose[2] * degree};
  }
  return poses;
}

/// All real dyads of five of them, found once from 24000 starts of Newton's method.
struct ChallengeDyads {
  std::array<int, 5> numbers;
  std::array<std::array<double, 5>, 2> dyads;  ///< fixed pivot, moving pivot (body axes), length
};
const std::array<ChallengeDyads, 5> subsets{
    {{{1, 3, 6, 9, 11},
      {{{0.7857898802, 0.3776115027, 1.5694242624, -0.0551856269, 1.7412016586},
        {2.2140298007, 1.6225815108, 1.4304956917, -1.9447250738, 1.7413222246}}}},
     {{1, 4, 6, 8, 11},
      {{{0.7761715921, 0.3882805885, 1.5551802344, -0.0538717102, 1.7303676994},
        {2.2235815778, 1.6119561509, 1.4445851881, -1.9460385654, 1.7305695922}}}},
     {{2, 4, 6, 8, 10},
      {{{0.7707950381, 0.41114103, 1.5336846913, -0.0632645288, 1.693865849},
        {2.2289576787, 1.5891595344, 1.4660845079, -1.9366217467, 1.694102009}}}},
     {{1, 2, 3, 4, 5},
      {{{0.884437044, 0.0454880087, 1.2974957944, -1.8995429736, 0.2524601219},
        {0.9017458766, 0.2990244493, 1.1005863555, -2.0708654196, 0.2607280132}}}},
     {{1, 3, 5, 7, 9},
      {{{0.7838384716, 0.3783124165, 1.5664757138, -0.0549266091, 1.7391209431},
        {2.2143916574, 1.6242351775, 1.430929465, -1.9448915798, 1.7422999083}}}}}};

TEST(FivePoses, SolveTheChallenge) {
  for (const ChallengeDyads& subset : subsets) {
    const Poses poses = challenge_poses(subset.numbers);
    const DyadSolutions found = dyads_of_five_poses(poses);
    ASSERT_EQ(found.count, 2);
    for (const auto& d : subset.dyads) {
      const Vec2d moving = to_frame(poses[0], {d[2], d[3]});
      // Printed with ten decimals.
      const auto is_it = [&](const GuidingDyad& dyad) {
        return distance(dyad.moving, moving) < 3e-10 &&
               distance(dyad.fixed, {d[0], d[1]}) < 3e-10 && std::abs(dyad.length - d[4]) < 3e-10;
      };
      EXPECT_EQ(std::ranges::count_if(found.dyads(), is_it), 1);
    }
  }
}

TEST(FivePoses, AllocateNothing) {
  const Poses poses = challenge_poses({1, 3, 6, 9, 11});
  const std::size_t before = test::allocations();
  const DyadSolutions found = dyads_of_five_poses(poses);
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(found.count, 2);
}

Poses moved(Poses poses, const Vec2d& shift, double scale) {
  for (Pose& pose : poses) pose.at = scale * (pose.at + shift);
  return poses;
}

TEST(FivePoses, DoNotDependOnTheUnitOrTheOrigin) {
  const Poses poses = challenge_poses({1, 3, 6, 9, 11});
  const DyadSolutions plain = dyads_of_five_poses(poses);
  for (const double scale : {1e-12, 1e-3, 7.0, 1e12}) {
    const Vec2d shift{1024, -4096};  // what it costs the poses in digits it costs the dyads
    const DyadSolutions found = dyads_of_five_poses(moved(poses, shift, scale));
    ASSERT_EQ(found.count, plain.count);
    for (int k = 0; k < found.count; ++k) {
      const GuidingDyad &a = found.storage[std::size_t(k)], &b = plain.storage[std::size_t(k)];
      EXPECT_LT(distance((1 / scale) * a.fixed - shift, b.fixed), 1e-10);
      EXPECT_LT(distance((1 / scale) * a.in_body, b.in_body), 1e-10);
      EXPECT_NEAR(a.condition / b.condition, 1, 1e-9);
    }
  }
}

TEST(FivePoses, NameADegeneracy) {
  const Poses poses = challenge_poses({1, 3, 6, 9, 11});
  Poses twice = poses;
  twice[3] = twice[1];
  twice[3].angle += kTurn;
  EXPECT_EQ(dyads_of_five_poses(twice).status, GuidanceStatus::coincident_poses);
  Poses infinite = poses;
  infinite[2].at.x = INFINITY;
  EXPECT_EQ(dyads_of_five_poses(infinite).status, GuidanceStatus::not_finite);
}

TEST(FivePoses, NameATranslation) {
  Poses poses = challenge_poses({1, 3, 6, 9, 11});
  for (Pose& pose : poses) pose.angle = 0.7;
  const DyadSolutions scattered = dyads_of_five_poses(poses);
  EXPECT_EQ(scattered.status, GuidanceStatus::translation);
  EXPECT_EQ(scattered.count, 0);
  for (std::size_t j = 0; j < 5; ++j) {
    const double angle = 0.9 * static_cast<double>(j);
    poses[j].at = Vec2d{5, 6} + 2.0 * Vec2d{std::cos(angle), std::sin(angle)};
  }
  const DyadSolutions circle = dyads_of_five_poses(poses);
  EXPECT_EQ(circle.status, GuidanceStatus::translation);
  ASSERT_EQ(circle.count, 2);
  for (const GuidingDyad& link : circle.dyads()) {
    EXPECT_NEAR(link.length, 2, 1e-14);
    EXPECT_LT(link.residual, 1e-14);
  }
  for (std::size_t j = 0; j < 5; ++j) poses[j].at = Vec2d{1, 2} + double(j * j) * Vec2d{3, 1};
  const DyadSolutions line = dyads_of_five_poses(poses);
  EXPECT_EQ(line.status, GuidanceStatus::translation);
  ASSERT_EQ(line.count, 1);
  EXPECT_EQ(line.storage[0].kind, DyadKind::pr);
}

TEST(FivePoses, NameATurnAboutOnePoint) {
  Poses poses;
  const Vec2d centre{3, -2};
  for (std::size_t j = 0; j < 5; ++j) {
    const double angle = 0.4 * static_cast<double>(j * j);
    poses[j] = {centre + Vec2d{std::cos(angle), std::sin(angle)} * Vec2d{2, 1}, angle};
  }
  const DyadSolutions found = dyads_of_five_poses(poses);
  EXPECT_EQ(found.status, GuidanceStatus::rotation);
  ASSERT_EQ(found.count, 1);
  EXPECT_LT(distance(found.storage[0].fixed, centre), 1e-14);
  EXPECT_LT(found.storage[0].length, 1e-14);
}

/// Cardan's motion: every point of a circle of the trammel's link moves on a straight line, and the
/// middle of the link on a circle about the centre.
TEST(FivePoses, FindAFamilyInCardanMotion) {
  const EllipticTrammel trammel{{1, 2}, 3, {1, 0}, {0, 1}};
  const Vec2d origin{0.3, 0.4};
  const auto poses = poses_of(as_mechanism(trammel), 1, {0.1, 0.6, 1.3, 2.2, 2.9}, origin, 0.5);
  ASSERT_TRUE(poses);
  const Vec2d middle = Vec2d{std::cos(0.5), -std::sin(0.5)} * (Vec2d{1.5, 0} - origin);
  const DyadSolutions found = dyads_of_five_poses(*poses);
  EXPECT_EQ(found.status, GuidanceStatus::family);
  int sliders = 0;
  for (const GuidingDyad& dyad : found.dyads()) {
    EXPECT_LT(dyad.residual, 1e-13);
    sliders += dyad.kind == DyadKind::pr;
  }
  EXPECT_GE(sliders, 2);
  EXPECT_EQ(sliders + 1, found.count);
  EXPECT_TRUE(has_link(found, to_frame((*poses)[0], middle), trammel.centre, 3));
}

/// One run of Newton's method on the four distances from a random start, to a well determined dyad.
std::optional<GuidingDyad> by_newton(const Poses& poses, Random& random) {
  Vec2d w = random.vector(4), g = random.vector(4);
  for (int step = 0; step < 60; ++step) {
    const GuidingDyad here = rr_dyad(poses, w, g);
    const auto unit = [&](std::size_t j) {
      return Vec2d{std::cos(poses[j].angle), std::sin(poses[j].angle)};
    };
    const Vec2d from = here.moving - g;
    Eigen::Vector4d value;
    Eigen::Matrix4d slope;
    for (std::size_t j = 1; j < 5; ++j) {
      const Vec2d to = to_frame(poses[j], w) - g;
      const Vec2d by_body = conj(unit(j)) * to - conj(unit(0)) * from;
      const auto row = static_cast<Eigen::Index>(j - 1);
      value[row] = 0.5 * (squared_norm(to) - squared_norm(from));
      slope.row(row) << by_body.x, by_body.y, from.x - to.x, from.y - to.y;
    }
    const Eigen::Vector4d change = slope.fullPivLu().solve(value);
    w = w - Vec2d{change[0], change[1]};
    g = g - Vec2d{change[2], change[3]};
    const double size = 1 + norm(w) + norm(g);
    if (change.norm() <= 1e-13 * size) {
      const bool is_sound = slope.norm() * slope.inverse().norm() < 1e8 && size < 1e4;
      return is_sound ? std::optional(here) : std::nullopt;
    }
  }
  return std::nullopt;
}

/// Poses on a grid, with equal turns and half turns and translations among them: no matter what
/// Newton's method comes upon is among the dyads, and all dyads are finite and fit.
TEST(FivePoses, LeaveNothingOutOnAGrid) {
  Random random{std::mt19937_64(4)};
  int checked = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const double step = std::array{90 * degree, 30 * degree, 0.1}[std::size_t(trial % 3)];
    Poses poses;
    for (Pose& pose : poses) {
      pose = {{std::floor(random(0, 4)), std::floor(random(0, 4))},
              step * std::floor(random(0, 7))};
    }
    const DyadSolutions found = dyads_of_five_poses(poses);
    for (const GuidingDyad& dyad : found.dyads()) {
      EXPECT_TRUE(std::isfinite(norm(dyad.in_body) + norm(dyad.fixed) + dyad.condition));
      EXPECT_LT(dyad.residual, 1e-11);
    }
    const bool is_complete =
        found.status == GuidanceStatus::found || found.status == GuidanceStatus::none;
    for (int start = 0; is_complete && start < 10; ++start) {
      const auto dyad = by_newton(poses, random);
      if (!dyad) continue;
      ++checked;
      const bool is_there = std::ranges::any_of(found.dyads(), [&](const GuidingDyad& other) {
        return distance(other.in_body, dyad->in_body) + distance(other.fixed, dyad->fixed) <
               1e-5 * (1 + norm(dyad->in_body) + norm(dyad->fixed));
      });
      EXPECT_TRUE(is_there) << "trial " << trial;
    }
  }
  EXPECT_GT(checked, 3000);
}

}  // namespace
}  // namespace cognate::synthesis::five_poses_test
