/// Constraints that fight are named with the least change that helps, as a rule known beforehand
/// finds, and as solving again with the changed limits confirms.
#include "problems/search/infeasibility.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "analysis/numbers/constants.hpp"
#include "problems/read.hpp"

namespace cognate::problems::infeasibility_test {
namespace {

std::string explained(const Constraints& constraints, const Bounds& bounds,
                      const Feasibility& feasible, bool is_over = false) {
  const auto sentences =
      explain_infeasibility(constraints, bounds, feasible, [&] { return is_over; });
  return sentences.empty() ? "" : sentences.front();
}

Constraints loose() {
  Constraints constraints;
  constraints.no_branch_defect = constraints.no_circuit_defect = constraints.no_order_defect =
      false;
  return constraints;
}

TEST(Infeasibility, NamesEachConstraintThatAloneStandsInTheWay) {
  Constraints constraints = loose();
  constraints.transmission_angle = Range{60 * kDegree, 120 * kDegree};
  constraints.link_ratio_max = 3;
  Bounds bounds;
  bounds.crank = Range{1, 2};
  // Either the transmission angle gives way to 45 degrees or the ratio to 6; the crank is no help.
  const std::string text = explained(constraints, bounds, [](const Constraints& c, const Bounds&) {
    return c.transmission_angle->min <= 45 * kDegree || !c.link_ratio_max || *c.link_ratio_max >= 6;
  });
  EXPECT_NE(text.find("Any one of these"), text.npos) << text;
  EXPECT_EQ(text.find("crank"), text.npos) << text;
  double low = 0, high = 0, ratio = 0;
  ASSERT_EQ(
      std::sscanf(text.c_str() + text.find("transmission_angle_deg"),
                  "transmission_angle_deg = [%lf, %lf]; link_ratio_max = %lf", &low, &high, &ratio),
      3)
      << text;
  EXPECT_LE(low, 45);
  EXPECT_GT(low, 44.4);  // a hundredth of the way to 0
  EXPECT_NEAR(low + high, 180, 0.2);
  EXPECT_GE(ratio, 6);
  EXPECT_LT(ratio, 6.2);
}

TEST(Infeasibility, NamesLimitsOverTheTurn) {
  Constraints constraints = loose();
  constraints.required_class = RequiredClass::crank_rocker;
  constraints.cycle_max[CycleQuantity::peak_acceleration] = 10;
  constraints.cycle_max[CycleQuantity::torque_ripple] = 4;
  constraints.clearances = {{MovingPoint::b, true, {{0, 0}, {2, 1}}},
                            {MovingPoint::c, false, {{0, 0}, {4, 4}}}};
  // Either the acceleration may be 30, or the box of B 3 wide, or that of C have a corner at 1; the
  // torque is no help, and the class never gives way, for it is what a full turn is about.
  const std::string text = explained(constraints, {}, [](const Constraints& c, const Bounds&) {
    EXPECT_EQ(c.required_class, RequiredClass::crank_rocker);
    const Box& wide = c.clearances[0].box;
    const Clearance& obstacle = c.clearances[1];
    return !c.cycle_max[CycleQuantity::peak_acceleration] ||
           *c.cycle_max[CycleQuantity::peak_acceleration] >= 30 || wide.max.x - wide.min.x >= 3 ||
           obstacle.inside || obstacle.box.min.x >= 1;
  });
  EXPECT_NE(text.find("Any one of these"), text.npos) << text;
  EXPECT_EQ(text.find("torque"), text.npos) << text;
  double most = 0, left = 0, right = 0, corner = 0;
  ASSERT_EQ(std::sscanf(text.c_str() + text.find("clearance[1]"),
                        "clearance[1] = inside [[%lf, %*f], [%lf, %*f]]; clearance[2] = outside "
                        "[[%lf, %*f], [%*f, %*f]]; peak_acceleration_max = %lf",
                        &left, &right, &corner, &most),
            4)
      << text;
  EXPECT_NEAR(right - left, 3, 0.1);
  EXPECT_GE(corner, 1);
  EXPECT_LT(corner, 1.05);
  EXPECT_GE(most, 30);
  EXPECT_LT(most, 31);
}

TEST(Infeasibility, NamesLimitsOfTheRunningMachine) {
  Constraints constraints = loose();
  constraints.required_class = RequiredClass::crank_rocker;
  constraints.cycle_max[CycleQuantity::speed_fluctuation] = 0.1;
  constraints.cycle_max[CycleQuantity::flywheel_inertia] = 5;
  constraints.cycle_max[CycleQuantity::motor_power] = 40;
  const std::string text = explained(constraints, {}, [](const Constraints& c, const Bounds&) {
    EXPECT_EQ(c.required_class, RequiredClass::crank_rocker);
    return !c.cycle_max[CycleQuantity::speed_fluctuation] ||
           *c.cycle_max[CycleQuantity::speed_fluctuation] >= 0.2 ||
           !c.cycle_max[CycleQuantity::flywheel_inertia] ||
           *c.cycle_max[CycleQuantity::flywheel_inertia] >= 8;
  });
  EXPECT_EQ(text.find("motor_power"), text.npos) << text;
  double fluctuation = 0, flywheel = 0;
  ASSERT_EQ(std::sscanf(text.c_str() + text.find("speed_fluctuation_max"),
                        "speed_fluctuation_max = %lf; flywheel_inertia_max = %lf", &fluctuation,
                        &flywheel),
            2)
      << text;
  EXPECT_GE(fluctuation, 0.2);
  EXPECT_LT(fluctuation, 0.21);
  EXPECT_GE(flywheel, 8);
  EXPECT_LT(flywheel, 8.3);
}

TEST(Infeasibility, NamesTheFewestThatMustGiveWayTogether) {
  Constraints constraints = loose();
  constraints.required_class = RequiredClass::crank_rocker;
  constraints.no_order_defect = true;
  constraints.link_ratio_max = 3;
  const std::string text = explained(constraints, {}, [](const Constraints& c, const Bounds&) {
    return !c.required_class && !c.no_order_defect;
  });
  EXPECT_NE(text.find("together"), text.npos) << text;
  EXPECT_NE(text.find("class given up and no_order_defect given up"), text.npos) << text;
  EXPECT_EQ(text.find("link_ratio"), text.npos) << text;
}

TEST(Infeasibility, SaysNothingWhereNothingHelpsOrTimeIsUp) {
  Constraints constraints = loose();
  constraints.link_ratio_max = 3;
  EXPECT_EQ(explained(constraints, {}, [](const auto&, const auto&) { return false; }), "");
  EXPECT_EQ(explained(loose(), {}, [](const auto&, const auto&) { return true; }), "");
  EXPECT_NE(explained(constraints, {}, [](const auto&, const auto&) { return true; })
                .find("more of solve.starts"),
            std::string::npos);
  EXPECT_EQ(explained(
                constraints, {}, [](const auto&, const auto&) { return true; }, true),
            "");
}

/// A function generator whose lengths cannot close; what the note proposes is tried out.
TEST(Infeasibility, ProposesLimitsWithWhichADesignIsFound) {
  const auto problem_with = [](const std::string& crank) {
    return std::get<FunctionProblem>(*parse_task(
        "kind = \"function-generation\"\n[target]\nfunction = \"log10(x)\"\ndomain = [1, 2]\n"
        "input_range_deg = 60\noutput_range_deg = 90\nsamples = 11\n[mechanism]\nframe = 1\n"
        "[bounds]\ncrank = " +
        crank + "\ncoupler = [0.5, 1]\nrocker = [0.5, 1]\n"));
  };
  const Result result = solve(problem_with("[3, 4]"), {});
  EXPECT_EQ(result.status, Status::no_solution);
  ASSERT_EQ(result.notes.size(), 2u);
  const std::string& note = result.notes[1];
  const auto at = note.find("bounds.crank = ");
  ASSERT_NE(at, note.npos) << note;
  const std::string proposed = note.substr(at + 15, note.find(']', at) - at - 14);
  EXPECT_EQ(solve(problem_with(proposed), {}).status, Status::solved) << proposed;
  double low = 0, high = 0;
  ASSERT_EQ(std::sscanf(proposed.c_str(), "[%lf, %lf]", &low, &high), 2);
  const std::string less = "[" + std::to_string(low + 0.5 * (3 - low)) + ", 4]";
  EXPECT_NE(solve(problem_with(less), {}).status, Status::solved) << less;
}

}  // namespace
}  // namespace cognate::problems::infeasibility_test
