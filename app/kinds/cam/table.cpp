#include "app/kinds/cam/table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"
#include "app/console/text_table.hpp"
#include "app/kinds/cam/description.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::app {
namespace {

using problems::CamDesign;
using problems::CamProblem;
using problems::CamResult;

std::optional<double> number_of(const CamDesign& design, std::string_view name) {
  const auto found = std::ranges::find(design.metrics, name, &problems::Fact::name);
  if (found == design.metrics.end()) return std::nullopt;
  const auto* number = std::get_if<double>(&found->value);
  return number && std::isfinite(*number) ? std::optional(*number) : std::nullopt;
}

/// "38.71 at 50": a fact and the cam angle of its place.
std::string placed(const CamDesign& design, const std::string& name) {
  const auto value = number_of(design, name), at = number_of(design, name + "_at_deg");
  if (!value) return "–";
  return at ? fmt::format("{:.5g} at {:.4g}", *value, *at) : fmt::format("{:.5g}", *value);
}

std::string constraints_text(const CamDesign& design) {
  const auto missed =
      std::ranges::count(design.constraints, false, &problems::ConstraintCheck::satisfied);
  return missed == 0 ? "all met" : fmt::format("{} missed", missed);
}

class Columns {
 public:
  explicit Columns(std::span<const CamDesign> designs) : designs_(designs) {}

  template <class Cell>
  void add(std::string heading, Align align, Cell cell) {
    Column column{std::move(heading), align, {}};
    for (const CamDesign& design : designs_) column.cells.push_back(cell(design));
    columns_.push_back(std::move(column));
  }

  std::string text(const Screen& screen) const { return table_text(columns_, screen); }

 private:
  std::span<const CamDesign> designs_;
  std::vector<Column> columns_;
};

void add_lengths(const CamProblem& problem, Columns& columns) {
  struct Length {
    const char* heading;
    double cam::CamDimensions<double>::*value;
  };
  using D = cam::CamDimensions<double>;
  constexpr std::array<Length, problems::kCamDimensions> kLengths = {
      {{"base radius", &D::base_radius},
       {"offset", &D::offset},
       {"roller radius", &D::roller_radius},
       {"centre distance", &D::centre_distance},
       {"arm", &D::arm},
       {"face offset", &D::face_offset}}};
  for (std::size_t i = 0; i < kLengths.size(); ++i) {
    if (!problem.lengths[i].used) continue;
    columns.add(
        std::string(kLengths[i].heading) + " [length]", Align::right, [&](const CamDesign& design) {
          return fmt::format("{:.6g}", design.cam.system.follower.dimensions.*kLengths[i].value);
        });
  }
}

void append_designs(std::string& text, const CamProblem& problem,
                    std::span<const CamDesign> designs, const Screen& screen) {
  Columns columns(designs);
  int number = 0;
  columns.add("#", Align::right, [&](const CamDesign&) { return std::to_string(++number); });
  add_lengths(problem, columns);
  const auto add_fact = [&](const char* heading, const char* name) {
    const bool any = std::ranges::any_of(
        designs, [&](const CamDesign& design) { return number_of(design, name).has_value(); });
    if (!any) return;
    columns.add(heading, Align::right,
                [&](const CamDesign& design) { return placed(design, name); });
  };
  add_fact("pressure of rise [deg at deg]", "pressure_angle_deg_max_rise");
  add_fact("of return [deg at deg]", "pressure_angle_deg_max_return");
  add_fact("least radius [length at deg]", "curvature_radius_min");
  add_fact("greatest torque [N m at deg]", "torque_max");
  columns.add("constraints", Align::left, constraints_text);
  columns.add("origin", Align::left, [](const CamDesign& d) { return printable(d.origin); });
  text += columns.text(screen);
}

/// Why the best design cannot be smaller.
std::string proof_line(const CamResult& result) {
  if (result.designs.empty() || !result.designs.front().proof) return {};
  const auto& proof = *result.designs.front().proof;
  std::string because;
  for (const auto& position : proof.positions) {
    because += fmt::format("{}{} = {:.6g} at {:.6g} deg", because.empty() ? "" : " and ",
                           position.limit, position.bound, problems::degrees(position.angle));
  }
  const double base = result.designs.front().cam.system.follower.dimensions.base_radius;
  const bool reached = base <= proof.base_radius_least * (1 + 1e-9);
  return fmt::format("{}: no base radius below {:.10g} keeps {}{}\n",
                     reached ? "proved" : "lower bound", proof.base_radius_least,
                     because.empty() ? "to the limits" : because,
                     proof.within.empty() ? "" : ", with " + proof.within);
}

}  // namespace

std::string cam_table(const CamProblem& problem, const CamResult& result, const Screen& screen) {
  std::string text = describe(problem) + '\n';
  text += status_text(result, screen.colour);
  const auto shown = shown_designs(result);
  if (!shown.empty()) append_designs(text, problem, shown, screen);
  return text + left_out_line(result.designs.size()) + '\n' +
         violations_text(result, screen.colour) + proof_line(result) + notes_text(result.notes) +
         work_line(result.work);
}

}  // namespace cognate::app
