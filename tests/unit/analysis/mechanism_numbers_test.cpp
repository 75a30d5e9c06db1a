/// The same chains over other number types: dual numbers, SIMD packs, 113 bits.
#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <xsimd/xsimd.hpp>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/mechanism/convert.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "tests/support/random_chains.hpp"

namespace cognate::mechanism_numbers_test {
namespace {

using boost::multiprecision::cpp_bin_float_quad;
using test::ChainMaker;

/// A mechanism over T at a position of its drive.
template <int Order, class T>
std::vector<BodyMotion<T, Order>> moved(const Mechanism<T>& mechanism,
                                        const DrivePosition<T>& drive,
                                        const std::vector<double>& signs) {
  const std::vector<T> sides(signs.begin(), signs.end());
  std::vector<BodyMotion<T, Order>> bodies(static_cast<std::size_t>(body_count(mechanism)));
  std::vector<DyadClosure<T>> closures(mechanism.dyads.size());
  evaluate<Order>(mechanism, drive, sides, bodies, closures);
  return bodies;
}

template <class T>
DrivePosition<T> drive_at(double q) {
  return {{T(std::cos(q)), T(std::sin(q))}, T(q)};
}

/// Every chain of two dyads, each drive in turn.
template <class Check>
void for_chains(unsigned seed, Check&& check) {
  ChainMaker maker(seed);
  for (int drive = 0; drive < 3; ++drive) {
    for (int types = 0; types < 25; ++types) check(maker.make(drive, {types / 5, types % 5}));
  }
}

/// A change of the dimensions: each moves by its own weight times t.
class Weights {
 public:
  double operator()() {
    state_ = state_ * 16807 % 2147483647;
    return static_cast<double>(state_) / 2147483647.0 - 0.5;
  }

 private:
  std::int64_t state_ = 12345;
};

TEST(MechanismNumbers, JetsOfTheDimensionsEqualDifferencesOf113Bits) {
  using Jet = ceres::Jet<double, 1>;
  using Quad = cpp_bin_float_quad;
  for_chains(41, [](const Mechanism<double>& mechanism) {
    const auto signs = sides(mechanism);
    const auto jets = convert<Jet>(mechanism, [weight = Weights()](double x) mutable {
      Jet jet(x);
      jet.v[0] = weight();
      return jet;
    });
    const auto changed = [&](const Quad& t) {
      return moved<2, Quad>(convert<Quad>(mechanism,
                                          [&t, weight = Weights()](double x) mutable {
                                            return Quad(Quad(x) + t * Quad(weight()));
                                          }),
                            drive_at<Quad>(ChainMaker::kStart), signs);
    };
    const Quad step = 1e-10;
    const auto after = changed(step), before = changed(-step);
    const auto bodies = moved<2, Jet>(jets, drive_at<Jet>(ChainMaker::kStart), signs);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto compare = [&](const Jet& jet, const Quad& plus, const Quad& minus) {
        const auto expected = static_cast<double>(Quad((plus - minus) / (2 * step)));
        EXPECT_NEAR(jet.v[0], expected, 1e-9 * (1 + std::abs(expected) + std::abs(jet.a)));
      };
      for (std::size_t k = 0; k <= 2; ++k) {
        compare(bodies[i].origin[k].x, after[i].origin[k].x, before[i].origin[k].x);
        compare(bodies[i].origin[k].y, after[i].origin[k].y, before[i].origin[k].y);
      }
      compare(bodies[i].turn[1], after[i].turn[1], before[i].turn[1]);
      compare(bodies[i].direction.x, after[i].direction.x, before[i].direction.x);
    }
  });
}

TEST(MechanismNumbers, LanesOfAPackEqualTheScalar) {
  using Pack = xsimd::batch<double>;
  constexpr std::size_t kLanes = Pack::size;
  for_chains(43, [](const Mechanism<double>& mechanism) {
    std::array<double, kLanes> c{}, s{}, q{};
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      q[lane] = ChainMaker::kStart + 0.01 * static_cast<double>(lane);
      c[lane] = std::cos(q[lane]);
      s[lane] = std::sin(q[lane]);
    }
    const DrivePosition<Pack> drive{
        {Pack::load_unaligned(c.data()), Pack::load_unaligned(s.data())},
        Pack::load_unaligned(q.data())};
    const auto packs = moved<3, Pack>(convert<Pack>(mechanism), drive, sides(mechanism));
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      MechanismMotion<3> scalar(mechanism);
      scalar.move_to(DrivePosition<double>{{c[lane], s[lane]}, q[lane]});
      for (std::size_t i = 0; i < packs.size(); ++i) {
        EXPECT_EQ(packs[i].direction.x.get(lane), scalar.bodies()[i].direction.x);
        EXPECT_EQ(packs[i].origin[0].y.get(lane), scalar.bodies()[i].origin[0].y);
        EXPECT_EQ(packs[i].origin[3].x.get(lane), scalar.bodies()[i].origin[3].x);
        EXPECT_EQ(packs[i].turn[2].get(lane), scalar.bodies()[i].turn[2]);
      }
    }
  });
}

/// The joint C of a four-bar with 113 bits by circle and circle, from a direction of the crank as
/// it is, made a unit vector.
Vec2<cpp_bin_float_quad> reference_joint(const FourBar& linkage, const Vec2d& crank) {
  using Quad = cpp_bin_float_quad;
  const Quad norm = sqrt(Quad(crank.x) * crank.x + Quad(crank.y) * crank.y);
  const Vec2<Quad> b{linkage.pivot_a.x + linkage.crank * Quad(crank.x) / norm,
                     linkage.pivot_a.y + linkage.crank * Quad(crank.y) / norm};
  const Vec2<Quad> d = Vec2<Quad>{linkage.pivot_d.x, linkage.pivot_d.y} - b;
  const Quad square = squared_norm(d), l2 = linkage.coupler, l3 = linkage.rocker;
  const Quad along = (square + l2 * l2 - l3 * l3) / (2 * square);
  const Quad height = sqrt(Quad(l2 * l2 / square - along * along));
  return b + Vec2<Quad>{along, Quad(sign(linkage.assembly) * height)} * d;
}

struct ChangePointCase {
  const char* name;
  FourBar linkage;
  double towards;  ///< direction of the crank at the change point
};

/// Near a change point the rounding of d² would cost half the digits; the crank's dyad keeps them.
TEST(MechanismNumbers, ACrankKeepsItsDigitsNearChangePoints) {
  const double eps = std::numeric_limits<double>::epsilon();
  const double tilt = std::atan2(4.0, 3.0);
  const std::vector<ChangePointCase> cases{
      {"parallelogram", {{0, 0}, {3, 0}, 1, 3, 1, Assembly::open, {}}, 0},
      {"tilted parallelogram", {{0, 0}, {3, 4}, 2, 5, 2, Assembly::open, {}}, tilt},
      {"tilted and away", {{9, -7}, {12, -3}, 2, 5, 2, Assembly::crossed, {}}, tilt},
      {"antiparallelogram", {{0, 0}, {3, 0}, 1, 3, 1, Assembly::crossed, {}}, std::acos(-1.0)},
      {"kite", {{0, 0}, {2, 0}, 2, 3, 3, Assembly::open, {}}, 0}};
  for (const ChangePointCase& c : cases) {
    MechanismMotion<0> motion(as_mechanism(c.linkage));
    for (double away = 1e-1; away > 1e-9; away /= 7) {
      for (const double angle : {c.towards + away, c.towards - away}) {
        const DrivePosition<double> drive = drive_position(motion.mechanism(), angle);
        ASSERT_TRUE(motion.move_to(drive));
        const auto expected = reference_joint(c.linkage, drive.direction);
        const Vec2d joint = motion.point({2, {c.linkage.coupler, 0}})[0];
        const Vec2d other = motion.point({3, {c.linkage.rocker, 0}})[0];
        for (const Vec2d& found : {joint, other}) {
          EXPECT_LE(std::abs(static_cast<double>(found.x - expected.x)), 20 * eps)
              << c.name << " " << away;
          EXPECT_LE(std::abs(static_cast<double>(found.y - expected.y)), 20 * eps)
              << c.name << " " << away;
        }
      }
    }
  }
}

/// A four-bar as a chain is the four-bar of `Motion`, and the same with its dyad turned round.
TEST(MechanismNumbers, AFourBarIsAChainOfOneDyad) {
  int tested = 0;
  ChainMaker random(3);
  for (int i = 0; i < 2000; ++i) {
    const FourBar linkage{{random.uniform(-3, 3), random.uniform(-3, 3)},
                          {random.uniform(-3, 3), random.uniform(-3, 3)},
                          random.uniform(0.3, 3),
                          random.uniform(0.3, 3),
                          random.uniform(0.3, 3),
                          i % 2 == 0 ? Assembly::open : Assembly::crossed,
                          {}};
    const double angle = random.uniform(-4, 4);
    const auto pose = Motion(linkage).at(angle);
    Mechanism<double> chain = as_mechanism(linkage);
    auto& dyad = std::get<Rrr<double>>(chain.dyads[0]);
    MechanismMotion<0> motion(chain);
    std::swap(dyad.first, dyad.second);
    std::swap(dyad.first_length, dyad.second_length);
    dyad.assembly = linkage.assembly == Assembly::open ? Assembly::crossed : Assembly::open;
    MechanismMotion<0> turned(chain);
    ASSERT_EQ(motion.move_to(angle), pose.has_value());
    ASSERT_EQ(turned.move_to(angle), pose.has_value());
    if (!pose || motion.closures()[0].discriminant < 1e-3) continue;
    ++tested;
    for (const Vec2d& c :
         {motion.point({3, {linkage.rocker, 0}})[0], turned.point({2, {linkage.rocker, 0}})[0]}) {
      EXPECT_NEAR(c.x, pose->c.x, 1e-13);
      EXPECT_NEAR(c.y, pose->c.y, 1e-13);
    }
    EXPECT_NEAR(motion.closures()[0].cosine, std::cos(pose->transmission_angle), 1e-13);
    EXPECT_NEAR(motion.closures()[0].sine,
                sign(linkage.assembly) * std::sin(pose->transmission_angle), 1e-13);
  }
  EXPECT_GE(tested, 710);
}

/// A dyad on the crank's pin and a point of the frame that is the crank's own pivot turns with it.
TEST(MechanismNumbers, ADyadAboutTheCrankPivotIsATriangle) {
  MechanismMotion<2> motion(as_mechanism({{1, 2}, {1, 2}, 3, 4, 5, Assembly::open, {}}));
  ASSERT_TRUE(motion.move_to(0.4));
  EXPECT_NEAR(motion.closures()[0].cosine, (16.0 + 25 - 9) / 40, 1e-15);
  EXPECT_NEAR(motion.bodies()[3].turn[0], 1, 1e-14);
  EXPECT_NEAR(motion.bodies()[2].turn[1], 0, 1e-14);
}

}  // namespace
}  // namespace cognate::mechanism_numbers_test
