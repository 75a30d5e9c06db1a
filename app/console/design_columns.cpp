#include "app/console/design_columns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <variant>

#include "app/console/design_dimensions.hpp"
#include "app/console/messages.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using problems::Design;
using problems::Metrics;
using Designs = std::span<const Design>;

constexpr const char* kNone = "–";

std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : kNone;
}

std::string number(const std::optional<double>& value, int digits) {
  return value ? number(*value, digits) : kNone;
}

std::string class_text(const Design& design) {
  const Metrics& metrics = design.metrics;
  std::string name(metrics.mobility ? problems::to_string(*metrics.mobility) : "");
  for (const auto& fact : metrics.facts) {
    const auto* text = std::get_if<std::string>(&fact.value);
    if (name.empty() && fact.name == "class" && text) name = printable(*text);
  }
  if (name.empty()) return kNone;
  if (!metrics.change_point) return name;
  const auto kind = std::ranges::find(metrics.facts, "change_point_kind", &problems::Fact::name);
  const auto* text = kind == metrics.facts.end() ? nullptr : std::get_if<std::string>(&kind->value);
  return name + (text && *text != "single" ? " (" + printable(*text) + ")" : " (change point)");
}

/// A design of a type without transmission angle has zeros there.
std::string transmission_text(const Design& design) {
  const Metrics& metrics = design.metrics;
  if (!(metrics.transmission_max > 0)) return kNone;
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

std::string constraints_text(const Design& design) {
  const auto missed =
      std::ranges::count(design.constraints, false, &problems::ConstraintCheck::satisfied);
  return missed == 0 ? "all met" : fmt::format("{} missed", missed);
}

std::string origin_text(const Design& design) {
  std::string text = printable(design.origin);
  if (design.cognate_of) text += fmt::format(", cognate of {}", *design.cognate_of + 1);
  if (design.mirror_of) text += fmt::format(", mirror image of {}", *design.mirror_of + 1);
  return text;
}

std::string dimensions_text(const Design& design) {
  std::string text;
  for (const auto& [name, value] : dimensions(design.mechanism)) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {}", name, number(value, 6));
  }
  return text.empty() ? kNone : text;
}

std::string coupler_point_text(const Design& design) {
  const auto& mechanism = design.mechanism;
  if (mechanism.four_bar && mechanism.four_bar->coupler_point) {
    const Vec2d& p = *mechanism.four_bar->coupler_point;
    return fmt::format("[{}, {}]", number(p.x, 6), number(p.y, 6));
  }
  if (mechanism.extra_points.empty()) return kNone;
  const Vec2d& p = mechanism.extra_points.front().at;
  return fmt::format("[{}, {}]", number(p.x, 6), number(p.y, 6));
}

std::string fact_text(const Design& design, std::string_view name) {
  const auto fact = std::ranges::find(design.metrics.facts, name, &problems::Fact::name);
  if (fact == design.metrics.facts.end()) return kNone;
  if (const auto* text = std::get_if<std::string>(&fact->value)) return printable(*text);
  const auto* value = std::get_if<double>(&fact->value);
  return value ? number(*value, 5) : kNone;
}

/// Collects columns; each has one cell for each design.
class Columns {
 public:
  explicit Columns(Designs designs) : designs_(designs) {}

  template <class Cell>
  void add(std::string heading, Align align, Cell cell) {
    Column made{std::move(heading), align, {}};
    std::ranges::transform(designs_, std::back_inserter(made.cells), cell);
    columns_.push_back(std::move(made));
  }

  /// The same, unless no design has anything there.
  template <class Cell>
  void add_if_any(std::string heading, Align align, Cell cell) {
    add(std::move(heading), align, cell);
    const auto& cells = columns_.back().cells;
    if (std::ranges::all_of(cells, [](const auto& text) { return text == kNone; })) {
      columns_.pop_back();
    }
  }

  void add_numbers() {
    Column made{"#", Align::right, {}};
    for (std::size_t i = 1; i <= designs_.size(); ++i) made.cells.push_back(std::to_string(i));
    columns_.push_back(std::move(made));
  }

  void add_errors(std::string_view unit) {
    if (unit.empty()) return;
    const double scale = unit == "deg" ? problems::degrees(1) : 1;
    const auto add_error = [&](std::string_view name, double problems::TargetError::*part) {
      add(fmt::format("{} [{}]", name, unit), Align::right,
          [=](const Design& d) { return number(scale * (d.error.*part), 4); });
    };
    add_error("rms", &problems::TargetError::rms);
    add_error("max", &problems::TargetError::max);
  }

  void add_dimensions() {
    const auto type =
        designs_.empty() ? problems::MechanismType::four_bar : designs_.front().mechanism.type;
    const bool alike =
        type != problems::MechanismType::chain &&
        std::ranges::all_of(designs_, [&](const Design& d) { return d.mechanism.type == type; });
    if (!alike || type != problems::MechanismType::four_bar) {
      add("mechanism", Align::left,
          [](const Design& d) { return std::string(problems::to_string(d.mechanism.type)); });
    }
    if (!alike) {
      add("dimensions [length]", Align::left, dimensions_text);
      return;
    }
    const auto names =
        designs_.empty() ? std::vector<Dimension>{} : dimensions(designs_.front().mechanism);
    for (std::size_t i = 0; i < names.size(); ++i) {
      add(names[i].name + " [length]", Align::right,
          [i](const Design& d) { return number(dimensions(d.mechanism)[i].value, 6); });
    }
  }

  /// Lengths are in metres where powers, torques and inertias follow from them.
  void name_metres() {
    const auto has_unit = [](const Design& d) {
      return d.metrics.torque_ripple || d.metrics.flywheel_inertia || d.metrics.motor_power;
    };
    if (std::ranges::none_of(designs_, has_unit)) return;
    for (Column& column : columns_) {
      const std::string_view unit = "[length";
      const auto at = column.heading.find(unit);
      if (at != std::string::npos) column.heading.replace(at, unit.size(), "[m");
    }
  }

  std::vector<Column> take() {
    name_metres();
    return std::move(columns_);
  }

 private:
  Designs designs_;
  std::vector<Column> columns_;
};

}  // namespace

std::vector<Column> design_columns(Designs designs, const ColumnChoice& choice) {
  Columns columns(designs);
  columns.add_numbers();
  columns.add_errors(choice.error_unit);
  for (const FactColumn& column : choice.facts) {
    columns.add_if_any(std::string(column.heading), Align::right,
                       [&](const Design& d) { return fact_text(d, column.fact); });
  }
  columns.add_if_any("class", Align::left, class_text);
  columns.add_if_any("transmission [deg]", Align::left, transmission_text);
  columns.add_if_any("time ratio", Align::right,
                     [](const Design& d) { return number(d.metrics.time_ratio, 4); });
  columns.add_if_any(fmt::format("peak acceleration [{}]", choice.acceleration_unit), Align::right,
                     [](const Design& d) { return number(d.metrics.peak_acceleration, 4); });
  columns.add_if_any("torque ripple [N m]", Align::right,
                     [](const Design& d) { return number(d.metrics.torque_ripple, 4); });
  columns.add_if_any("speed fluctuation", Align::right,
                     [](const Design& d) { return number(d.metrics.speed_fluctuation, 4); });
  columns.add_if_any("flywheel [kg m2]", Align::right,
                     [](const Design& d) { return number(d.metrics.flywheel_inertia, 4); });
  columns.add_if_any("motor power [W]", Align::right,
                     [](const Design& d) { return number(d.metrics.motor_power, 4); });
  columns.add_dimensions();
  if (choice.coupler_point) {
    columns.add_if_any("coupler point [length]", Align::left, coupler_point_text);
  }
  columns.add_if_any("residual", Align::right,
                     [](const Design& d) { return number(d.metrics.precision_residual, 2); });
  columns.add_if_any("condition", Align::right,
                     [](const Design& d) { return number(d.metrics.condition, 3); });
  columns.add("defects", Align::left, defects_text);
  columns.add("constraints", Align::left, constraints_text);
  columns.add("origin", Align::left, origin_text);
  return columns.take();
}

}  // namespace cognate::app
