#include "app/console/design_columns.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <variant>

#include "analysis/mechanism/joints.hpp"
#include "app/console/design_table.hpp"
#include "app/console/messages.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/evaluation/type_quantities.hpp"
#include "problems/linkage/linkage_keys.hpp"
#include "problems/mechanism/dimensions.hpp"

namespace cognate::app {
namespace {

using problems::Design;
using problems::Metrics;
using Designs = std::span<const Design>;

std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : kNoValue;
}

std::string number(const std::optional<double>& value, int digits) {
  return value ? number(*value, digits) : kNoValue;
}

/// "peak acceleration [length/s²]", from the unit "length/s2".
std::string with_unit(std::string_view heading, std::string_view unit) {
  if (unit.empty()) return std::string(heading);
  std::string shown;
  for (const char c : unit) shown += c == '2' ? "²" : std::string(1, c);
  return fmt::format("{} [{}]", heading, shown);
}

std::string class_text(const Design& design) {
  const Metrics& metrics = design.metrics;
  const auto& quantities = metrics.quantities;
  const std::string name =
      metrics.mobility ? std::string(problems::to_string(*metrics.mobility))
                       : printable(find_quantity(quantities, problems::kClassKey).value_or(""));
  if (name.empty()) return kNoValue;
  if (!metrics.change_point) return name;
  const auto kind = find_quantity(quantities, problems::kChangePointKindKey).value_or("single");
  return name + (kind != "single" ? " (" + printable(kind) + ")" : " (change point)");
}

/// A design of a type without transmission angle has zeros there.
std::string transmission_text(const Design& design) {
  const Metrics& metrics = design.metrics;
  if (!(metrics.transmission_max > 0)) return kNoValue;
  // Angles are not negative; rounding may have left a sign on zero.
  return fmt::format("{:.1f}…{:.1f}", std::abs(problems::degrees(metrics.transmission_min)),
                     problems::degrees(metrics.transmission_max));
}

std::string defects_text(const Design& design) {
  std::string text;
  for (const auto defect : design.metrics.defects) {
    if (!text.empty()) text += ", ";
    text += problems::to_string(defect);
  }
  return text.empty() ? "none" : text;
}

std::string origin_text(const Design& design) {
  std::string text = printable(design.origin);
  if (design.cognate_of) text += fmt::format(", cognate of {}", *design.cognate_of + 1);
  if (design.mirror_of) text += fmt::format(", mirror image of {}", *design.mirror_of + 1);
  if (design.twin_of) text += fmt::format(", links of {}", *design.twin_of + 1);
  if (!design.differs.empty()) text += fmt::format(", other {}", fmt::join(design.differs, ", "));
  return text;
}

std::string dimensions_text(const Design& design) {
  std::string text;
  for (const auto& [name, value] : main_dimensions(design.mechanism)) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {}", name, number(value, 6));
  }
  return text.empty() ? kNoValue : text;
}

std::string coupler_point_text(const Design& design) {
  const auto& mechanism = design.mechanism;
  if (mechanism.four_bar() && mechanism.four_bar()->coupler_point) {
    const Vec2d& p = *mechanism.four_bar()->coupler_point;
    return fmt::format("[{}, {}]", number(p.x, 6), number(p.y, 6));
  }
  if (mechanism.extra_points.empty()) return kNoValue;
  const Vec2d& p = mechanism.extra_points.front().at;
  return fmt::format("[{}, {}]", number(p.x, 6), number(p.y, 6));
}

/// The largest of what a design's lengths are, beside which less is rounding.
double size_of(const Design& design) {
  double size = 0;
  for (const auto& dimension : problems::main_dimensions(design.mechanism)) {
    size = std::max(size, std::abs(dimension.value));
  }
  return size;
}

/// `value`, or that it is nothing but rounding beside `size`.
std::string error_text(double value, double size, int digits) {
  constexpr double kRounding = 1e-12;
  return std::abs(value) <= kRounding * size ? "exact (to rounding)" : number(value, digits);
}

/// "[0, 0] [3.5, 0]": the pins of the frame.
std::string pivots_text(const Design& design) {
  std::string text;
  for (const Joint& joint : joints(design.mechanism.mechanism).joints) {
    if (joint.type != JointType::revolute || joint.at.body != 0) continue;
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : " ", number(joint.at.at.x, 6),
                        number(joint.at.at.y, 6));
  }
  return text.empty() ? kNoValue : text;
}

std::string assembly_text(const Design& design) {
  const FourBar* linkage = design.mechanism.four_bar();
  return linkage ? std::string(problems::to_string(linkage->assembly)) : kNoValue;
}

/// The crank's angle at the first target, of a driving slider its place.
std::string first_drive_text(const Design& design) {
  if (design.crank_angles.empty()) return kNoValue;
  const bool slides = driven_by_length(design.mechanism.mechanism.drive);
  const double at = design.crank_angles.front();
  return number(slides ? at : problems::degrees(at), 6);
}

std::string degrees_text(const std::optional<double>& angle) {
  return angle ? number(problems::degrees(*angle), 6) : kNoValue;
}

std::string quantity_text(const Design& design, std::string_view name) {
  const auto quantity =
      std::ranges::find(design.metrics.quantities, name, &problems::Quantity::name);
  if (quantity == design.metrics.quantities.end()) return kNoValue;
  if (const auto* text = std::get_if<std::string>(&quantity->value)) return printable(*text);
  const auto* value = std::get_if<double>(&quantity->value);
  return value ? number(*value, 5) : kNoValue;
}

class Columns : public DesignTable<Design> {
 public:
  using DesignTable::DesignTable;

  void add_errors(std::string_view unit) {
    if (unit.empty()) return;
    const double scale = unit == "deg" ? problems::degrees(1) : 1;
    const auto add_error = [&](std::string_view name, double problems::TargetError::*part) {
      add(fmt::format("{} [{}]", name, unit), Align::right, [=](const Design& d) {
        const double size = unit == "deg" ? problems::degrees(1) : size_of(d);
        return error_text(scale * (d.error.*part), size, 4);
      });
    };
    add_error("rms", &problems::TargetError::rms);
    add_error("max", &problems::TargetError::max);
  }

  void add_dimensions() {
    const auto type =
        designs().empty() ? problems::MechanismType::four_bar : designs().front().mechanism.type();
    const bool alike =
        type != problems::MechanismType::chain &&
        std::ranges::all_of(designs(), [&](const Design& d) { return d.mechanism.type() == type; });
    if (!alike || type != problems::MechanismType::four_bar) {
      add("mechanism", Align::left,
          [](const Design& d) { return std::string(problems::to_string(d.mechanism.type())); });
    }
    if (!alike) {
      add("dimensions [length]", Align::left, dimensions_text);
      return;
    }
    const auto names = designs().empty() ? std::vector<problems::Dimension>{}
                                         : main_dimensions(designs().front().mechanism);
    for (std::size_t i = 0; i < names.size(); ++i) {
      add(names[i].name + " [length]", Align::right,
          [i](const Design& d) { return number(main_dimensions(d.mechanism)[i].value, 6); });
    }
  }
};

}  // namespace

std::string constraints_text(std::span<const problems::ConstraintCheck> checks) {
  const auto missed = std::ranges::count(checks, false, &problems::ConstraintCheck::satisfied);
  return missed == 0 ? "all met" : fmt::format("{} missed", missed);
}

std::vector<Column> design_columns(Designs designs, const ColumnChoice& choice) {
  Columns columns(designs);
  columns.add_errors(choice.error_unit);
  for (const QuantityColumn& column : choice.quantities) {
    columns.add_if_any(std::string(column.heading), Align::right,
                       [&](const Design& d) { return quantity_text(d, column.quantity); });
  }
  columns.add_if_any("class", Align::left, class_text);
  columns.add_if_any("transmission [deg]", Align::left, transmission_text);
  columns.add_if_any("time ratio", Align::right,
                     [](const Design& d) { return number(d.metrics.time_ratio, 4); });
  for (const problems::CycleDeclaration& quantity : problems::kCycleQuantities) {
    columns.add_if_any(with_unit(quantity.heading, quantity.unit_of(choice.angular_output)),
                       Align::right,
                       [&](const Design& d) { return number(d.metrics.cycle[quantity.id], 4); });
  }
  columns.add_dimensions();
  if (choice.coupler_point) {
    columns.add_if_any("coupler point [length]", Align::left, coupler_point_text);
  }
  if (choice.places) {
    columns.add_if_any("fixed pivots [length]", Align::left, pivots_text);
    columns.add_if_any("drive at the first", Align::right, first_drive_text);
  }
  columns.add_if_any("assembly", Align::left, assembly_text);
  columns.add_if_any("input start [deg]", Align::right,
                     [](const Design& d) { return degrees_text(d.metrics.input_start); });
  columns.add_if_any("output start [deg]", Align::right,
                     [](const Design& d) { return degrees_text(d.metrics.output_start); });
  columns.add_if_any("residual", Align::right, [](const Design& d) {
    const auto& residual = d.metrics.precision_residual;
    return residual ? error_text(*residual, 1, 2) : kNoValue;
  });
  columns.add_if_any("condition", Align::right,
                     [](const Design& d) { return number(d.metrics.condition, 3); });
  columns.add("defects", Align::left, defects_text);
  columns.add_constraints();
  columns.add("origin", Align::left, origin_text);
  return std::move(columns.columns());
}

}  // namespace cognate::app
