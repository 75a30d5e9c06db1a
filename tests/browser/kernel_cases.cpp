/// @file Four-bars of all classes with what the program says of them, as JSON: what the kernel in
/// the report pages, which another compiler made for another machine, is held against.
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>

#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/drawing/design_motion.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/verify.hpp"

namespace {

using namespace cognate;
using nlohmann::ordered_json;

constexpr int kCases = 2000, kPositions = 12, kSamples = 31;

ordered_json pair(const Vec2d& v) {
  return ordered_json::array({v.x, v.y});
}

FourBar random_linkage(std::mt19937_64& random) {
  std::uniform_real_distribution<double> length(0.2, 4), place(-3, 3), coin(0, 1);
  FourBar linkage;
  do {
    linkage = {.pivot_a = {place(random), place(random)},
               .pivot_d = {place(random), place(random)},
               .crank = length(random),
               .coupler = length(random),
               .rocker = length(random),
               .assembly = coin(random) < 0.5 ? Assembly::open : Assembly::crossed,
               .coupler_point = Vec2d{place(random), place(random)}};
  } while (!can_assemble(lengths(linkage)));
  return linkage;
}

ordered_json poses_of(const FourBar& linkage, const std::vector<double>& cranks) {
  const Motion motion(linkage);
  ordered_json poses = ordered_json::array();
  for (const double crank : cranks) {
    const auto pose = motion.at(crank);
    poses.push_back(nullptr);
    if (!pose) continue;
    poses.back() = {{"b", pair(pose->b)},
                    {"c", pair(pose->c)},
                    {"p", pair(*pose->coupler_point)},
                    {"rocker", pose->rocker_angle},
                    {"transmission", pose->transmission_angle}};
  }
  return poses;
}

ordered_json case_of(const FourBar& linkage, const std::vector<double>& cranks,
                     problems::MotionKind kind) {
  const auto metrics = problems::design_metrics(linkage, cranks, kind);
  const auto motion = app::sample_motion(linkage, cranks, kSamples);
  ordered_json defects = ordered_json::array();
  for (const auto defect : metrics.defects) defects.push_back(problems::to_string(defect));
  return {{"mechanism",
           {{"fixed_pivots", {pair(linkage.pivot_a), pair(linkage.pivot_d)}},
            {"crank", linkage.crank},
            {"coupler", linkage.coupler},
            {"rocker", linkage.rocker},
            {"assembly", problems::to_string(linkage.assembly)},
            {"coupler_point", pair(*linkage.coupler_point)}}},
          {"sequence", kind.timed                                ? "timed"
                       : kind.order == problems::PointOrder::any ? "any"
                                                                 : "one_sense"},
          {"cranks", cranks},
          {"class", problems::to_string(*metrics.mobility)},
          {"rotates", crank_rotates(lengths(linkage))},
          {"least", metrics.transmission_min},
          {"greatest", metrics.transmission_max},
          {"acute", metrics.transmission_acute_min},
          {"time_ratio", metrics.time_ratio ? ordered_json(*metrics.time_ratio) : nullptr},
          {"defects", defects},
          {"poses", poses_of(linkage, cranks)},
          {"motion", {{"crank", motion.crank}, {"rocker", motion.rocker}}}};
}

}  // namespace

int main() {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  ordered_json cases = ordered_json::array();
  for (int i = 0; i < kCases; ++i) {
    const FourBar linkage = random_linkage(random);
    std::vector<double> cranks(1 + static_cast<std::size_t>(i % kPositions));
    for (double& crank : cranks) crank = angle(random);
    if (i % 3 > 0) std::ranges::sort(cranks);
    const auto order = i % 2 == 0 ? problems::PointOrder::any : problems::PointOrder::cyclic;
    cases.push_back(case_of(linkage, cranks, {.order = order, .timed = i % 5 == 0}));
  }
  std::cout << cases << '\n';
}
