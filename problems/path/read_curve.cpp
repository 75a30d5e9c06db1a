#include "problems/path/read_curve.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>

#include "problems/linkage/class_feasibility.hpp"
#include "problems/linkage/read_linkage.hpp"
#include "problems/path/curve/outline.hpp"
#include "problems/path/curve/svg_file.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kForms[] = {"curve", "svg_path", "svg"};
constexpr int kSamples = 80, kFewestSamples = 12, kMostSamples = 1000;
constexpr std::size_t kMostVertices = 100'000;

std::optional<TargetCurve> read_polyline(TableReader& target) {
  constexpr std::string_view kKey = "curve";
  const auto rows =
      target.twos(kKey, kNumber, "[x, y]", {.min = 3, .max = kMostVertices, .of = "points"});
  if (!rows) return std::nullopt;
  std::vector<Vec2d> vertices;
  for (const Two& point : *rows) vertices.push_back({point[0], point[1]});
  auto curve = closed_polyline(vertices);
  if (curve) return TargetCurve{*std::move(curve), {}, {}};
  target.fault(kKey, curve.error());
  return std::nullopt;
}

std::optional<TargetCurve> read_path_data(TableReader& target) {
  constexpr std::string_view kKey = "svg_path";
  auto text = target.text(kKey);
  if (!text) return std::nullopt;
  auto curve = closed_outline(*text);
  if (curve) return TargetCurve{*std::move(curve), *std::move(text), {}};
  const auto& [offset, message] = curve.error();
  target.faults().add(target.where_in_text(kKey, offset), "target.svg_path " + message);
  return std::nullopt;
}

std::optional<TargetCurve> read_drawing(TableReader& target, const std::filesystem::path& folder) {
  constexpr std::string_view kKey = "svg";
  const auto id = target.text("svg_id");
  const auto name = target.text(kKey);
  if (!name) return std::nullopt;
  if (folder.empty()) {
    target.fault(kKey, "names a file beside the problem file, but there is none; give svg_path");
    return std::nullopt;
  }
  auto path_data = path_data_of(folder / *name, id);
  if (!path_data) {
    target.fault(kKey, fmt::format("{} {}", in_quotes(*name), path_data.error()));
    return std::nullopt;
  }
  auto curve = closed_outline(*path_data);
  if (curve) return TargetCurve{*std::move(curve), *std::move(path_data), {}};
  const auto& [offset, message] = curve.error();
  target.fault(kKey, fmt::format("{}: its path data, at byte {} of {}, {}", in_quotes(*name),
                                 offset, path_data->size(), message));
  return std::nullopt;
}

/// Keys that say of points what a closed curve says itself.
void refuse_keys_of_points(TableReader& target, std::string_view form) {
  for (const std::string_view key :
       {"points", "poses", "weights", "crank_deg", "crank_reference"}) {
    if (!target.has(key)) continue;
    target.fault(key,
                 fmt::format("is given beside {}; a closed curve takes samples and place, with "
                             "free timing in cyclic order",
                             form));
  }
  const auto refuse_unless = [&](std::string_view key, std::string_view allowed, bool is_allowed) {
    if (is_allowed) return;
    target.fault(key, fmt::format("is not \"{}\" beside {}; remove it: a closed curve has free "
                                  "timing, cyclic order and the least-squares method",
                                  allowed, form));
  };
  refuse_unless("timing", "free",
                target.choice<Timing>("timing").value_or(Timing::free) == Timing::free);
  refuse_unless(
      "order", "cyclic",
      target.choice<PointOrder>("order").value_or(PointOrder::cyclic) == PointOrder::cyclic);
}

bool turns_fully(RequiredClass required) {
  return required == RequiredClass::crank_rocker || required == RequiredClass::double_crank ||
         required == RequiredClass::grashof;
}

void check_class(TableReader& mechanism, TableReader& constraints, const PathProblem& problem) {
  const auto& required = problem.constraints.required_class;
  if (required && !turns_fully(*required)) {
    return constraints.fault(
        "class",
        "has a crank that does not turn fully, and a closed curve is traced in "
        "a full turn; \"crank-rocker\", \"double-crank\" and \"grashof\" are "
        "allowed");
  }
  const LengthLimits limits = length_limits(problem.given, problem.bounds);
  if (class_is_possible(limits, RequiredClass::crank_rocker) ||
      class_is_possible(limits, RequiredClass::double_crank)) {
    return;
  }
  mechanism.faults().add(mechanism.where(),
                         "the lengths given and bounded exclude a crank that turns fully, and a "
                         "closed curve is traced in a full turn; crank or frame must be able to be "
                         "the shortest link of a Grashof linkage");
}

}  // namespace

bool has_curve(TableReader& target, std::initializer_list<std::string_view> keys) {
  const auto given =
      std::ranges::count_if(kForms, [&](std::string_view form) { return target.has(form); });
  for (const std::string_view key : keys) {
    if (!target.has(key) || given > 0) continue;
    target.fault(key, "is given without a closed curve; give one as curve, svg_path or svg");
  }
  return given > 0;
}

void read_curve(TableReader& target, const std::filesystem::path& folder, PathProblem& problem) {
  std::vector<std::string_view> forms;
  std::ranges::copy_if(kForms, std::back_inserter(forms),
                       [&](std::string_view form) { return target.has(form); });
  if (forms.size() > 1) {
    target.fault(forms[1],
                 fmt::format("is given beside {}; expected one of \"curve\", \"svg_path\" and "
                             "\"svg\"",
                             forms[0]));
  }
  if (target.has("svg_id") && !target.has("svg")) {
    target.fault("svg_id", "is given without svg; it names a path of the drawing");
  }
  refuse_keys_of_points(target, forms.front());
  const int samples = target.integer("samples", kFewestSamples, kMostSamples).value_or(kSamples);
  const auto place = target.choice<CurvePlace>("place").value_or(CurvePlace::given);
  auto curve = forms.front() == "curve"      ? read_polyline(target)
               : forms.front() == "svg_path" ? read_path_data(target)
                                             : read_drawing(target, folder);
  if (!curve) return;
  curve->place = place;
  problem.points = curve->curve.equally_spaced(samples);
  const double apart = 1e-9 * curve->curve.length();
  if (std::ranges::all_of(problem.points, [&](const Vec2d& point) {
        return norm(point - problem.points.front()) <= apart;
      })) {
    target.fault("samples", "all fall on one point of the curve; expected another number of them");
  }
  problem.weights.assign(problem.points.size(), 1.0);
  problem.constraints.full_turn = true;
  problem.curve = *std::move(curve);
}

void finish_curve(TableReader& mechanism, TableReader& bounds, TableReader& constraints,
                  PathProblem& problem) {
  problem.constraints.no_extra_loop = constraints.boolean("no_extra_loop").value_or(true);
  if (!problem.curve) return;
  check_class(mechanism, constraints, problem);
  if (problem.curve->place == CurvePlace::given) return;
  const auto refuse = [](TableReader& table, std::string_view key) {
    if (!table.has(key)) return;
    table.fault(key,
                "is given with target.place = \"similar\", where lengths, frame_angle_deg and the "
                "pivots of [mechanism] alone may be; remove it");
  };
  refuse(mechanism, "coupler_point");
  for (const std::string_view key : {"pivot_a", "pivot_d", "coupler_point"}) refuse(bounds, key);
  for (const std::string_view key : {"pivot_region", "clearance"}) refuse(constraints, key);
  for (const CycleDeclaration& quantity : kCycleQuantities) refuse(constraints, quantity.limit_key);
}

}  // namespace cognate::problems::reading
