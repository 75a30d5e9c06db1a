/// Prints whether the curves of an atlas are good starts: random coupler curves that are not in it,
/// met by its nearest curves alone, by the search, and by both.
#include <fmt/core.h>

#include <random>
#include <vector>

#include "analysis/linkage/mobility.hpp"
#include "problems/path/atlas_starts.hpp"

namespace cognate::bench {
namespace {

using problems::AtlasCurve;
using problems::PathProblem;

constexpr std::size_t kCurves = 3000;
constexpr std::size_t kTargets = 12;
constexpr double kMet = 1e-3;  ///< greatest error; the curves are some 10 long

CurveRoom curve_of(const FourBar& linkage, std::size_t steps) {
  CurveRoom curve;
  sample_circuit(linkage, {linkage.assembly, 1}, CycleTable(steps), curve);
  return curve;
}

std::vector<AtlasCurve> crank_rockers(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 random(seed);
  const auto draw = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  std::vector<AtlasCurve> curves;
  while (curves.size() < count) {
    const FourBar linkage{{0, 0},
                          {draw(1.5, 5), 0},
                          1,
                          draw(1.5, 5),
                          draw(1.5, 5),
                          Assembly::open,
                          Vec2d{draw(-1, 4), draw(-3, 3)}};
    const auto links = lengths(linkage);
    if (!crank_rotates(links) || transmission_angles(links).acute_min < 0.4) continue;
    curves.push_back({linkage, DescriptorFinder()(curve_of(linkage, 512).samples())});
  }
  return curves;
}

PathProblem problem_of(const FourBar& linkage) {
  const CurveRoom curve = curve_of(linkage, 720);
  std::vector<Vec2d> vertices;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    vertices.push_back(Vec2d{5, 5} + Vec2d{2, 1} * Vec2d{curve.x[i], curve.y[i]});
  }
  PathProblem problem;
  problem.curve =
      problems::TargetCurve{problems::ClosedCurve(vertices), "", problems::CurvePlace::given};
  problem.points = problem.curve->curve.equally_spaced(40);
  problem.bounds.crank = problem.bounds.coupler = problem.bounds.rocker = problems::Range{0.1, 100};
  problem.solve.designs = 1;
  return problem;
}

struct Way {
  const char* name;
  std::size_t known;
  bool searches;
};

void run() {
  const auto atlas = crank_rockers(5, kCurves);
  const auto targets = crank_rockers(99, kTargets);
  fmt::print("| starts | met | mean s |\n| --- | ---: | ---: |\n");
  for (const Way& way : {Way{"8 of the atlas", 8, false}, Way{"48 of the atlas", 48, false},
                         Way{"the search's", 0, true}, Way{"both", 48, true}}) {
    int met = 0;
    double seconds = 0;
    for (const AtlasCurve& target : targets) {
      PathProblem problem = problem_of(target.linkage);
      if (!way.searches) problem.solve.starts = 0;
      problems::Run run;
      run.threads = 1;
      run.known = atlas_starts(problem, atlas, way.known);
      const auto result = solve(problem, run);
      seconds += result.work.seconds;
      met += !result.designs.empty() && result.designs.front().error.max < kMet ? 1 : 0;
    }
    fmt::print("| {} | {}/{} | {:.3f} |\n", way.name, met, kTargets, seconds / kTargets);
  }
}

}  // namespace
}  // namespace cognate::bench

int main() {
  cognate::bench::run();
}
