/// Batches of chains against the scalar evaluation, on every instruction set of the machine.
#include "analysis/batch/chain_batch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "tests/support/random_chains.hpp"

namespace cognate {
namespace {

using test::ChainMaker;

/// Room for one point, one body and one dyad, with all derivatives.
struct Results {
  explicit Results(std::size_t rows) : values(15, std::vector<double>(rows, -1)) {}

  ChainColumns columns(const Attached<double>& point, int body, int dyad) {
    ChainColumns wanted;
    PointColumns& p = wanted.points.emplace_back();
    BodyColumns& b = wanted.bodies.emplace_back();
    p.point = point;
    b.body = body;
    for (std::size_t k = 0; k < 4; ++k) {
      p.x[k] = values[k];
      p.y[k] = values[4 + k];
    }
    for (std::size_t k = 0; k < 3; ++k) b.turn[k] = values[8 + k];
    b.cos = values[11];
    b.sin = values[12];
    wanted.dyads.push_back({dyad, values[13], values[14]});
    return wanted;
  }

  std::vector<std::vector<double>> values;
};

std::vector<double> expected(const MechanismMotion<3>& motion, const Attached<double>& point,
                             int body, int dyad) {
  const auto p = motion.point(point);
  const auto& b = motion.bodies()[static_cast<std::size_t>(body)];
  const auto& d = motion.closures()[static_cast<std::size_t>(dyad)];
  return {p[0].x,    p[1].x,    p[2].x,    p[3].x,        p[0].y,        p[1].y, p[2].y,  p[3].y,
          b.turn[0], b.turn[1], b.turn[2], b.direction.x, b.direction.y, d.sine, d.cosine};
}

TEST(ChainBatch, EqualsTheScalarOnEveryInstructionSet) {
  ChainMaker maker(71);
  for (int drive = 0; drive < 3; ++drive) {
    for (int types = 0; types < 25; ++types) {
      const auto mechanism = maker.make(drive, {types / 5, types % 5});
      const int last = body_count(mechanism) - 1;
      const Attached<double> point{last, {0.4, -0.7}};
      for (const std::size_t rows : {1u, 5u, 8u, 21u}) {
        std::vector<double> drives(rows);
        for (double& q : drives) q = ChainMaker::kStart + maker.uniform(-1e-2, 1e-2);
        for (const InstructionSet set : instruction_sets()) {
          Results results(rows);
          const BatchStatus status = evaluate_batch(
              mechanism, sides(mechanism), DriveTable(mechanism, drives),
              results.columns(point, last - 1, 1), {.threads = 1, .instruction_set = set});
          ASSERT_EQ(status, BatchStatus::done);
          MechanismMotion<3> motion(mechanism);
          for (std::size_t row = 0; row < rows; ++row) {
            motion.move_to(drives[row]);
            const auto values = expected(motion, point, last - 1, 1);
            for (std::size_t i = 0; i < values.size(); ++i) {
              EXPECT_NEAR(results.values[i][row], values[i], 1e-10 * (10 + std::abs(values[i])))
                  << name(set) << " column " << i << " drive " << drive << " types " << types;
            }
          }
        }
      }
    }
  }
}

TEST(ChainBatch, PiecesForThreadsJoin) {
  const auto mechanism = as_mechanism({{0, 0}, {4, 0}, 1, 3, 3.5, Assembly::open, {}});
  std::vector<double> drives(3 * 4096 + 77);
  for (std::size_t i = 0; i < drives.size(); ++i) drives[i] = 1e-3 * static_cast<double>(i);
  const DriveTable table(mechanism, drives);
  std::vector<double> x(drives.size()), y(drives.size()), x_alone(x), y_alone(y);
  ChainColumns columns;
  columns.points.push_back({{2, {1, 0.5}}, {x}, {y}});
  ASSERT_EQ(evaluate_batch(mechanism, sides(mechanism), table, columns,
                           {.threads = 3, .instruction_set = {}}),
            BatchStatus::done);
  columns.points[0].x[0] = x_alone;
  columns.points[0].y[0] = y_alone;
  ASSERT_EQ(evaluate_batch(mechanism, sides(mechanism), table, columns), BatchStatus::done);
  EXPECT_EQ(x, x_alone);
  EXPECT_EQ(y, y_alone);
  MechanismMotion<0> motion(mechanism);
  ASSERT_TRUE(motion.move_to(drives.back()));
  EXPECT_NEAR(x.back(), motion.point({2, {1, 0.5}})[0].x, 1e-14);
}

TEST(ChainBatch, WhatHangsOnAnOpenDyadIsNoNumber) {
  const auto mechanism = as_mechanism({{0, 0}, {4.5, 0}, 2, 2.5, 3, Assembly::open, {}});
  const std::vector<double> drives{0.1, 3.1, 0.2, 3.2, 0.3};
  for (const InstructionSet set : instruction_sets()) {
    Results results(drives.size());
    ASSERT_EQ(
        evaluate_batch(mechanism, sides(mechanism), DriveTable(mechanism, drives),
                       results.columns({2, {1, 1}}, 3, 0), {.threads = 1, .instruction_set = set}),
        BatchStatus::done);
    for (std::size_t column = 0; column < 15; ++column) {
      for (std::size_t row = 0; row < drives.size(); ++row) {
        EXPECT_EQ(std::isnan(results.values[column][row]), row % 2 == 1) << name(set);
      }
    }
  }
}

TEST(ChainBatch, RefusesColumnsThatDoNotFit) {
  const auto mechanism = as_mechanism({{0, 0}, {4, 0}, 1, 3, 3.5, Assembly::open, {}});
  const std::vector<double> drives{0.1, 0.2};
  const DriveTable table(mechanism, drives);
  const auto signs = sides(mechanism);
  std::vector<double> two(2), also(2), three(3);
  const auto status = [&](const ChainColumns& columns) {
    return evaluate_batch(mechanism, signs, table, columns);
  };
  EXPECT_EQ(status({}), BatchStatus::nothing_wanted);
  EXPECT_EQ(status({{{{2, {}}, {two}, {also}}}, {}, {}}), BatchStatus::done);
  EXPECT_EQ(status({{{{2, {}}, {two}, {}}}, {}, {}}), BatchStatus::sizes_differ);
  EXPECT_EQ(status({{{{2, {}}, {three}, {three}}}, {}, {}}), BatchStatus::sizes_differ);
  EXPECT_EQ(status({{{{4, {}}, {two}, {also}}}, {}, {}}), BatchStatus::sizes_differ);
  EXPECT_EQ(status({{}, {}, {{1, two, also}}}), BatchStatus::sizes_differ);
}

}  // namespace
}  // namespace cognate
