// Writes the reports that the browser tests open: sample_reports DIRECTORY.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/kinds/kinds.hpp"
#include "app/report/study_report.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"
#include "tests/browser/sample_analyses.hpp"
#include "tests/browser/sample_cams.hpp"
#include "tests/browser/sample_designs.hpp"
#include "tests/browser/sample_gears.hpp"
#include "tests/browser/sample_studies.hpp"
#include "tests/support/folders.hpp"

namespace {

using namespace cognate;
using namespace cognate::problems;

struct Sample {
  Task problem;
  Result result;
};

/// The crank angle that brings the coupler point nearest to `target`, to about 1e-9.
double nearest_crank(const Motion& motion, const Vec2d& target) {
  const auto distance = [&](double angle) {
    const auto pose = motion.at(angle);
    return pose ? squared_norm(*pose->coupler_point - target) : 1e300;
  };
  double best = 0, step = kTurn / 720;
  for (int i = 0; i < 720; ++i) {
    if (distance(i * step) < distance(best)) best = i * step;
  }
  for (; step > 1e-10; step /= 2) {
    for (const double at : {best - step, best + step}) {
      if (distance(at) < distance(best)) best = at;
    }
  }
  return best < 0 ? best + kTurn : best;
}

Design design_of(const PathProblem& problem, const FourBar& linkage) {
  Design design{.mechanism = named(linkage), .origin = "search + gauss-newton"};
  const Motion motion(linkage);
  for (const Vec2d& point : problem.points) {
    design.crank_angles.push_back(nearest_crank(motion, point));
  }
  design.error = path_error(linkage, problem.points, design.crank_angles);
  design.metrics = design_metrics(linkage, design.crank_angles, {.order = problem.order});
  design.constraints = check_constraints(problem.constraints, problem.bounds, problem.given,
                                         linkage, design.metrics);
  return design;
}

/// Ten points of an ellipse and the crank-rocker that passes nearest to them with lengths of 5 to
/// 80, beside a worse one.
Sample ellipse() {
  PathProblem problem;
  problem.title = "Ten points of an ellipse";
  problem.points = {{20, 10},          {17.66, 15.142},   {11.736, 17.878}, {5, 16.928},
                    {0.60307, 12.736}, {0.60307, 7.2638}, {5, 3.0718},      {11.736, 2.1215},
                    {17.66, 4.8577},   {20, 10}};
  problem.bounds.crank = problem.bounds.coupler = problem.bounds.rocker = problem.bounds.frame =
      Range{5, 80};
  problem.constraints.required_class = RequiredClass::crank_rocker;
  problem.constraints.transmission_angle = Range{kPi / 4, 3 * kPi / 4};
  constexpr double kFrameAngle = -2.3939261789984054;
  FourBar linkage{.pivot_a = {8.494440946481369, -0.757957675426053},
                  .crank = 8.045683264447003,
                  .coupler = 50.81910993108052,
                  .rocker = 42.2080499037866,
                  .coupler_point = Vec2d{-10.637216358604173, -2.2901790623502585}};
  linkage.pivot_d = linkage.pivot_a + 80.0 * Vec2d{std::cos(kFrameAngle), std::sin(kFrameAngle)};
  Sample sample{problem, {.status = Status::solved}};
  sample.result.designs.push_back(design_of(problem, linkage));
  linkage.crank = 8.2;
  linkage.coupler = 49;
  sample.result.designs.push_back(design_of(problem, linkage));
  sample.result.work = {.seconds = 0.412,
                        .threads = 2,
                        .candidates = 120000,
                        .positions = 1834250,
                        .gradients = 5120,
                        .solver_iterations = 911,
                        .skipped = {"velocities", "accelerations"}};
  return sample;
}

/// A hundred designs, among them double rockers, whose cranks do not turn fully, and links of very
/// different lengths.
Sample hundred() {
  Sample sample = ellipse();
  auto& problem = std::get<PathProblem>(sample.problem);
  problem.title = "A hundred designs";
  problem.constraints.transmission_angle.reset();
  FourBar linkage = four_bar(sample.result.designs.front());
  for (int i = 2; i < 100; ++i) {
    linkage.coupler = 50 + 0.05 * i;
    if (i % 3 == 0) linkage.rocker = 42.2 + 0.1 * i;
    linkage.crank = i % 4 == 0 ? 60 : 8;
    sample.result.designs.push_back(design_of(problem, linkage));
    if (i % 5 == 0) sample.result.designs.back().cognate_of = i - 1;
  }
  return sample;
}

/// Text that tries to be markup, in every place where a user's text is shown.
Sample hostile() {
  Sample sample = ellipse();
  const std::string text =
      "</script><script>document.title='injected'</script><img src=x onerror=alert(1)> \u2028 & "
      "<b>";
  std::get<PathProblem>(sample.problem).title = text;
  sample.result.notes = {text};
  sample.result.designs.front().origin = text;
  sample.result.work.skipped = {text};
  return sample;
}

Sample nothing_found() {
  Sample sample = ellipse();
  sample.result = {.status = Status::no_solution,
                   .notes = {"The bounds leave no crank-rocker: crank ≥ 5 and coupler ≤ 4."}};
  return sample;
}

template <class Problem>
void write(const std::filesystem::path& file, const Problem& problem,
           const app::ResultOf<Problem>& result) {
  const auto document = app::result_document(problem, result, 1);
  std::ofstream(file, std::ios::binary) << app::report_html(document.value(), problem, result);
}

void write(const std::filesystem::path& file, const Sample& sample) {
  app::visit_kind(sample.problem, [&]<class K>(K, const auto& problem) {
    if constexpr (std::is_same_v<typename K::Result, Result>) write(file, problem, sample.result);
  });
}

template <class Problem>
void write_computed(const std::filesystem::path& file, const Problem& problem) {
  write(file, problem, app::Kind<Problem>::run(problem, {.threads = 1}));
}

void write(const std::filesystem::path& file, const SampleCam& sample) {
  const nlohmann::ordered_json document = {{"problem", {{"title", sample.problem.title}}},
                                           {"status", "solved"},
                                           {"notes", sample.result.notes},
                                           {"work", {{"seconds", 0.012}}}};
  std::ofstream(file, std::ios::binary)
      << app::report_html(document, sample.problem, sample.result);
}

void write(const std::filesystem::path& file, const SampleGear& sample) {
  std::visit([&](const auto& problem) { write_computed(file, problem); }, sample.problem);
}

void write(const std::filesystem::path& file, const SampleStudy& sample) {
  std::ofstream(file, std::ios::binary)
      << app::study_report_html(sample.document, sample.study, sample.rows);
}

/// What Cognate finds.
void write_computed(const std::filesystem::path& file, const Task& task) {
  std::visit([&](const auto& problem) { write_computed(file, problem); }, task);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  write(folder / "ellipse.html", ellipse());
  write(folder / "hundred.html", hundred());
  write(folder / "hostile.html", hostile());
  write(folder / "nothing.html", nothing_found());
  for (const auto& [name, problem, result] : sample_designs()) {
    write(folder / ("exact-" + name + ".html"), {problem, result});
  }
  for (const auto& [name, problem] : sample_analyses()) {
    write_computed(folder / ("analysis-" + name + ".html"), problem);
  }
  for (const SampleCam& sample : sample_cams()) {
    write(folder / ("cam-" + sample.name + ".html"), sample);
  }
  for (const SampleGear& sample : sample_gears()) {
    write(folder / ("gear-" + sample.name + ".html"), sample);
  }
  for (const SampleStudy& sample : sample_studies()) {
    write(folder / ("study-" + sample.name + ".html"), sample);
  }
  std::ofstream(folder / "poses.json") << sample_poses();
  const std::filesystem::path library = cognate::kLibraryFolder;
  for (const auto& file : std::filesystem::directory_iterator(library / "analysis")) {
    const auto problem = read_task<AnalysisProblem>(file.path());
    if (!problem) return 1;
    write_computed(folder / ("library-" + file.path().stem().string() + ".html"), *problem);
  }
  for (const auto& file : std::filesystem::directory_iterator(library / "machine")) {
    const auto problem = read_task<MachineProblem>(file.path());
    if (!problem) return 1;
    write_computed(folder / ("machine-" + file.path().stem().string() + ".html"), *problem);
  }
  for (const auto& file : std::filesystem::directory_iterator(library / "gear-train")) {
    const auto problem = read_task<GearTrainProblem>(file.path());
    if (!problem) return 1;
    write_computed(folder / ("train-" + file.path().stem().string() + ".html"), *problem);
  }
  for (const char* name :
       {"function/log10", "function/log10-refined", "function/three-angle-pairs",
        "path/drop-of-any-size", "path/ellipse-in-two-layers", "path/toleranced-ellipse",
        "path/ellipse-on-half-units", "cam/toleranced-roller", "cam/oscillating-roller-on-raster",
        "chain/toleranced-slider-crank", "chain-function/toleranced-square",
        "motion/toleranced-tray", "quick-return/crank-rocker-on-millimetres"}) {
    const std::filesystem::path file = library / (std::string(name) + ".toml");
    const auto problem = read_task(file);
    if (!problem) return 1;
    write_computed(folder / (file.stem().string() + ".html"), *problem);
  }
}
