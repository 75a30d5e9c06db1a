#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "app/python/arrays.hpp"
#include "app/python/document.hpp"
#include "app/python/exact.hpp"
#include "app/python/problem.hpp"
#include "app/python/watch.hpp"
#include "app/study/cache_folder.hpp"
#include "synthesis/exact/nine_point/nine_point.hpp"

namespace cognate::python {
namespace {

using synthesis::ExactPathSolutions;
using synthesis::ExactPathStatus;
using synthesis::PathPose;
using synthesis::PathRoot;
using synthesis::PathSystem;

/// A design in the columns of batches, in the assembly that it has at the reference position.
std::array<double, 10> design_of(const PathSystem& system, const PathRoot& root) {
  const Vec2d a = to_plane(system, root.first.fixed), b = to_plane(system, root.first.moving);
  const Vec2d d = to_plane(system, root.second.fixed), c = to_plane(system, root.second.moving);
  const double coupler = norm(c - b);
  const Vec2d axis = (1 / coupler) * (c - b);
  const Vec2d point = conj(axis) * (system.origin - b);
  const double side = cross(d - b, c - b) >= 0 ? 1 : -1;
  return {a.x, a.y, d.x, d.y, norm(b - a), coupler, norm(c - d), side, point.x, point.y};
}

const char* word(ExactPathStatus status) {
  switch (status) {
    case ExactPathStatus::solved:
      return "solved";
    case ExactPathStatus::wrong_count:
      return "wrong-count";
    case ExactPathStatus::not_finite:
      return "not-finite";
    case ExactPathStatus::coincident:
      return "coincident";
    case ExactPathStatus::dependent:
      return "dependent";
    case ExactPathStatus::interrupted:
      return "interrupted";
  }
  return "";
}

/// A row for each real four-bar, of nine points with both cognates.
py::dict table_of(const ExactPathSolutions& found) {
  std::vector<std::array<double, 10>> rows;
  std::vector<double> residuals, conditions;
  for (const PathRoot& root : found.roots) {
    if (!root.real) continue;
    const bool is_triplet = found.system.kind.poses == 1;
    const auto all = is_triplet ? cognates(found.system, root) : std::array{root, root, root};
    for (std::size_t k = 0; k < (is_triplet ? 3 : 1); ++k) {
      rows.push_back(design_of(found.system, all[k]));
      residuals.push_back(all[k].residual);
      conditions.push_back(all[k].condition);
    }
  }
  NewArray designs = new_columns({static_cast<py::ssize_t>(rows.size()), 10});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < 10; ++k) designs.data[k * rows.size() + i] = rows[i][k];
  }
  py::dict table;
  table["status"] = word(found.status);
  table["designs"] = designs.array;
  table["residual"] = to_array(residuals);
  table["condition"] = to_array(conditions);
  table["finite"] = found.finite;
  table["tracked"] = found.tracked;
  table["lost"] = found.lost;
  return table;
}

/// `angles`: of the body at each point, NaN where it is free; may be None.
py::dict exact_path(const py::object& points, const py::object& angles, const py::object& threads,
                    const py::object& progress) {
  const RunOptions options = checked({py::none(), threads, py::none(), progress});
  std::vector<PathPose> positions;
  for (const Vec2d& at : points_of(points, "points")) positions.push_back({at, std::nullopt});
  if (!angles.is_none()) {
    const Numbers given(angles, "angles");
    given.expect("angles", "(n,), an angle for each point, NaN where it is free",
                 {static_cast<py::ssize_t>(positions.size())});
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (!std::isnan(given.values()[i])) positions[i].angle = given.values()[i];
    }
  }
  ExactPathSolutions found;
  Watch watch;
  watch.run(progress, [&] {
    found = synthesis::solve_exact_path(
        positions,
        {.threads = options.threads,
         .set = std::nullopt,
         .cache = app::cache_folder(),
         .stop = [&] { return watch.interrupted().load(); },
         .progress =
             [&](double share) { watch.report(share, std::numeric_limits<double>::infinity()); }});
  });
  if (found.status == ExactPathStatus::wrong_count) {
    raise_fault("points",
                "have not as many conditions as a four-bar has dimensions: with M angles "
                "given (0 counts as 1) and N further points, 2 (M - 1) + N is 8; nine "
                "points, or five poses, are allowed");
  }
  if (found.status == ExactPathStatus::not_finite) {
    raise_fault("points", "are not finite, or too large to square; smaller numbers are allowed");
  }
  return table_of(found);
}

}  // namespace

void bind_exact_paths(py::module_& module) {
  module.def("exact_path", &exact_path);
}

}  // namespace cognate::python
