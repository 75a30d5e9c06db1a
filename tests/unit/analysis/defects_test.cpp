/// Defects distinguished by link lengths, held against linkages that are moved step by step.
#include "analysis/linkage/defects.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::defects_test {
namespace {

constexpr double pi = kPi;
constexpr double degree = pi / 180;

/// Angles of crank, coupler and rocker from A→D.
using Angles = std::array<double, 3>;

Vec2d along(double angle, double length) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

/// One circuit, traced from a configuration on it until it returns: the closure
/// l₁e₁ + l₂e₂ = l₄ + l₃e₃ is followed along its tangent in steps of 0.02 rad, each brought back by
/// Newton's method. Shares no formula with the kernel.
std::vector<Angles> trace(const Lengths<double>& links, const Angles& start) {
  constexpr double step = 0.02;
  std::vector<Angles> path{start};
  Angles now = start;
  double farthest = 0;
  for (int i = 0; i < 20000; ++i) {
    for (int newton = -1; newton < 3; ++newton) {
      const Vec2d a = along(now[0], links.crank), b = along(now[1], links.coupler),
                  c = along(now[2], -links.rocker);
      const Vec2d gap = a + b + c - Vec2d{links.frame, 0};
      const Angles tangent{cross(b, c), cross(c, a), cross(a, b)};
      const double size = std::hypot(tangent[0], tangent[1], tangent[2]);
      if (newton < 0) {
        for (int k = 0; k < 3; ++k) now[k] += step * tangent[k] / size;
        continue;
      }
      // The least change of the angles that closes the gap: J δ = −gap with the columns i·a, i·b,
      // i·c of J, and δ in the span of its rows.
      const Vec2d columns[3] = {perp(a), perp(b), perp(c)};
      double xx = 0, xy = 0, yy = 0;
      for (const Vec2d& j : columns) xx += j.x * j.x, xy += j.x * j.y, yy += j.y * j.y;
      const double det = xx * yy - xy * xy;
      const Vec2d y{(yy * gap.x - xy * gap.y) / det, (xx * gap.y - xy * gap.x) / det};
      for (int k = 0; k < 3; ++k) now[k] -= dot(columns[k], y);
    }
    path.push_back(now);
    double distance = 0;
    for (int k = 0; k < 3; ++k) distance += std::abs(std::remainder(now[k] - start[k], 2 * pi));
    farthest = std::max(farthest, distance);
    if (farthest > 10 * step && distance < 1.5 * step) break;
  }
  return path;
}

/// Where on the path the configuration lies, or −1.
int find_on(const std::vector<Angles>& path, const Angles& wanted) {
  int best = -1;
  double least = 0.02;
  for (int i = 0; i < int(path.size()); ++i) {
    double distance = 0;
    for (int k = 0; k < 3; ++k) {
      const double turn = std::remainder(path[i][k] - wanted[k], 2 * pi);
      distance += turn * turn;
    }
    if (std::sqrt(distance) < least) {
      least = std::sqrt(distance);
      best = i;
    }
  }
  return best;
}

bool is_open_at(const Angles& angles) {
  return std::sin(angles[2] - angles[1]) > 0;
}

FourBar linkage_of(const Lengths<double>& links, Assembly side) {
  // Turned and shifted, so that crank angles from the x axis differ from those from A→D.
  return {{3, -1},
          Vec2d{3, -1} + along(0.7, links.frame),
          links.crank,
          links.coupler,
          links.rocker,
          side,
          {}};
}

std::optional<Angles> configuration(const Lengths<double>& links, const CrankPosition& at) {
  const FourBar linkage = linkage_of(links, at.side);
  const auto pose = Motion(linkage).at(at.crank_angle);
  if (!pose) return std::nullopt;
  const Vec2d bc = pose->c - pose->b, dc = pose->c - linkage.pivot_d;
  return Angles{at.crank_angle - 0.7, std::atan2(bc.y, bc.x) - 0.7, std::atan2(dc.y, dc.x) - 0.7};
}

/// What the trace says: indices along it in cyclic order, or, for one branch of a crank that does
/// not turn fully, in order between two dead points.
Defects traced_defects(const Lengths<double>& links, const std::vector<CrankPosition>& positions) {
  const auto path = trace(links, *configuration(links, positions[0]));
  Defects defects;
  std::vector<int> index;
  for (const auto& position : positions) {
    index.push_back(find_on(path, *configuration(links, position)));
    defects.circuit = defects.circuit || index.back() < 0;
    defects.branch = defects.branch || position.side != positions[0].side;
  }
  if (defects.circuit) return defects;
  const int length = int(path.size());
  int first = index[0];
  const bool is_cyclic = crank_rotates(links) || defects.branch;
  if (!is_cyclic) {
    // Count from the dead point before the first position.
    const bool open = is_open_at(path[first]);
    for (int i = 0; i < length && is_open_at(path[first]) == open; ++i) {
      first = (first + length - 1) % length;
    }
  }
  for (int& i : index) i = (i - first + length) % length;
  const auto from = index.begin() + (is_cyclic ? 1 : 0);
  defects.order =
      !std::is_sorted(from, index.end()) && !std::is_sorted(from, index.end(), std::greater<>());
  return defects;
}

TEST(Defects, AreThoseOfTheLinkageMovedStepByStep) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> length(0.2, 1.0), angle(-7.0, 7.0);
  std::array<int, 5> classes{};
  int circuit = 0, branch = 0, order = 0, sound = 0;
  for (int i = 0; i < 3000; ++i) {
    const Lengths<double> links{length(random), length(random), length(random), length(random)};
    if (!can_assemble(links) || std::abs(grashof_excess(links)) < 0.05) continue;
    const bool is_one_sided = random() % 3 != 0;
    std::vector<CrankPosition> positions;
    for (int k = 0; k < 400 && positions.size() < 4; ++k) {
      const CrankPosition at{angle(random),
                             is_one_sided || random() % 4 ? Assembly::crossed : Assembly::open};
      const auto angles = configuration(links, at);
      // Away from dead points and from one another, where the trace's step blurs what comes first.
      const bool is_distinct = std::ranges::all_of(positions, [&](const CrankPosition& other) {
        return std::abs(std::remainder(at.crank_angle - other.crank_angle, 2 * pi)) > 0.05;
      });
      if (is_distinct && angles && std::abs(std::sin((*angles)[2] - (*angles)[1])) > 0.1) {
        positions.push_back(at);
      }
    }
    if (positions.size() < 4) continue;
    if (random() % 2) std::ranges::sort(positions, {}, &CrankPosition::crank_angle);
    const FourBar linkage = linkage_of(links, Assembly::open);
    const Defects found =
        find_defects(linkage, std::span<const CrankPosition>(positions), Sequence::one_sense);
    EXPECT_EQ(found, traced_defects(links, positions))
        << std::hexfloat << links.crank << ", " << links.coupler << ", " << links.rocker << ", "
        << links.frame << " at " << positions[0].crank_angle << ", " << positions[1].crank_angle
        << ", " << positions[2].crank_angle << ", " << positions[3].crank_angle << " found "
        << found.circuit << found.branch << found.order;
    ++classes[std::size_t(mobility_class(links))];
    circuit += found.circuit;
    branch += found.branch && !found.circuit;
    order += found.order;
    sound += found == Defects{};
  }
  EXPECT_GT(std::ranges::min(classes), 20);
  EXPECT_GT(std::min({circuit, branch, order, sound}), 40);
}

TEST(Defects, ThirdPositionOfAPublishedDesignLiesOnTheOtherCircuit) {
  // Li & Xu 2011, examples 3-4 and 3-5: poses of the coupler and the pins found in its frame.
  const FourBar linkage{
      {0, 0},         {63, 0}, 9.858225975537877, 82.47790258744159, 29.940607204624833,
      Assembly::open, {}};
  const Vec2d pins[] = {{-40.65108354483429, -15.15287927906719},
                        {34.598405253638106, -48.918525293797614}};
  const Vec2d points[] = {{10, 32}, {36, 39}, {45, 24}};
  const double angles[] = {52, 29, 0};
  std::vector<CrankPosition> positions;
  for (int i = 0; i < 3; ++i) {
    const Vec2d turn = along(angles[i] * degree, 1);
    const Vec2d b = points[i] + turn * pins[0], c = points[i] + turn * pins[1];
    EXPECT_NEAR(std::hypot(b.x, b.y), linkage.crank, 1e-9);
    positions.push_back(position_of(linkage, b, c));
  }
  EXPECT_NEAR(positions[0].crank_angle / degree, -108.24654036669409, 1e-9);
  EXPECT_NEAR(positions[1].crank_angle / degree, 37.77632316229521, 1e-9);
  EXPECT_NEAR(positions[2].crank_angle / degree, 63.822979918472775, 1e-9);
  EXPECT_EQ(positions[1].side, Assembly::open);
  EXPECT_EQ(positions[2].side, Assembly::crossed);
  const std::span<const CrankPosition> all(positions);
  EXPECT_EQ(find_defects(linkage, all, Sequence::one_sense),
            (Defects{.circuit = true, .branch = true, .order = false}));
  EXPECT_EQ(find_defects(linkage, all.first(2), Sequence::one_sense), Defects{});
}

Defects of(const FourBar& linkage, std::vector<double> angles_deg, Sequence sequence) {
  for (double& angle : angles_deg) angle *= degree;
  return find_defects(linkage, angles_deg, sequence);
}

constexpr FourBar kCrankRocker{{0, 0}, {3, 0}, 1, 2.5, 2, Assembly::open, {}};
constexpr Defects kSound{}, kOrder{.circuit = false, .branch = false, .order = true},
    kCircuit{.circuit = true, .branch = false, .order = false};

TEST(Defects, ATurningCrankMayStartAnywhereAndEndWhereItBegan) {
  EXPECT_EQ(of(kCrankRocker, {200, 300, 40, 150}, Sequence::one_sense), kSound);
  EXPECT_EQ(of(kCrankRocker, {150, 40, 300, 200}, Sequence::one_sense), kSound);
  EXPECT_EQ(of(kCrankRocker, {200, 300, 40, 150, 200}, Sequence::one_sense), kSound);
  EXPECT_EQ(of(kCrankRocker, {200, 300, 40, 150, 199.9999999}, Sequence::one_sense), kSound);
  EXPECT_EQ(of(kCrankRocker, {200, 200.0000001, 200, 40, 150}, Sequence::one_sense), kSound);
  EXPECT_EQ(of(kCrankRocker, {200, 300, 40, 150, 210}, Sequence::one_sense), kOrder);
  EXPECT_EQ(of(kCrankRocker, {200, 40, 300, 150}, Sequence::one_sense), kOrder);
  EXPECT_EQ(of(kCrankRocker, {200, 40, 300, 150}, Sequence::any), kSound);
  EXPECT_EQ(of(kCrankRocker, {200, 40, 300, 150}, Sequence::timed), kSound);
}

TEST(Defects, ACrankThatDoesNotTurnMustNotCrossWhereTheLinkageIsOpen) {
  // Closes for |θ| ≤ 135.2°, where d = l₂ + l₃.
  const FourBar triple_rocker{{0, 0}, {2, 0}, 1, 1.3, 1.5, Assembly::crossed, {}};
  EXPECT_EQ(of(triple_rocker, {-130, 0, 130}, Sequence::one_sense), kSound);
  EXPECT_EQ(of(triple_rocker, {120, 0, 230}, Sequence::one_sense), kSound);
  EXPECT_EQ(of(triple_rocker, {120, 130, 230}, Sequence::one_sense), kOrder);
  EXPECT_EQ(of(triple_rocker, {120, 130, 230}, Sequence::any), kSound);
  EXPECT_EQ(of(triple_rocker, {120, 130, 230}, Sequence::timed), kOrder);
  EXPECT_EQ(of(triple_rocker, {130, 0, 40, -120}, Sequence::timed), kSound);
  EXPECT_EQ(of(triple_rocker, {120, 0, 180}, Sequence::any), kCircuit);
  EXPECT_EQ(of(triple_rocker, {120, 0, std::nan("")}, Sequence::any), kCircuit);
  // The coupler is the shortest link: two ranges, two circuits.
  const FourBar double_rocker{{0, 0}, {5, 0}, 3.5, 1, 3, Assembly::open, {}};
  ASSERT_EQ(mobility_class(lengths(double_rocker)), MobilityClass::double_rocker);
  const auto ranges = crank_ranges(lengths(double_rocker));
  ASSERT_EQ(ranges.size(), 2u);
  const double middle = (ranges[0].from + ranges[0].to) / 2 / degree;
  EXPECT_EQ(of(double_rocker, {middle, middle + 1}, Sequence::one_sense), kSound);
  EXPECT_EQ(of(double_rocker, {middle, -middle}, Sequence::one_sense), kCircuit);
}

TEST(Defects, RangeBetweenPositionsIsCountedFromTheFrame) {
  const FourBar triple_rocker = linkage_of({1, 1.3, 1.5, 2}, Assembly::crossed);
  const double angles[] = {0.7 - 0.5, 0.7 + 2 * pi + 0.25, 0.7 + 0.1};
  const auto range = range_between(triple_rocker, angles);
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->from, -0.5, 1e-12);
  EXPECT_NEAR(range->to, 0.25, 1e-12);
  const double open[] = {0.7, 0.7 + pi};
  EXPECT_FALSE(range_between(triple_rocker, open));
  EXPECT_FALSE(range_between(triple_rocker, {}));
}

TEST(Defects, CircuitsMeetAtAChangePoint) {
  const FourBar parallelogram{{0, 0}, {3, 0}, 1, 3, 1, Assembly::open, {}};
  const CrankPosition positions[] = {{1, Assembly::crossed}, {4, Assembly::open}};
  EXPECT_EQ(find_defects(parallelogram, positions, Sequence::one_sense),
            (Defects{.circuit = false, .branch = true, .order = false}));
}

}  // namespace
}  // namespace cognate::defects_test
