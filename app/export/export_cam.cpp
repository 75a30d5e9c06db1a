#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "app/documents/csv.hpp"
#include "app/drawing/cam_drawing.hpp"
#include "app/drawing/plan.hpp"
#include "app/export/cam_centre.hpp"
#include "app/export/export_solids.hpp"
#include "app/export/exported.hpp"
#include "app/export/svg.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/cam/extremes.hpp"

namespace cognate::app {
namespace {

/// Half a line of the mark at the cam's centre, as a share of the reach.
constexpr double kCamCentreMark = 0.04;

const char* layer_of(CamCurveKind kind) {
  switch (kind) {
    case CamCurveKind::pitch:
      return "PITCH";
    case CamCurveKind::cutter:
      return "CUTTER";
    default:
      return "PROFILE";
  }
}

PlanOutline outline_of(const CamOutline& curve, const char* layer) {
  PlanOutline outline{layer, {}, true};
  outline.corners.reserve(curve.points.size());
  for (const auto& point : curve.points) outline.corners.push_back({point.at});
  return outline;
}

/// Adds a circle about the cam's centre unless it has no radius or is there already.
void add_circle(const char* layer, double radius, Plan& plan) {
  const bool known = std::ranges::any_of(plan.circles, [&](const PlanCircle& circle) {
    return circle.layer == layer && circle.radius == radius;
  });
  if (radius > 0 && !known) plan.circles.push_back({layer, {}, radius});
}

/// Each curve a closed outline on the layer PROFILE, PITCH or CUTTER, the base circles of the
/// profiles on BASE_CIRCLE, the prime circles of rollers on PRIME_CIRCLE, and two crossing lines on
/// CENTRE. It is called as `problem`, or "Cam" where that has no title.
Plan cam_plan(const CamDrawing& drawing, const problems::CamProblem& problem) {
  const char* layer = layer_of(drawing.kind);
  const double reach = reach_of(drawing);
  const PlanColour colour =
      drawing.kind == CamCurveKind::profile ? PlanColour::foreground : PlanColour::accent;
  Plan plan{
      .title = problem.title.empty() ? "Cam" : problem.title,
      .length_unit = problem.length_unit,
      .low = {-reach, -reach},
      .high = {reach, reach},
      .layers = {
          {layer, colour}, {"BASE_CIRCLE", PlanColour::grey, true}, {"CENTRE", PlanColour::red}}};
  if (std::ranges::any_of(drawing.curves,
                          [](const auto& curve) { return curve.prime_radius > 0; })) {
    plan.layers.push_back({"PRIME_CIRCLE", PlanColour::grey, true});
  }
  for (const auto& curve : drawing.curves) {
    plan.outlines.push_back(outline_of(curve, layer));
    add_circle("BASE_CIRCLE", curve.profile_radius, plan);
    add_circle("PRIME_CIRCLE", curve.prime_radius, plan);
  }
  const double arm = kCamCentreMark * reach;
  plan.outlines.push_back(plan_line("CENTRE", {-arm, 0}, {arm, 0}));
  plan.outlines.push_back(plan_line("CENTRE", {0, -arm}, {0, arm}));
  return plan;
}

/// The points of `curve` as CSV: cam_deg, x, y, normal_x, normal_y (unit, away from the material),
/// radius_of_curvature (negative where the curve is concave, empty where it is straight). Numbers
/// read back to the same doubles.
std::string curve_csv(const CamOutline& curve, std::string_view length) {
  std::array<problems::Column, 6> columns;
  constexpr std::array kNames = {"cam_deg",  "x",        "y",
                                 "normal_x", "normal_y", "radius_of_curvature"};
  constexpr std::array kUnits = {"deg", "length", "length", "", "", "length"};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    columns[i].name = kNames[i];
    columns[i].unit = kUnits[i];
    columns[i].values.reserve(curve.points.size());
  }
  for (const auto& point : curve.points) {
    const double radius =
        point.curvature != 0 ? 1 / point.curvature : std::numeric_limits<double>::quiet_NaN();
    const std::array row = {problems::degrees(point.angle),
                            point.at.x,
                            point.at.y,
                            point.normal.x,
                            point.normal.y,
                            radius};
    for (std::size_t i = 0; i < row.size(); ++i) columns[i].values.push_back(row[i]);
  }
  return csv_text(columns, {}, length);
}

using Refusal = std::optional<std::string>;

constexpr double kDefaultCamTolerance = 1e-4;  // of the base radius
constexpr double kLeastCamTolerance = 1e-9;    // as many points as can be handled
constexpr double kGreatestCutter = 1e6;        // of the base radius

/// What cuts: an option whose value is `times` the radius of the cutter or of the beam.
struct Cutting {
  const char* option;
  double value = 0;
  double times = 1;
};

/// Why a cutter cannot cut `cam`; empty where it can.
Refusal gouging(const problems::CamProblem& problem, const cam::Cam& cam, const Cutting& cutting) {
  const auto& [option, value, times] = cutting;
  const double roller = cam.system.follower.dimensions.roller_radius;
  if (problem.second.closure == cam::Closure::groove && value > times * roller) {
    return fmt::format("{}: {} does not fit into the groove; allowed is at most {}", option, value,
                       times * roller);
  }
  const auto hollow = problems::CamExtremes(cam).concave_radius();
  if (!hollow || value <= times * hollow->value) return std::nullopt;
  return fmt::format(
      "{}: {} would gouge the profile, whose least concave radius is {:.6g}, at {:.4g} deg of the "
      "cam; allowed is at most {}",
      option, value, hollow->value, problems::degrees(hollow->angle),
      times == 1 ? "that" : "twice that");
}

Refusal gouging(const ResultCam& given, const Cutting& cutting) {
  auto why = gouging(given.problem, given.design.cam, cutting);
  if (!why && given.design.second) why = gouging(given.problem, *given.design.second, cutting);
  return why;
}

/// Why the drawing is not possible for this cam; empty where it is.
Refusal refused_cam(const ResultCam& given, const CamDrawingOptions& wanted) {
  const auto& dimensions = given.design.cam.system.follower.dimensions;
  if (wanted.kind == CamCurveKind::pitch && dimensions.roller_radius == 0) {
    return "--curve: this follower has no roller, so there is no pitch curve; allowed is profile "
           "or cutter";
  }
  const double size = dimensions.base_radius, tolerance = wanted.chord_tolerance;
  if (!(tolerance >= kLeastCamTolerance * size && tolerance <= size)) {
    return fmt::format(
        "--chord-tolerance: {} is not possible for a base radius of {}; allowed is a length from "
        "{:.3g} to {:.6g}",
        tolerance, size, kLeastCamTolerance * size, size);
  }
  if (wanted.kerf > 0 && wanted.kind != CamCurveKind::profile) {
    return "--kerf: is that of a profile; expected --curve profile with it";
  }
  if (wanted.kerf > 0) return gouging(given, {"--kerf", wanted.kerf, 2});
  if (wanted.kind != CamCurveKind::cutter) return std::nullopt;
  if (wanted.cutter_radius > kGreatestCutter * size) {
    return fmt::format(
        "--cutter-radius: {} is too large for a base radius of {}; allowed is at most {:.6g}",
        wanted.cutter_radius, size, kGreatestCutter * size);
  }
  return gouging(given, {"--cutter-radius", wanted.cutter_radius});
}

/// The drawing of the cam; the error says which option is not possible and what is allowed.
tl::expected<CamDrawing, std::string> drawing_of(const ResultCam& given,
                                                 const ExportOptions& wanted) {
  const double size = given.design.cam.system.follower.dimensions.base_radius;
  const CamDrawingOptions options{wanted.curve, wanted.cutter_radius.value_or(0),
                                  wanted.chord_tolerance.value_or(kDefaultCamTolerance * size),
                                  wanted.kerf};
  if (const auto why = refused_cam(given, options)) return tl::unexpected(*why);
  if (auto drawing = cam_drawing(given.problem, given.design, options)) return *std::move(drawing);
  return tl::unexpected(
      fmt::format("--chord-tolerance: {:.3g} would take more than {} points; allowed is a greater "
                  "length",
                  options.chord_tolerance, kMostCamPoints));
}

std::string named_after_curve(std::string name, CamCurveKind curve) {
  if (curve == CamCurveKind::pitch) name += ".pitch";
  if (curve == CamCurveKind::cutter) name += ".cutter";
  return name;
}

using Files = tl::expected<std::vector<ExportedFile>, std::string>;

Files files_of(const CamDrawing& drawing, const problems::CamProblem& problem,
               const ExportOptions& wanted, const std::string& stem) {
  if (declaration(wanted.format).is_drawn()) {
    Plan plan = cam_plan(drawing, problem);
    if (const auto done = add_cam_centre(drawing, wanted, problem.length_unit, plan); !done) {
      return tl::unexpected(done.error());
    }
    const std::string text =
        wanted.format == ExportFormat::dxf ? dxf_text(plan, wanted.version) : svg_text(plan);
    return std::vector<ExportedFile>{
        {fmt::format("{}.{}", stem, declaration(wanted.format).word), text}};
  }
  // NAME.csv is the table of the cam over its turn.
  const std::string only = wanted.curve == CamCurveKind::profile ? ".profile" : "";
  std::vector<ExportedFile> files;
  for (const auto& curve : drawing.curves) {
    files.push_back({stem + (curve.name.empty() ? only : "." + curve.name) + ".csv",
                     curve_csv(curve, length_word(problem.length_unit))});
  }
  return files;
}

std::vector<std::string> notes_of(const CamDrawing& drawing) {
  std::vector<std::string> notes;
  for (const auto& curve : drawing.curves) {
    if (!curve.crosses_itself) continue;
    notes.push_back(fmt::format("the curve{}{} crosses itself: the cam is undercut there",
                                curve.name.empty() ? "" : " ", curve.name));
  }
  return notes;
}

std::size_t point_count(const CamDrawing& drawing) {
  std::size_t count = 0;
  for (const auto& curve : drawing.curves) count += curve.points.size();
  return count;
}

/// Why there is no solid of the cam; empty where there is one.
Refusal refused_solid(const ResultCam& given, const ExportOptions& wanted) {
  if (wanted.curve != CamCurveKind::profile) {
    return "--curve: a solid is that of a profile; expected --curve profile with it";
  }
  if (given.problem.second.closure == cam::Closure::groove) {
    return "--format: no solids are made of grooves; allowed is dxf for their walls";
  }
  return std::nullopt;
}

/// The cam, or the cams of a conjugate pair one on the other.
tl::expected<Exported, std::string> cam_solids(const ResultCam& given, const CamDrawing& drawing,
                                               const ExportOptions& wanted,
                                               const std::string& stem) {
  if (const auto why = refused_solid(given, wanted)) return tl::unexpected(*why);
  const auto& problem = given.problem;
  const auto bore = cam_bore(drawing, wanted, problem.length_unit);
  if (!bore) return tl::unexpected(bore.error());
  SolidAssembly assembly =
      empty_assembly(problem.title.empty() ? stem : problem.title, problem.length_unit);
  for (const CamOutline& curve : drawing.curves) {
    WheelSolid wheel{.name = curve.name.empty() ? "cam" : curve.name,
                     .outline = {outline_of(curve, "").corners},
                     .bore = *bore};
    wheel.low = static_cast<double>(assembly.solids.size()) * wanted.thickness.value_or(0);
    // One hub, on the uppermost.
    if (assembly.solids.size() + 1 < drawing.curves.size()) wheel.bore.hub = 0;
    auto solid = wheel_solid(wheel, wanted);
    if (!solid) return tl::unexpected(solid.error());
    assembly.solids.push_back(*std::move(solid));
  }
  assembly.chord_tolerance = drawing.chord_tolerance;
  auto made = export_solids(assembly, wanted, stem);
  if (made && !problem.length_unit) made->notes.emplace_back(kMillimetresAssumed);
  return made;
}

}  // namespace

tl::expected<Exported, std::string> export_cam(const ResultCam& given, const ExportOptions& wanted,
                                               const std::string& stem) {
  if (!declaration(wanted.format).of_cams) {
    return tl::unexpected(refused_format(&FormatDeclaration::of_cams, "a cam"));
  }
  if (!wanted.of_linkages.empty()) {
    return tl::unexpected(
        wanted.of_linkages +
        ": is for linkages; of a cam --curve, --cutter-radius, --kerf, --bore, --keyway, "
        "--hub, --hub-length, --thickness and --timing-mark are allowed");
  }
  const auto drawing = drawing_of(given, wanted);
  if (!drawing) return tl::unexpected(drawing.error());
  if (declaration(wanted.format).is_solid()) return cam_solids(given, *drawing, wanted, stem);
  auto files = files_of(*drawing, given.problem, wanted, named_after_curve(stem, wanted.curve));
  if (!files) return tl::unexpected(files.error());
  const std::size_t points = point_count(*drawing);
  nlohmann::ordered_json quantities = {{"points", points},
                                       {"chord_tolerance", drawing->chord_tolerance}};
  if (wanted.kerf > 0) quantities["kerf"] = wanted.kerf;
  return Exported{*std::move(files), notes_of(*drawing),
                  fmt::format("{} points, nowhere farther than {:.3g} from the curve", points,
                              drawing->chord_tolerance),
                  std::move(quantities)};
}

}  // namespace cognate::app
