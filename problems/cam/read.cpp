#include "problems/tolerance/read.hpp"

#include <fmt/core.h>

#include "problems/cam/problem.hpp"
#include "problems/cam/read_bounds.hpp"
#include "problems/cam/read_constraints.hpp"
#include "problems/cam/read_follower.hpp"
#include "problems/cam/read_lengths.hpp"
#include "problems/cam/read_motion.hpp"
#include "problems/cam/read_operation.hpp"
#include "problems/cam/read_raster.hpp"
#include "problems/cam/read_tolerances.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {
namespace {

/// The tables of the file but those of its operation.
struct Tables {
  TableReader follower, mechanism, bounds, target, constraints, solve;
};

void read_rotation(TableReader& mechanism, CamProblem& problem) {
  constexpr std::string_view kSenses[] = {"ccw", "cw"};
  problem.clockwise = mechanism.choice_of("rotation", kSenses).value_or(0) == 1;
}

void read_solve(TableReader& solve, CamProblem& problem) {
  problem.solve = reading::read_solve(solve, {}, false);
  if (!solve.has("designs")) problem.solve.designs = 1;
  const synthesis::Solver solver = problem.solve.solver;
  if (solver == synthesis::Solver::automatic || !linearises_residuals(solver)) return;
  solve.fault("solver",
              fmt::format("is \"{}\", which minimises sums of squares, and a cam's objective is "
                          "none; expected \"auto\" or a solver of NLopt or Ipopt",
                          to_string(solver)));
}

ToleranceScope cam_scope(const CamProblem& problem) {
  ToleranceScope scope;
  for (const auto& [name, dimension] : names<CamDimension>()) {
    if (problem.has_tolerance(dimension)) scope.dimensions.emplace_back(name);
  }
  scope.has_pivots = false;
  if (cam::is_oscillating(problem.follower)) scope.unit = "deg";
  return scope;
}

void read_tables(TableReader& document, Tables& tables, CamProblem& problem) {
  const std::size_t before = document.faults().size();
  CamLengthTables lengths{tables.follower, tables.mechanism, tables.bounds};
  read_rotation(tables.mechanism, problem);
  read_cam_lengths(lengths, problem);
  read_cam_operation(document, tables.follower, problem);
  read_cam_motion(document, problem);
  read_cam_objective(tables.target, problem);
  read_cam_constraints(tables.constraints, problem);
  read_solve(tables.solve, problem);
  read_cam_raster(document, problem);
  problem.tolerances = read_tolerances(document, cam_scope(problem));
  for (TableReader* table : {&tables.follower, &tables.mechanism, &tables.bounds, &tables.target,
                             &tables.constraints, &tables.solve}) {
    table->finish();
  }
  if (document.faults().size() > before) return;  // what follows takes the rest for granted
  check_cam_assembly(lengths, problem);
  check_cam_tolerances(document, problem);
  if (problem.raster) {
    check_cam_raster(document, problem);
  } else {
    check_cam_size(tables.mechanism, problem);
  }
  check_preload(tables.follower, problem);
}

}  // namespace

}  // namespace cognate::problems::reading

namespace cognate::problems {

CamProblem KindTraits<CamProblem>::read(reading::TableReader& document,
                                        const std::filesystem::path& /*folder*/) {
  using namespace reading;
  CamProblem problem;
  Tables tables{document.table("follower"), document.table("mechanism"),   document.table("bounds"),
                document.table("target"),   document.table("constraints"), document.table("solve")};
  if (read_follower(tables.follower, problem)) {
    read_tables(document, tables, problem);
  } else {
    document.know({"motion", "drive", "contact", "tolerance", "raster"});
  }
  return problem;
}

}  // namespace cognate::problems
