#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/python/arguments.hpp"
#include "app/python/arrays.hpp"
#include "app/python/document.hpp"
#include "app/python/exact.hpp"
#include "app/python/problem.hpp"
#include "app/python/watch.hpp"
#include "app/study/cache_folder.hpp"
#include "synthesis/exact/nine_point/constrained_path.hpp"
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

/// A row for each real four-bar, with both cognates where these solve the problem too.
py::dict table_of(const ExactPathSolutions& found, bool is_triplet) {
  std::vector<std::array<double, 10>> rows;
  std::vector<double> residuals, conditions;
  for (const PathRoot& root : found.roots) {
    if (!root.real) continue;
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

/// The parts of the four-bar in `given`; those that are None are free.
synthesis::FixedParts parts_of(const py::dict& given) {
  synthesis::FixedParts parts;
  const auto point = [&](const char* name, std::optional<Vec2d>& to) {
    if (!given[name].is_none()) to = point_of(given[name], name);
  };
  const auto number = [&](const char* name, std::optional<double>& to) {
    if (!given[name].is_none()) to = number_of(given[name], name);
  };
  const auto length = [&](const char* name, std::optional<double>& to) {
    if (!given[name].is_none()) to = length_of(given[name], name);
  };
  point("pivot_a", parts.pivot_a);
  point("pivot_d", parts.pivot_d);
  point("coupler_point", parts.coupler_point);
  number("frame_angle", parts.frame_angle);
  length("crank", parts.crank);
  length("coupler", parts.coupler);
  length("rocker", parts.rocker);
  length("frame", parts.frame);
  if (parts.coupler_point && !parts.coupler) {
    raise_fault("coupler_point", "is given without coupler; expected both");
  }
  return parts;
}

void expect_solved(ExactPathStatus status) {
  if (status == ExactPathStatus::wrong_count) {
    raise_fault("points",
                "and what else is given are not as many conditions as a four-bar has dimensions: "
                "with M angles given (0 counts as 1), N further points and G for given parts (a "
                "pivot or the coupler point 2, a length or angle 1), 2 (M - 1) + N + G is 8: nine "
                "points, five poses, or five points and both pivots are allowed");
  }
  if (status == ExactPathStatus::not_finite) {
    raise_fault("points", "are not finite, or too large to square; smaller numbers are allowed");
  }
}

/// `angles`: of the body at each point, NaN where it is free; may be None. `given`: parts of the
/// four-bar by name, each a value or None.
py::dict exact_path(const py::object& points, const py::object& angles, const py::dict& given,
                    const py::object& threads, const py::object& progress) {
  const RunOptions options = checked({py::none(), threads, py::none(), progress});
  std::vector<PathPose> positions;
  for (const Vec2d& at : points_of(points, "points")) positions.push_back({at, std::nullopt});
  if (!angles.is_none()) {
    const Numbers turned(angles, "angles");
    turned.expect("angles", "(n,), an angle for each point, NaN where it is free",
                  {static_cast<py::ssize_t>(positions.size())});
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (!std::isnan(turned.values()[i])) positions[i].angle = turned.values()[i];
    }
  }
  const synthesis::FixedParts parts = parts_of(given);
  const bool is_constrained = condition_count(parts) > 0;
  ExactPathSolutions found;
  Watch watch;
  const auto stop = [&] { return watch.interrupted().load(); };
  const auto report = [&](double share) {
    watch.report(share, std::numeric_limits<double>::infinity());
  };
  watch.run(progress, [&] {
    if (is_constrained) {
      found = synthesis::solve_constrained_path(positions, parts,
                                                {.threads = options.threads,
                                                 .stop = stop,
                                                 .progress = report,
                                                 .cache = app::cache_folder()})
                  .solutions;
    } else {
      found = synthesis::solve_exact_path(positions, {.threads = options.threads,
                                                      .set = std::nullopt,
                                                      .cache = app::cache_folder(),
                                                      .stop = stop,
                                                      .progress = report});
    }
  });
  expect_solved(found.status);
  return table_of(found, !is_constrained && found.system.kind.poses == 1);
}

}  // namespace

void bind_exact_paths(py::module_& module) {
  module.def("exact_path", &exact_path);
}

}  // namespace cognate::python
