#include "problems/analysis/motion_facts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cognate::problems {
namespace {

const Column& column(const Sweep& sweep, ColumnIndex index) {
  return sweep.plan.columns[static_cast<std::size_t>(index)];
}

/// "_at_deg" or "_at": how the name of a drive value ends.
std::string at_suffix(const AnalysisProblem& problem) {
  const bool slides =
      std::holds_alternative<DrivingSlider<double>>(problem.mechanism.mechanism.drive);
  return slides ? "_at" : "_at_deg";
}

/// |F| of a turning joint, |N| of a slide, at each row.
std::vector<double> magnitudes(const Sweep& sweep, const JointColumns& joint) {
  std::vector<double> values = column(sweep, joint.first).values;
  if (joint.slides) {
    std::ranges::transform(values, values.begin(), [](double n) { return std::abs(n); });
    return values;
  }
  const auto& y = column(sweep, joint.first + 1).values;
  std::ranges::transform(values, y, values.begin(),
                         [](double fx, double fy) { return std::hypot(fx, fy); });
  return values;
}

/// The column's name without what tells its component: "B_on_coupler".
std::string reaction_name(const Sweep& sweep, const JointColumns& joint) {
  const std::string& name = column(sweep, joint.first).name;
  return name.substr(0, name.rfind(joint.slides ? "_N" : "_Fx_N"));
}

}  // namespace

std::optional<Extremes> extremes(std::span<const double> values, std::span<const double> drive) {
  std::optional<Extremes> found;
  for (std::size_t row = 0; row < values.size(); ++row) {
    const double value = values[row];
    if (!std::isfinite(value)) continue;
    if (!found) found = Extremes{value, drive[row], value, drive[row]};
    if (value < found->min) {
      found->min = value;
      found->min_at = drive[row];
    }
    if (value > found->max) {
      found->max = value;
      found->max_at = drive[row];
    }
  }
  return found;
}

std::vector<Fact> check_facts(const Sweep& sweep) {
  double gap = 0, extent = 0, power = 0, scale = 0;
  for (const RowState& row : sweep.rows) {
    if (row.open_dyad != kNone) continue;
    gap = std::max(gap, row.residual);
    extent = std::max(extent, row.extent);
    power = std::max(power, row.power.residual);
    scale = std::max(scale, row.power.scale);
  }
  std::vector<Fact> facts;
  if (extent > 0) facts.push_back({"closure_residual", gap / extent});
  if (scale > 0) facts.push_back({"power_residual", power / scale});
  return facts;
}

std::vector<Fact> force_facts(const AnalysisProblem& problem, const Sweep& sweep) {
  const auto& drive = column(sweep, 0).values;
  const std::string at = at_suffix(problem);
  std::vector<Fact> facts;
  if (sweep.plan.drive_force != kNone) {
    const Column& torque = column(sweep, sweep.plan.drive_force);
    if (const auto found = extremes(torque.values, drive)) {
      facts.push_back({torque.name + ".min", found->min});
      facts.push_back({torque.name + ".min" + at, found->min_at});
      facts.push_back({torque.name + ".max", found->max});
      facts.push_back({torque.name + ".max" + at, found->max_at});
    }
  }
  for (const auto& joint : sweep.plan.joints) {
    const auto found = extremes(magnitudes(sweep, joint), drive);
    if (!found) continue;
    const std::string name = reaction_name(sweep, joint);
    facts.push_back({"reaction_max_N." + name, found->max});
    facts.push_back({fmt::format("reaction_max{}.{}", at, name), found->max_at});
  }
  return facts;
}

}  // namespace cognate::problems
