#include "tests/browser/sample_analyses.hpp"

#include <cmath>
#include <utility>

#include "analysis/linkage/double_slider.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/guide_bar.hpp"
#include "analysis/linkage/slider_crank.hpp"
#include "analysis/numbers/constants.hpp"

namespace {

using namespace cognate;
using namespace cognate::problems;

Vec2d polar(double length, double angle) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

AnalysisProblem over_a_turn(std::string title, NamedMechanism mechanism) {
  AnalysisProblem problem;
  problem.title = std::move(title);
  problem.inertias.resize(static_cast<std::size_t>(body_count(mechanism.mechanism)));
  problem.mechanism = std::move(mechanism);
  problem.drive = {.start = 0, .end = kTurn, .steps = 360, .rate = {.speed = 10}};
  return problem;
}

AnalysisProblem four_bar(double crank) {
  FourBar linkage{.pivot_d = {4, 0.5}, .crank = crank, .coupler = 3.4, .rocker = 2.6};
  linkage.coupler_point = Vec2d{1.6, 1.3};
  NamedMechanism named{.mechanism = as_mechanism(linkage),
                       .bodies = {"frame", "crank", "coupler", "rocker"},
                       .points = {{"A", {0, {0, 0}}},
                                  {"B", {1, {crank, 0}}},
                                  {"C", {3, {2.6, 0}}},
                                  {"D", {0, {4, 0.5}}},
                                  {"P", {2, {1.6, 1.3}}}},
                       .output = 3,
                       .description = linkage};
  return over_a_turn("Four-bar with a coupler point", named);
}

AnalysisProblem slider_crank() {
  const SliderCrank mechanism{.pivot = {}, .crank = 0.1, .coupler = 0.33, .offset = 0.03};
  return over_a_turn("Slider-crank with an offset",
                     {.mechanism = as_mechanism(mechanism),
                      .bodies = {"frame", "crank", "coupler", "slider"},
                      .points = {{"A", {0, {}}}, {"B", {1, {0.1, 0}}}, {"C", {3, {}}}},
                      .output = 3,
                      .description = mechanism});
}

AnalysisProblem guide_bar(double offset) {
  const GuideBar mechanism{.pivot_a = {0, 0.4}, .pivot_c = {}, .crank = 0.2, .offset = offset};
  return over_a_turn("Oscillating guide-bar",
                     {.mechanism = as_mechanism(mechanism),
                      .bodies = {"frame", "crank", "block", "bar"},
                      .points = {{"A", {0, {0, 0.4}}}, {"B", {1, {0.2, 0}}}, {"C", {0, {}}}},
                      .output = 3,
                      .description = mechanism});
}

AnalysisProblem oscillating_block() {
  const OscillatingBlock mechanism{.pivot_a = {}, .pivot_c = {0.5, 0}, .crank = 0.2};
  return over_a_turn("Oscillating block",
                     {.mechanism = as_mechanism(mechanism),
                      .bodies = {"frame", "crank", "block", "rod"},
                      .points = {{"A", {0, {}}}, {"B", {1, {0.2, 0}}}, {"C", {0, {0.5, 0}}}},
                      .output = 2,
                      .description = mechanism});
}

AnalysisProblem scotch_yoke() {
  const ScotchYoke mechanism{.pivot = {}, .crank = 0.1};
  return over_a_turn("Scotch yoke", {.mechanism = as_mechanism(mechanism),
                                     .bodies = {"frame", "crank", "block", "yoke"},
                                     .points = {{"A", {0, {}}}, {"B", {1, {0.1, 0}}}},
                                     .output = 3,
                                     .description = mechanism});
}

AnalysisProblem trammel() {
  const EllipticTrammel mechanism{.centre = {}, .length = 0.3};
  return over_a_turn("Elliptic trammel", {.mechanism = as_mechanism(mechanism),
                                          .bodies = {"frame", "link", "block 1", "block 2"},
                                          .points = {{"A", {1, {}}},
                                                     {"B", {1, {0.3, 0}}},
                                                     {"P", {1, {0.5, 0}}},
                                                     {"M", {1, {0.15, 0}}}},
                                          .output = 1,
                                          .description = mechanism});
}

AnalysisProblem tangent_generator() {
  const TangentGenerator mechanism{.pivot = {}, .offset = 0.4};
  auto problem = over_a_turn("Tangent generator", {.mechanism = as_mechanism(mechanism),
                                                   .bodies = {"frame", "lever", "block", "slider"},
                                                   .points = {{"A", {0, {}}}, {"B", {3, {}}}},
                                                   .output = 3,
                                                   .description = mechanism});
  problem.drive.start = 0.2 * kPi;
  problem.drive.end = 0.8 * kPi;
  return problem;
}

AnalysisProblem oldham() {
  const OldhamCoupling mechanism{.pivot_a = {}, .pivot_d = {0.08, 0.03}};
  return over_a_turn("Oldham coupling",
                     {.mechanism = as_mechanism(mechanism),
                      .bodies = {"frame", "driving shaft", "driven shaft", "disc"},
                      .points = {{"A", {0, {}}}, {"D", {0, {0.08, 0.03}}}, {"M", {3, {}}}},
                      .output = 2,
                      .description = mechanism});
}

/// The slider drives: a pump's piston, say, and the crank follows over half a turn.
AnalysisProblem driven_by_slider() {
  Mechanism<double> mechanism;
  mechanism.drive = DrivingSlider<double>{.guide = {.body = 0, .through = {0.2, 0}}};
  mechanism.dyads.push_back(Rrr<double>{.first = {1, {}},
                                        .second = {0, {}},
                                        .first_length = 0.33,
                                        .second_length = 0.1,
                                        .assembly = Assembly::crossed});
  auto problem = over_a_turn("Driven by its slider",
                             {.mechanism = mechanism,
                              .bodies = {"frame", "piston", "rod", "crank"},
                              .points = {{"A", {0, {}}}, {"B", {3, {0.1, 0}}}, {"C", {1, {}}}},
                              .output = 3});
  problem.drive.start = 0.03;
  problem.drive.end = 0.25;
  problem.drive.rate.speed = 0.1;
  return problem;
}

/// Li & Xu 2011, examples 1-4 and 2-4: the ram is driven by a guide-bar and cuts in one stroke.
AnalysisProblem shaper() {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0.275}, 0.125};
  mechanism.dyads.push_back(Rpr<double>{.block = {1, {0.125, 0}}, .pivot = {0, {}}});
  mechanism.dyads.push_back(Rrp<double>{.point = {3, {0.6, 0}},
                                        .length = 0.15,
                                        .guide = {.body = 0, .through = {0, 0.575}},
                                        .assembly = Assembly::crossed});
  auto problem = over_a_turn("Shaper, six-bar, with its cutting force",
                             {.mechanism = mechanism,
                              .bodies = {"frame", "crank", "block", "bar", "link", "ram"},
                              .points = {{"A", {0, {0, 0.275}}},
                                         {"B", {1, {0.125, 0}}},
                                         {"C", {0, {}}},
                                         {"D", {3, {0.6, 0}}},
                                         {"E", {5, {}}}},
                              .output = 5});
  problem.drive.rate.speed = 1;
  problem.inertias = {{},
                      {},
                      {},
                      {.mass = 20, .centre = {0.3, 0}, .moment = 0.12},
                      {.mass = 3, .centre = {0.075, 0}, .moment = 0.00025},
                      {.mass = 62, .centre = {0.15, 0}}};
  problem.loads = {{.at = {5, {}},
                    .force = {5880, 0},
                    .sense = LoadSense::retreat,
                    .between = std::nullopt,
                    .within_stroke = std::pair{0.05, 0.95}}};
  problem.gravity = {0, -9.8};
  problem.output.curvature = problem.output.reactions = problem.output.torque = true;
  return problem;
}

/// A crank that swings the rockers of a ring, each by the one before it.
AnalysisProblem hundred_links() {
  constexpr int kRockers = 50;
  constexpr double kStep = kTurn / kRockers, kRadius = 24, kRocker = 1.5;
  const auto pivot = [&](int i) { return polar(kRadius, i * kStep); };
  const auto name = [](const std::string& kind, int i) { return kind + " " + std::to_string(i); };
  NamedMechanism named{};
  named.mechanism.drive = Crank<double>{pivot(0), 1};
  named.bodies = {"frame", "crank"};
  Attached<double> before{1, {1, 0}};
  const double spacing = std::sqrt(squared_norm(pivot(1) - pivot(0)));
  for (int i = 1; i < kRockers; ++i) {
    named.mechanism.dyads.push_back(Rrr<double>{.first = before,
                                                .second = {0, pivot(i)},
                                                .first_length = spacing,
                                                .second_length = kRocker,
                                                .assembly = Assembly::crossed});
    const int rocker = 1 + 2 * i;
    named.bodies.insert(named.bodies.end(), {name("coupler", i), name("rocker", i)});
    named.points.push_back({name("C", i), {rocker, {kRocker, 0}}});
    before = {rocker, polar(kRocker, kStep)};
  }
  named.output = 1 + 2 * (kRockers - 1);
  auto problem = over_a_turn("A chain of a hundred links", named);
  problem.drive.steps = 10000;
  return problem;
}

}  // namespace

std::vector<SampleAnalysis> sample_analyses() {
  return {{"four-bar", four_bar(1)},
          {"four-bar-gaps", four_bar(2.4)},
          {"slider-crank", slider_crank()},
          {"guide-bar", guide_bar(0)},
          {"guide-bar-offset", guide_bar(0.06)},
          {"oscillating-block", oscillating_block()},
          {"scotch-yoke", scotch_yoke()},
          {"elliptic-trammel", trammel()},
          {"tangent-generator", tangent_generator()},
          {"oldham-coupling", oldham()},
          {"driven-by-slider", driven_by_slider()},
          {"shaper", shaper()},
          {"hundred-links", hundred_links()}};
}
