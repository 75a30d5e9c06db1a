#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "app/console/design_table.hpp"
#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"
#include "app/console/tolerance_table.hpp"
#include "app/documents/csv.hpp"
#include "app/kinds/cam/kind.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/cam/turn_table.hpp"

namespace cognate::app {
namespace {

using problems::CamDesign;
using problems::CamProblem;
using problems::CamResult;
using problems::to_string;

/// "base_radius and offset", the lengths that are found; empty where all are given.
std::string free_lengths(const problems::CamProblem& problem) {
  std::string text;
  for (const auto& dimension : problems::names<problems::CamDimension>()) {
    const auto& length = problem.length(dimension.value);
    if (length.used && !length.given) {
      text += fmt::format("{}{}", text.empty() ? "" : ", ", dimension.name);
    }
  }
  return text;
}

std::optional<double> number_of(const CamDesign& design, std::string_view name) {
  const auto found = std::ranges::find(design.metrics, name, &problems::Quantity::name);
  if (found == design.metrics.end()) return std::nullopt;
  const auto* number = std::get_if<double>(&found->value);
  return number && std::isfinite(*number) ? std::optional(*number) : std::nullopt;
}

/// "38.71 at 50": a quantity and the cam angle of its place.
std::string placed(const CamDesign& design, const std::string& name) {
  const auto value = number_of(design, name), at = number_of(design, name + "_at_deg");
  if (!value) return kNoValue;
  return at ? fmt::format("{:.5g} at {:.4g}", *value, *at) : fmt::format("{:.5g}", *value);
}

/// Whether the follower has a roller, and the cam a prime circle beside its base circle.
bool rolls(const CamProblem& problem) {
  return problem.length(problems::CamDimension::roller_radius).used && !is_knife(problem.follower);
}

void add_lengths(const CamProblem& problem, DesignTable<CamDesign>& columns) {
  struct Length {
    const char* heading;
    double cam::CamDimensions<double>::*value;
  };
  using D = cam::CamDimensions<double>;
  const std::array<Length, problems::kCamDimensions> lengths = {
      {{rolls(problem) ? "prime radius" : "base radius", &D::base_radius},
       {"offset", &D::offset},
       {"roller radius", &D::roller_radius},
       {"centre distance", &D::centre_distance},
       {"arm", &D::arm},
       {"face offset", &D::face_offset}}};
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const bool rolling = i == static_cast<std::size_t>(problems::CamDimension::roller_radius);
    if (!problem.lengths[i].used || (rolling && !rolls(problem))) continue;
    columns.add(
        std::string(lengths[i].heading) + " [length]", Align::right, [&](const CamDesign& design) {
          return fmt::format("{:.6g}", design.cam.system.follower.dimensions.*lengths[i].value);
        });
    if (i > 0 || !rolls(problem)) continue;
    columns.add("base radius [length]", Align::right, [](const CamDesign& design) {
      const auto& dimensions = design.cam.system.follower.dimensions;
      return fmt::format("{:.6g}", dimensions.base_radius - dimensions.roller_radius);
    });
  }
}

std::string designs_text(const CamProblem& problem, std::span<const CamDesign> designs,
                         const Screen& screen) {
  if (designs.empty()) return {};
  DesignTable<CamDesign> columns(designs);
  add_lengths(problem, columns);
  const auto add_quantity = [&](const char* heading, const char* name) {
    columns.add_if_any(heading, Align::right,
                       [&](const CamDesign& design) { return placed(design, name); });
  };
  add_quantity("pressure of rise [deg at deg]", "pressure_angle_deg_max_rise");
  add_quantity("of return [deg at deg]", "pressure_angle_deg_max_return");
  add_quantity("least radius [length at deg]", "curvature_radius_min");
  add_quantity("greatest torque [N m at deg]", "torque_max");
  columns.add_constraints();
  columns.add("origin", Align::left, [](const CamDesign& d) { return printable(d.origin); });
  return table_text(columns.columns(), screen);
}

/// Why the best design cannot be smaller.
std::string proof_line(const CamProblem& problem, const CamResult& result) {
  if (result.designs.empty() || !result.designs.front().proof) return {};
  const auto& proof = *result.designs.front().proof;
  std::string because;
  for (const auto& position : proof.positions) {
    because += fmt::format("{}{} = {:.6g} at {:.6g} deg", because.empty() ? "" : " and ",
                           position.limit, position.bound, problems::degrees(position.angle));
  }
  const double base = result.designs.front().cam.system.follower.dimensions.base_radius;
  const bool reached = base <= proof.base_radius_least * (1 + 1e-9);
  return fmt::format("{}: no {} radius below {:.10g} keeps {}{}\n",
                     reached ? "proved" : "lower bound", rolls(problem) ? "prime" : "base",
                     proof.base_radius_least, because.empty() ? "to the limits" : because,
                     proof.within.empty() ? "" : ", with " + proof.within);
}

}  // namespace

std::string Kind<CamProblem>::refusal(const CamProblem& /*problem*/, Command command) {
  if (command == Command::solve) return "";
  return "kind is \"cam\": 'cognate solve' designs a cam, and evaluates one whose dimensions are "
         "all given; expected kind = \"analysis\" with a whole [mechanism]";
}

namespace {

/// Of the best cam: those of the others are in the result.
std::string tolerances_text(const CamResult& result, const Screen& screen) {
  if (result.designs.empty() || !result.designs.front().tolerance) return {};
  return tolerance_table(*result.designs.front().tolerance, screen);
}

}  // namespace

std::string Kind<CamProblem>::describe(const CamProblem& problem) {
  const std::size_t segments = problem.motion.size();
  std::string what = fmt::format("cam of a follower {}, {} segment{} of motion",
                                 to_string(problem.follower), segments, segments == 1 ? "" : "s");
  const std::string lengths = free_lengths(problem);
  if (!lengths.empty()) what += ", free: " + lengths;
  const std::size_t free = problem.free_motion.size();
  if (free > 0) what += fmt::format(", {} free value{} of the motion", free, free == 1 ? "" : "s");
  return titled(problem.title, what);
}

std::string Kind<CamProblem>::table(const CamProblem& problem, const CamResult& result,
                                    const Screen& screen) {
  return result_table({.heading = describe(problem),
                       .designs = designs_text(problem, shown_designs(result), screen),
                       .after = tolerances_text(result, screen) + proof_line(problem, result)},
                      result, screen);
}

std::string Kind<CamProblem>::csv(const CamProblem& problem, const CamResult& result, int steps) {
  if (result.designs.empty()) return csv_text({});
  return csv_text(problems::turn_table(problem, result.designs.front(), steps), {},
                  length_word(problem.length_unit));
}

}  // namespace cognate::app
