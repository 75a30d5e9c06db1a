#include "synthesis/exact/motion/guided_mechanism.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "analysis/mechanism/kinematics.hpp"
#include "synthesis/exact/motion/three_poses.hpp"

namespace cognate::synthesis::guided_mechanism_test {
namespace {

using Poses = std::array<Pose, 3>;

struct Random {
  std::mt19937_64 engine;
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  Vec2d vector(double size) { return {(*this)(-size, size), (*this)(-size, size)}; }
  Vec2d direction() {
    const double angle = (*this)(0, 6.28);
    return {std::cos(angle), std::sin(angle)};
  }
};

Poses random_poses(Random& random) {
  Poses poses;
  for (Pose& pose : poses) pose = {random.vector(2), random(-3, 3)};
  return poses;
}

/// A dyad of the kind through three poses.
GuidingDyad dyad_of(DyadKind kind, const Poses& poses, Random& random) {
  DyadSolutions found;
  if (kind == DyadKind::rr) found = dyads_with_moving_pivot(poses, random.vector(2));
  if (kind == DyadKind::pr) found = dyads_with_slide_direction(poses, random.direction());
  if (kind == DyadKind::rp) found = dyads_with_line_direction(poses, random.direction());
  EXPECT_EQ(found.status, GuidanceStatus::found);
  return found.storage[0];
}

/// The greatest distance of the body's points (0, 0) and (1, 0) from where the pose has them, the
/// chain being moved to where it is said to stand there.
double greatest_error(const GuidedMechanism& guided, const Poses& poses) {
  MechanismMotion<0> motion(guided.chain);
  double greatest = 0;
  for (std::size_t j = 0; j < poses.size(); ++j) {
    const DriveStation& at = guided.stations[j];
    if (!motion.sides().empty()) motion.sides()[0] = sign(at.side);
    if (!motion.move_to(at.drive)) return 1e300;
    for (const Vec2d& p : {Vec2d{0, 0}, Vec2d{1, 0}}) {
      const Vec2d in_link = to_frame(guided.body_in_link, p);
      const Vec2d stands = motion.point({guided.body, in_link})[0];
      greatest = std::max(greatest, norm(stands - to_frame(poses[j], p)));
    }
  }
  return greatest;
}

/// Every pair of kinds makes a mechanism which, simulated by the kernel, takes the body through its
/// poses.
TEST(GuidedMechanism, StandsAtItsPoses) {
  constexpr std::array kinds{DyadKind::rr, DyadKind::pr, DyadKind::rp};
  Random random{std::mt19937_64(7)};
  for (int trial = 0; trial < 300; ++trial) {
    const Poses poses = random_poses(random);
    for (const DyadKind first : kinds) {
      for (const DyadKind second : kinds) {
        const GuidingDyad a = dyad_of(first, poses, random), b = dyad_of(second, poses, random);
        const GuidedMechanism guided = guided_mechanism(a, b, poses);
        ASSERT_EQ(guided.fault, PairingFault::none);
        ASSERT_EQ(guided.stations.size(), poses.size());
        const double size = 1 + a.length + b.length + norm(a.in_body) + norm(b.in_body) +
                            norm(a.fixed) + norm(b.fixed);
        const double condition = std::max(a.condition, b.condition) * size;
        EXPECT_LT(greatest_error(guided, poses), 1e-12 * condition * condition)
            << "kinds " << int(first) << ' ' << int(second) << ", trial " << trial;
      }
    }
  }
}

TEST(GuidedMechanism, HasTheTypeThatItsDyadsMake) {
  Random random{std::mt19937_64(8)};
  const Poses poses = random_poses(random);
  const auto type = [&](DyadKind first, DyadKind second) {
    return guided_mechanism(dyad_of(first, poses, random), dyad_of(second, poses, random), poses)
        .type;
  };
  using enum DyadKind;
  EXPECT_TRUE(std::holds_alternative<FourBar>(type(rr, rr)));
  EXPECT_TRUE(std::holds_alternative<SliderCrank>(type(rr, pr)));
  EXPECT_TRUE(std::holds_alternative<SliderCrank>(type(pr, rr)));
  EXPECT_TRUE(std::holds_alternative<OscillatingBlock>(type(rp, rr)));
  EXPECT_TRUE(std::holds_alternative<EllipticTrammel>(type(pr, pr)));
  EXPECT_TRUE(std::holds_alternative<OldhamCoupling>(type(rp, rp)));
  EXPECT_TRUE(std::holds_alternative<Mechanism<double>>(type(rp, pr)));
}

TEST(GuidedMechanism, NamesWhyTwoDyadsMakeNone) {
  Random random{std::mt19937_64(9)};
  const Poses poses = random_poses(random);
  const GuidingDyad link = dyad_of(DyadKind::rr, poses, random);
  EXPECT_EQ(guided_mechanism(link, link, poses).fault, PairingFault::shared_moving_pivot);
  const GuidingDyad aside = rr_dyad(poses, link.in_body + Vec2d{1, 0}, link.fixed);
  EXPECT_EQ(guided_mechanism(link, aside, poses).fault, PairingFault::shared_fixed_pivot);
  const GuidingDyad pin = rr_dyad(std::span(poses).first(1), {}, poses[0].at);
  EXPECT_EQ(guided_mechanism(pin, link, poses).fault, PairingFault::no_link);
  const GuidingDyad slider = dyad_of(DyadKind::pr, poses, random);
  EXPECT_EQ(guided_mechanism(slider, slider, poses).fault, PairingFault::parallel_lines);
  EXPECT_TRUE(guided_mechanism(slider, slider, poses).stations.empty());
}

}  // namespace
}  // namespace cognate::synthesis::guided_mechanism_test
