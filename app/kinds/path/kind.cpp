#include "app/kinds/path/kind.hpp"

#include <fmt/core.h>

#include <cmath>

#include "app/console/messages.hpp"
#include "app/documents/json_values.hpp"
#include "app/study/atlas_file.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::PathProblem;

constexpr Entry kPath[] = {
    {"target.points", "[[x, y], ...]; 3 to 10000, or 2 to 9 for exact synthesis"},
    {"target.curve",
     "or: [[x, y], ...], a closed polyline, which a full turn of the crank follows"},
    {"target.svg_path",
     "or: a closed curve as SVG path data, \"M 0 0 C ...\", its y turned upwards"},
    {"target.svg", "or: an SVG file beside this one, its only path, in user units, untransformed"},
    {"target.svg_id", "of several paths the one of this id"},
    {"target.samples",
     "of a closed curve: points in equal steps along it (12 to 1000, default 80)"},
    {"target.place",
     "of a closed curve: \"given\" (default), or \"similar\": moved, turned, enlarged, not "
     "mirrored"},
    {"target.poses", "exact: [[x, y, angle_deg], ...] among the positions"},
    {"target.method", "\"least-squares\" (default) or \"exact\": every four-bar through them"},
    {"target.weights", "of the points (default 1)"},
    {"target.timing", "\"free\" (default), \"prescribed\" by crank_deg, or \"mixed\""},
    {"target.crank_deg", "the crank's angle at each point; mixed: or \"free\""},
    {"target.crank_reference",
     "of crank_deg: \"first\" (default; of the first timed point), \"frame\" or \"global\""},
    {"target.crank_sense", "\"either\" (default), \"ccw\" or \"cw\""},
    {"target.order", "\"cyclic\" (default) or \"any\""},
    {"mechanism.crank", "its length; coupler, rocker, frame: likewise, all free by default"},
    {"mechanism.pivot_a", "[x, y] of the crank's pivot, pivot_d: of the rocker's"},
    {"mechanism.fixed_pivots", "or: both"},
    {"mechanism.frame_angle_deg", "direction from A to D"},
    {"mechanism.coupler_point", "[u, v]: origin B, first axis from B to C"},
    {"mechanism.assembly", "\"open\" or \"crossed\"; both by default"}};

/// How many curves of an atlas a search begins with.
constexpr std::size_t kAtlasStarts = 48;

/// Whether the curve turns by more than some degrees at a vertex.
bool is_corner(const std::vector<Vec2d>& all, std::size_t k) {
  constexpr double kTangent = 0.1;
  const Vec2d before = all[k] - all[(k + all.size() - 1) % all.size()];
  const Vec2d after = all[(k + 1) % all.size()] - all[k];
  return !(std::abs(cross(before, after)) <= kTangent * dot(before, after));
}

/// Vertices of a closed curve, of very many some: corners, and others in even steps.
ordered_json drawn_curve(const problems::ClosedCurve& curve) {
  constexpr std::size_t kMostDrawn = 1000;
  const auto& all = curve.vertices();
  const std::size_t step = (all.size() + kMostDrawn - 1) / kMostDrawn;
  std::size_t corners = 0;
  for (std::size_t k = 0; k < all.size(); ++k) corners += is_corner(all, k);
  ordered_json vertices = ordered_json::array();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool kept = corners <= kMostDrawn && is_corner(all, k);
    if (kept || k % step == 0) vertices.push_back(app::to_json(all[k]));
  }
  return vertices;
}

}  // namespace

std::span<const Entry> Kind<PathProblem>::keys() {
  return kPath;
}

std::string Kind<PathProblem>::describe(const PathProblem& problem) {
  return titled(problem.title,
                fmt::format("path generation{}, {} points, {} timing{}",
                            problem.method == problems::PathMethod::exact ? " exactly" : "",
                            problem.points.size(), problems::to_string(problem.timing),
                            problem.atlas ? ", from the atlas " + problem.atlas->name : ""));
}

ColumnChoice Kind<PathProblem>::columns(const PathProblem& /*problem*/) {
  return {.error_unit = "length",
          .coupler_point = true,
          .places = true,
          .quantities = kObjectiveQuantities};
}

std::vector<problems::Fault> Kind<PathProblem>::faults(const PathProblem& problem) {
  const auto curves = problem_atlas(problem);
  return curves ? std::vector<problems::Fault>{} : curves.error();
}

tl::expected<std::vector<problems::Design>, std::vector<problems::Fault>>
Kind<PathProblem>::known_designs(const PathProblem& problem) {
  return problem_atlas(problem).map([&](const std::vector<problems::AtlasCurve>& curves) {
    return curves.empty() ? std::vector<problems::Design>{}
                          : atlas_starts(problem, curves, kAtlasStarts);
  });
}

problems::Result Kind<PathProblem>::run(const PathProblem& problem, const problems::Run& run) {
  problems::Result result = problems::solve(problem, run);
  if (!run.known.empty()) {
    result.notes.push_back(
        fmt::format("The search began with {} curves of the atlas, in addition to its own starts.",
                    run.known.size()));
  }
  return result;
}

ordered_json Kind<problems::PathProblem>::target_json(const problems::PathProblem& problem) {
  ordered_json points = ordered_json::array();
  for (const Vec2d& point : problem.points) points.push_back(app::to_json(point));
  ordered_json target = {{"kind", "path"}, {"points", points}};
  if (problem.curve) target["curve"] = drawn_curve(problem.curve->curve);
  return target;
}

}  // namespace cognate::app
