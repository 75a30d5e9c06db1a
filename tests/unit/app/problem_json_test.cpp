#include <fmt/core.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <variant>

#include "app/kinds/kinds.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::app::problem_json_test {
namespace {

using nlohmann::json;

std::string toml_value(const json& value);

/// A range without one of its sides, as a problem file writes it.
std::string toml_range(const json& sides) {
  return fmt::format("[{}, {}]", sides.contains("min") ? sides["min"].dump() : "-inf",
                     sides.contains("max") ? sides["max"].dump() : "inf");
}

/// `value` as TOML writes it within a line.
std::string toml_inline(const json& value) {
  std::string parts;
  if (value.is_array()) {
    for (const auto& entry : value) parts += toml_inline(entry) + ", ";
    return '[' + parts + ']';
  }
  if (!value.is_object()) return value.dump();
  for (const auto& [key, entry] : value.items()) {
    parts += fmt::format("{}{} = {}", parts.empty() ? "" : ", ", key, toml_inline(entry));
  }
  return '{' + parts + '}';
}

/// An object is a range, unless it has keys of its own; tables in an array are tables.
std::string toml_value(const json& value) {
  const bool is_range =
      value.is_object() && (value.empty() || value.contains("min") || value.contains("max"));
  return is_range ? toml_range(value) : toml_inline(value);
}

/// The problem file that says what `tables` say, explicitly.
std::string toml_of(const json& tables) {
  std::ostringstream file;
  for (const auto& [key, value] : tables.items()) {
    if (!value.is_object()) file << key << " = " << toml_value(value) << '\n';
  }
  for (const auto& [name, table] : tables.items()) {
    if (!table.is_object()) continue;
    file << '[' << name << "]\n";
    for (const auto& [key, value] : table.items())
      file << key << " = " << toml_value(value) << '\n';
  }
  return file.str();
}

std::string messages(const std::vector<problems::Fault>& faults) {
  std::string all;
  for (const auto& fault : faults) all += fmt::format("{}: {}\n", fault.line, fault.message);
  return all;
}

/// The analysis file that says what `tables` say.
std::string toml_of_analysis(const json& tables) {
  std::string file;
  for (const auto& [key, value] : tables.items()) {
    file += fmt::format("{} = {}\n", key, toml_inline(value));
  }
  return file;
}

/// What is written of a problem is itself a problem file, and reading it gives the same again:
/// nothing is lost, no default changes the meaning.
template <class Problem>
void expect_reads_back(const Problem& problem) {
  const json written = problem_json(problem);
  // Their mechanisms hold tables.
  const bool in_tables = std::is_same_v<Problem, problems::AnalysisProblem> ||
                         std::is_same_v<Problem, problems::MachineProblem> ||
                         std::is_same_v<Problem, problems::ChainPathProblem> ||
                         std::is_same_v<Problem, problems::ChainFunctionProblem> ||
                         std::is_same_v<Problem, problems::ChainMotionProblem> ||
                         std::is_same_v<Problem, problems::DwellProblem> ||
                         std::is_same_v<Problem, problems::LegProblem>;
  const auto file = in_tables ? toml_of_analysis(written) : toml_of(written);
  const auto again = problems::parse_task<Problem>(file);
  ASSERT_TRUE(again.has_value()) << messages(again.error()) << file;
  EXPECT_EQ(json(problem_json(*again)), written);
}

TEST(ProblemJson, EveryFileOfTheLibraryReadsBack) {
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kLibraryFolder)) {
    if (entry.path().extension() != ".toml") continue;
    if (entry.path().parent_path().filename() == "study") continue;  // has many problems
    SCOPED_TRACE(entry.path().string());
    const auto task = problems::read_task(entry.path());
    ASSERT_TRUE(task.has_value()) << messages(task.error());
    std::visit([](const auto& asked) { expect_reads_back(asked); }, *task);
    ++count;
  }
  EXPECT_GE(count, 30);
}

TEST(ProblemJson, FunctionsGivenByTablesReadBack) {
  const auto problem = problems::parse_task<problems::FunctionProblem>(
      "kind = 'function-generation'\n[target]\ntable = [[0, 0], [1, 0.5], [2, 2.1], [3, 4]]\n"
      "input_range_deg = 60\noutput_range_deg = 60\nobjective = 'least-squares'\n");
  ASSERT_TRUE(problem.has_value()) << messages(problem.error());
  EXPECT_EQ(problem_json(*problem)["target"]["domain"], json({0.0, 3.0}));
  expect_reads_back(*problem);
}

// One shift free, bounds open to a side, a given shift outside the bounds that are the default.
TEST(ProblemJson, GearPairsReadBack) {
  const std::string opening = "kind = \"gear-pair\"\n[mechanism]\nteeth = [11, 40]\nmodule = 2\n";
  for (const char* rest :
       {"profile_shift = [0.4, \"free\"]\ntip_reduction = [0.1, 0]\n[bounds]\ncentre_distance = "
        "[50, inf]",
        "profile_shift = [\"free\", -0.9]\nbacklash = 0.1\n[constraints]\nhunting = true\n"
        "sliding_max = 3\ntip_clearance_min = 0.1\nno_undercut = false",
        "profile_shift = [0.1, -0.9]\n[rack]\npressure_angle_deg = 25\nclearance = 0.2\ntip_radius "
        "= 0.3\n"
        "[target]\nratio = 3.6\nratio_tolerance = 0.1\nobjective = \"size\""}) {
    const auto problem = problems::parse_task<problems::GearPairProblem>(opening + rest);
    ASSERT_TRUE(problem.has_value()) << messages(problem.error());
    expect_reads_back(*problem);
  }
}

// Ranges, conditions, splines, closures and materials that no file of the library uses.
TEST(ProblemJson, ACamWithEverythingReadsBack) {
  for (const std::string text : {
           R"(
    kind = "cam"
    title = "all"
    [[motion]]
    law = "polynomial"
    over_deg = 51.42857142857143
    rise_deg = 7.3
    conditions = [
      {at_deg = 17.7, displacement_deg = 3.1}, {at_deg = 51.42857142857143, velocity = 0},
      {at_deg = 33.333333333333336, acceleration = 0.01}, {at_deg = 0, jerk = 1e-3}]
    [[motion]]
    law = "spline"
    over_deg = 70
    rise_deg = 1.7
    points = [[0.1, 0.01], [33.3, 1.1]]
    velocity = [0.1, 0]
    acceleration = [0, 0.2]
    [[motion]]
    law = "universal"
    over_deg = [77.7, 99.9]
    rise_deg = -9
    sine = [0.1, 0.2]
    constant = 0.33
    cosine = [0.3, 0.7]
    [[motion]]
    law = "dwell"
    over_deg = [100, 200]
    [follower]
    type = "oscillating-roller"
    side = "leading"
    closure = "conjugate"
    arms_deg = 77
    inertia = 0.1
    spring_rate = 3
    load = -2
    [mechanism]
    rotation = "cw"
    arm = 33.3
    [bounds]
    base_radius = [10, 30]
    centre_distance = [20, inf]
    [drive]
    speed = 31.4
    [contact]
    width = 0.01
    elasticity = [2.1e11, 7e10]
    poisson = [0.3, 0.33]
    [target]
    objective = "torque"
    [constraints]
    pressure_angle_deg_max = 33
    no_undercut = false
    concave_radius_min = 3
    profile_radius_max = 90
    torque_max = 9
    contact_stress_max = 1e9
    [solve]
    solver = "slsqp"
    starts = 7
    designs = 3
    tolerance = 1e-9)",
           R"(
    kind = "cam"
    [[motion]]
    law = "spline"
    over_deg = 360
    points = [[100, 3], [200, 5]]
    degree = 3
    periodic = true
    [follower]
    type = "translating-flat"
    closure = "constant-breadth"
    breadth = 90
    preload = 3
    [constraints]
    face_width_max = 80
    curvature_radius_min = 2
    contact_force_max = 20)",
           R"(
    kind = "cam"
    motion = [{law = "harmonic", over_deg = 100, rise_deg = 3},
              {law = "3-4-5", over_deg = 260, rise_deg = -3}]
    [follower]
    type = "oscillating-flat"
    preload = 2
    [mechanism]
    base_radius = 20
    [bounds]
    centre_distance = [40, 100]
    face_offset = [-inf, inf]
    [constraints]
    no_separation = false)",
           R"(
    kind = "cam"
    motion = [{law = "harmonic", over_deg = 100, rise = 3},
              {law = "3-4-5", over_deg = 260, rise = -3}]
    follower.type = "translating-knife"
    bounds.offset = [0, inf]
    constraints.pressure_angle_deg_max = 20)"}) {
    const auto problem = problems::parse_task<problems::CamProblem>(text);
    ASSERT_TRUE(problem.has_value()) << messages(problem.error());
    expect_reads_back(*problem);
    const auto again = problems::parse_task<problems::CamProblem>(toml_of(problem_json(*problem)));
    ASSERT_TRUE(again.has_value());
    for (std::size_t i = 0; i < std::size(problem->lengths); ++i) {
      EXPECT_EQ(problem->lengths[i].given, again->lengths[i].given);
      EXPECT_EQ(problem->lengths[i].bounds.min, again->lengths[i].bounds.min);
      EXPECT_EQ(problem->lengths[i].bounds.max, again->lengths[i].bounds.max);
    }
    EXPECT_EQ(problem->clockwise, again->clockwise);
    ASSERT_EQ(problem->motion.size(), again->motion.size());
    for (std::size_t i = 0; i < problem->motion.size(); ++i) {
      const auto &one = problem->motion[i], &other = again->motion[i];
      EXPECT_EQ(one.over, other.over);
      EXPECT_EQ(one.rise, other.rise);
      for (std::size_t k = 0; k < one.conditions.size(); ++k) {
        EXPECT_EQ(one.conditions[k].at, other.conditions[k].at);
        EXPECT_EQ(one.conditions[k].value, other.conditions[k].value);
      }
      for (std::size_t k = 0; k < one.points.size(); ++k) {
        EXPECT_EQ(one.points[k].at, other.points[k].at);
        EXPECT_EQ(one.points[k].displacement, other.points[k].displacement);
      }
    }
    EXPECT_EQ(problem->operation.modulus_sum, again->operation.modulus_sum);
  }
}

// Axes, points and names that no file of the library uses.
TEST(ProblemJson, AnAnalysisWithEveryKindOfDyadReadsBack) {
  const auto problem = problems::parse_task<problems::AnalysisProblem>(R"(
    kind = "analysis"
    pivot = [{name = "D", at = [6, 1]}, {name = "G", at = [0.1, -4]}]
    gravity = [0.1, -9.81]
    mechanism.type = "chain"
    slider = {slide = {through = [0, 0.3], direction_deg = 33.3, offset = -0.1}, pin = "B", name = "x"}
    point = [{name = "P", on = ["C", "B"], at = [0.7, 0.1]}, {name = "Q", on = "x", at = [1, 1]}]
    [[dyad]]
    type = "RRR"
    joins = ["B", "D"]
    lengths = [5, 4]
    new = "C"
    assembly = "crossed"
    [[dyad]]
    type = "RPR"
    joins = ["P", "G"]
    offset = 0.25
    assembly = "crossed"
    [[dyad]]
    type = "RPP"
    joins = "C"
    slide = {through = "Q", on = "x", direction_deg = 12}
    slot_deg = 77.7
    new = "E"
    names = ["b1", "E"]
    [[dyad]]
    type = "PRP"
    slides = [{through = "E", on = "E"}, {through = "G", direction_deg = 100}]
    new = "F"
    [[link]]
    between = ["P", "C"]
    mass = 2
    centre = [0.3, 0.4]
    [[load]]
    on = ["C", "D"]
    at = [0.5, 0.2]
    force = [1, 2]
    when = [0.25, 0.75]
    [[load]]
    on = "b1"
    torque = 3
    when = "return"
    stroke = [0.1, 0.9]
    [drive]
    end = 2
    speed = -0.5
    [output]
    want = ["position", "torque", "P"]
    instant_geometry = ["b1", "E"]
  )");
  ASSERT_TRUE(problem.has_value()) << messages(problem.error());
  expect_reads_back(*problem);
}

TEST(ProblemJson, HoldsEveryKeyOfAPathProblem) {
  const auto problem = problems::parse_task<problems::PathProblem>(R"(
    kind = "path-generation"
    title = "All keys"
    [target]
    points = [[0, 0], [1, 0.5], [2, 0]]
    timing = "prescribed"
    crank_deg = [10, 50.5, 123.4]
    crank_reference = "frame"
    crank_sense = "ccw"
    weights = [1, 2, 3]
    [mechanism]
    crank = 1
    assembly = "crossed"
    [bounds]
    length = [0.5, 9]
    rocker = [2, inf]
    frame_angle_deg = [-30, 30]
    pivot_a = [[-5, -5], [5, 5]]
    coupler_point = [[-5, -5], [5, 5]]
    [constraints]
    class = "crank-rocker"
    transmission_angle_deg = [40, 140]
    link_ratio_max = 6
    pivot_region = [[-9, -9], [9, 9]]
    no_order_defect = false
    [solve]
    solver = "slsqp"
    starts = 5
    designs = 2
    tolerance = 1e-10
  )");
  ASSERT_TRUE(problem.has_value()) << messages(problem.error());
  const json written = problem_json(*problem);
  const json target = {{"points", {{0.0, 0.0}, {1.0, 0.5}, {2.0, 0.0}}},
                       {"timing", "prescribed"},
                       {"crank_deg", {10.0, 50.5, 123.4}},
                       {"crank_reference", "frame"},
                       {"crank_sense", "ccw"},
                       {"weights", {1.0, 2.0, 3.0}}};
  EXPECT_EQ(written["target"], target);
  EXPECT_EQ(written["mechanism"],
            json({{"type", "four-bar"}, {"crank", 1.0}, {"assembly", "crossed"}}));
  EXPECT_EQ(written["bounds"]["rocker"], json({2.0, 9.0}));
  EXPECT_EQ(written["bounds"]["frame_angle_deg"], json({-30.0, 30.0}));
  const json constraints = {
      {"class", "crank-rocker"},  {"transmission_angle_deg", {40.0, 140.0}},
      {"link_ratio_max", 6.0},    {"pivot_region", {{-9.0, -9.0}, {9.0, 9.0}}},
      {"no_branch_defect", true}, {"no_order_defect", false},
      {"no_circuit_defect", true}};
  EXPECT_EQ(written["constraints"], constraints);
  const json solve = {{"solver", "slsqp"}, {"starts", 5}, {"designs", 2}, {"tolerance", 1e-10}};
  EXPECT_EQ(written["solve"], solve);
  expect_reads_back(*problem);
}

// Limits, speeds, turns and tables that no file of the library has.
TEST(ProblemJson, AMachineWithEverythingReadsBack) {
  const auto problem = problems::parse_task<problems::MachineProblem>(R"(
    kind = "machine"
    title = "all"
    gravity = [0.1, -9.8]
    [mechanism]
    type = "scotch-yoke"
    pivot = [0, 0.3]
    crank = 0.7
    [[point]]
    name = "Q"
    on = "yoke"
    at = [0.1, 0.2]
    [[link]]
    name = "yoke"
    mass = 3
    [[load]]
    on = "Q"
    force = [1, 2]
    when = [10, 20]
    value = [[5, 0.1], [77, -3], [90.5, 0.3]]
    interpolation = "smooth"
    [equivalent]
    inertia = [[33.3, 1.1], [70.1, 2.3], [393.3, 1.1]]
    torque = [[1, 2], [3, 4]]
    interpolation = "smooth"
    [motor]
    table = [[0.1, 3], [7, -0.3]]
    interpolation = "smooth"
    ratio = 3.3
    efficiency = 0.7
    inertia = 0.01
    [flywheel]
    inertia = 3.3
    [brake]
    torque = 0.7
    [run]
    tasks = ["start", "stop"]
    start_deg = 33.3
    start_speed = 0.1
    time_max = 7.7
    turns_max = 8.8
    speed_end = 9.9
    steps = 77
    tolerance = 1e-7
)");
  ASSERT_TRUE(problem.has_value()) << messages(problem.error());
  const json written = problem_json(*problem);
  EXPECT_EQ(written["flywheel"]["inertia"], 3.3);
  EXPECT_EQ(written["equivalent"]["inertia"][2][0], 393.3);
  EXPECT_EQ(written["load"][0]["interpolation"], "smooth");
  EXPECT_EQ(written["run"]["turns_max"], 8.8);
  expect_reads_back(*problem);
}

}  // namespace
}  // namespace cognate::app::problem_json_test
