/// The examples of Li & Xu 2011 as files of the library, read and analysed as a user would: every
/// row of the table against the mechanisms of li_xu.toml.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "analysis/mechanism/joints.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/read.hpp"
#include "tests/oracle/li_xu.hpp"
#include "tests/support/folders.hpp"

namespace cognate::li_xu_files_test {
namespace {

struct File {
  std::string name, number, title;  ///< the latter two in li_xu.toml
};

const std::vector<File> files = {
    {"four-bar-forces.toml", "2-1", "Four-bar, with gravity"},
    {"slider-crank-forces.toml", "2-2", "Slider-crank, with gravity"},
    {"guide-bar-forces.toml", "2-3", "Guide bar, load in the working stroke"},
    {"shaper.toml", "2-4", "Shaper"},
};

Example find_example(const File& file) {
  for (Example& example : read_examples()) {
    if (example.number == file.number && example.title == file.title) return example;
  }
  ADD_FAILURE() << "no example " << file.number << ", " << file.title;
  return {};
}

problems::AnalysisProblem read_file(const std::string& name) {
  auto problem = problems::read_task<problems::AnalysisProblem>(
      std::filesystem::path(kLibraryFolder) / "analysis" / name);
  EXPECT_TRUE(problem.has_value()) << name;
  problem->output.torque = problem->output.reactions = true;
  return *problem;
}

/// The columns of torque and reactions, in the order of the joints.
std::vector<problems::Column> force_columns(const problems::AnalysisResult& result) {
  std::vector<problems::Column> columns;
  for (const auto& column : result.columns) {
    if (column.quantity == "torque" || column.quantity == "reactions") columns.push_back(column);
  }
  return columns;
}

/// What a row should hold: torque; of turning joints the force, of sliding ones its magnitude (the
/// file may point the guide the other way) and the moment; the shaking force and moment.
std::vector<double> expected_row(const Model& model, const Instant& now) {
  std::vector<double> row{now.forces.drive};
  const JointList list = joints(model.mechanism);
  for (std::size_t i = 0; i < list.joints.size(); ++i) {
    const Reaction& reaction = now.forces.reactions[i];
    const bool slides = list.joints[i].type == JointType::prismatic;
    row.push_back(slides ? std::hypot(reaction.force.x, reaction.force.y) : reaction.force.x);
    row.push_back(slides ? reaction.moment : reaction.force.y);
  }
  row.insert(row.end(),
             {now.forces.shaking_force.x, now.forces.shaking_force.y, now.forces.shaking_moment});
  return row;
}

bool is_normal_force(const problems::Column& column) {
  return column.unit == "N" && column.name.find("_F") == std::string::npos;
}

TEST(LiXuFiles, EveryRowOfForces) {
  for (const File& file : files) {
    const Model model = model_of(find_example(file));
    const problems::AnalysisProblem problem = read_file(file.name);
    const problems::AnalysisResult result = problems::analyse(problem, {});
    const auto columns = force_columns(result);
    const std::vector<double>& drive = result.columns[0].values;
    ASSERT_EQ(result.columns[0].unit, "deg");
    ASSERT_EQ(drive.size(), 361U) << file.name;
    for (std::size_t i = 0; i < drive.size(); ++i) {
      const Instant now = instant(model, drive[i] * kPi / 180);
      const std::vector<double> expected = expected_row(model, now);
      ASSERT_EQ(columns.size(), expected.size()) << file.name;
      double size = 0;
      for (const double value : expected) size = std::max(size, std::abs(value));
      for (std::size_t k = 0; k < columns.size(); ++k) {
        const double value = columns[k].values[i];
        EXPECT_NEAR(is_normal_force(columns[k]) ? std::abs(value) : value, expected[k],
                    1e-12 * size)
            << file.name << ": " << columns[k].name << " at " << drive[i] << " deg";
      }
    }
  }
}

}  // namespace
}  // namespace cognate::li_xu_files_test
