#include "problems/evaluation/motion_quantities.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

const Column& column(const Sweep& sweep, ColumnIndex index) {
  return sweep.plan.columns[static_cast<std::size_t>(index)];
}

bool slides(const AnalysisProblem& problem) {
  return driven_by_length(problem.mechanism.mechanism.drive);
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

/// The column's name without its component: "B_on_coupler".
std::string reaction_name(const Sweep& sweep, const JointColumns& joint) {
  const std::string& name = column(sweep, joint.first).name;
  return name.substr(0, name.rfind(joint.slides ? "_N" : "_Fx_N"));
}

/// Puts the extremes of forces into words.
class ForceQuantities {
 public:
  ForceQuantities(const AnalysisProblem& problem, const Sweep& sweep,
                  const std::optional<ForceExtremes>& refined)
      : problem_(problem),
        sweep_(sweep),
        refined_(refined),
        at_(slides(problem) ? "_at" : "_at_deg"),
        unit_(slides(problem) ? 1 : 180 / kPi) {}

  ForceSummary collect() {
    add_drive();
    for (const auto& joint : sweep_.plan.joints) add_reaction(joint);
    if (!refined_ && !summary_.quantities.empty()) {
      summary_.notes.emplace_back(
          "the time did not suffice to look between the rows: extremes of torque and reactions are "
          "those of the table's rows");
    }
    return std::move(summary_);
  }

 private:
  void add_drive() {
    if (sweep_.plan.drive_force == kNone) return;
    const Column& force = column(sweep_, sweep_.plan.drive_force);
    const auto rows = extremes(force.values, column(sweep_, 0).values);
    const char* name = slides(problem_) ? "driving force" : "driving torque";
    const ForceBound least = refined_ ? refined_->least_drive : ForceBound{};
    const ForceBound greatest = refined_ ? refined_->greatest_drive : ForceBound{};
    add(force.name + ".min", "", least, least_of(rows), -1);
    add(force.name + ".max", "", greatest, greatest_of(rows), 1);
    add_magnitude(force.name, rows, least, greatest);
    note(fmt::format("the {} has no least value: it falls without bound near the dead point", name),
         least);
    note(fmt::format("the {} has no greatest value: it grows without bound near the dead point",
                     name),
         greatest);
  }

  /// The greatest of either sign and, where the motion was looked at between the rows, the root
  /// mean square: what a motor is chosen by.
  void add_magnitude(const std::string& name, const std::optional<Extremes>& rows,
                     const ForceBound& least, const ForceBound& greatest) {
    ForceBound most;
    most.unbounded_at = least.unbounded_at;
    most.unbounded_at.insert(most.unbounded_at.end(), greatest.unbounded_at.begin(),
                             greatest.unbounded_at.end());
    std::ranges::sort(most.unbounded_at);
    OfRows extreme;
    if (!most.is_unbounded()) {
      extreme = better(greatest, greatest_of(rows), 1);
      const OfRows low = better(least, least_of(rows), -1);
      if (low && (!extreme || -low->value > extreme->value)) extreme = low;
      if (extreme) extreme->value = std::abs(extreme->value);
    }
    add(name + ".abs_max", "", most, extreme, 1);
    if (refined_ && refined_->drive_rms) {
      summary_.quantities.push_back({name + ".rms", *refined_->drive_rms});
    }
  }

  void add_reaction(const JointColumns& joint) {
    const auto rows = extremes(magnitudes(sweep_, joint), column(sweep_, 0).values);
    const std::string name = reaction_name(sweep_, joint);
    const ForceBound most =
        refined_ ? refined_->reactions[static_cast<std::size_t>(joint.joint)] : ForceBound{};
    add("reaction_max", "." + name, most, greatest_of(rows), 1, "_N");
    note(fmt::format("the reaction {} has no greatest value: it grows without bound near the dead "
                     "or change point",
                     name),
         most);
  }

  using OfRows = std::optional<ForceAt>;  ///< its place as the first column has it

  static OfRows least_of(const std::optional<Extremes>& rows) {
    return rows ? OfRows({rows->min, rows->min_at}) : std::nullopt;
  }
  static OfRows greatest_of(const std::optional<Extremes>& rows) {
    return rows ? OfRows({rows->max, rows->max_at}) : std::nullopt;
  }

  /// The extreme, with its place, under `name` + `unit` + `of`; or the place near which there is
  /// none.
  void add(const std::string& name, const std::string& of, const ForceBound& bound,
           const OfRows& of_rows, double sense, const char* unit = "") {
    if (bound.is_unbounded()) {
      const double first = unit_ * bound.unbounded_at.front();
      return summary_.quantities.push_back({fmt::format("{}_unbounded{}{}", name, at_, of), first});
    }
    const OfRows extreme = better(bound, of_rows, sense);
    if (!extreme) return;
    summary_.quantities.push_back({name + unit + of, extreme->value});
    summary_.quantities.push_back({name + at_ + of, extreme->drive});
  }

  /// The extreme between rows, or that of the rows where both are equal but for rounding: their
  /// drive values are round numbers.
  OfRows better(const ForceBound& bound, const OfRows& of_rows, double sense) const {
    constexpr double kRounding = 1e-12;
    if (!bound.extreme) return of_rows;
    const ForceAt refined{bound.extreme->value, unit_ * bound.extreme->drive};
    if (!of_rows) return refined;
    const double gain = sense * (refined.value - of_rows->value);
    return gain > kRounding * std::abs(of_rows->value) ? OfRows(refined) : of_rows;
  }

  /// That something goes beyond every bound, and where.
  void note(const std::string& what, const ForceBound& bound) {
    if (!bound.is_unbounded()) return;
    constexpr std::size_t kMostPlaces = 4;
    std::string places;
    for (std::size_t i = 0; i < std::min(bound.unbounded_at.size(), kMostPlaces); ++i) {
      places += fmt::format("{}{:.6g}{}", i > 0 ? ", " : "", unit_ * bound.unbounded_at[i] + 0.0,
                            slides(problem_) ? "" : "°");
    }
    if (bound.unbounded_at.size() > kMostPlaces) places += ", …";
    summary_.notes.push_back(fmt::format("{} at {}", what, places));
  }

  const AnalysisProblem& problem_;
  const Sweep& sweep_;
  const std::optional<ForceExtremes>& refined_;
  std::string at_;
  double unit_;
  ForceSummary summary_;
};

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

std::vector<Quantity> check_quantities(const Sweep& sweep) {
  double gap = 0, extent = 0, power = 0, scale = 0;
  for (const RowState& row : sweep.rows) {
    if (row.open_dyad != kNone) continue;
    gap = std::max(gap, row.residual);
    extent = std::max(extent, row.extent);
    power = std::max(power, row.power.residual);
    scale = std::max(scale, row.power.scale);
  }
  std::vector<Quantity> quantities;
  if (extent > 0) quantities.push_back({"closure_residual", gap / extent});
  if (scale > 0) quantities.push_back({"power_residual", power / scale});
  return quantities;
}

ForceSummary force_quantities(const AnalysisProblem& problem, const Sweep& sweep,
                              const std::optional<ForceExtremes>& refined) {
  return ForceQuantities(problem, sweep, refined).collect();
}

}  // namespace cognate::problems
