/// One gear as its rack cuts it: quantities, a table of its flank, and what makes it impossible.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/gear/tooth_outline.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/gear/notes.hpp"
#include "problems/gear/quantities.hpp"
#include "problems/gear/result.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {
namespace {

using gear::OutlinePart;
using gear::SpurGear;

/// How near the fillet's chords are to it, in modules.
constexpr double kFilletTolerance = 1e-7;

/// A row of the table.
struct FlankPoint {
  Vec2d at;
  OutlinePart part;
};

/// The fillet's points, from the root circle up, `count` equal steps along it.
void add_fillet(const SpurGear& section, int count, std::vector<FlankPoint>& rows) {
  const auto outline = gear::tooth_half(section, kFilletTolerance * section.module);
  std::vector<Vec2d> fillet;
  for (std::size_t i = 1; i < outline.size(); ++i) {  // a point ends the piece that it belongs to
    if (outline[i].part != OutlinePart::fillet) continue;
    if (fillet.empty()) fillet.push_back(outline[i - 1].at);
    fillet.push_back(outline[i].at);
  }
  if (fillet.size() < 2) return;
  std::vector<double> along = {0};
  for (std::size_t i = 1; i < fillet.size(); ++i) {
    along.push_back(along.back() +
                    std::hypot(fillet[i].x - fillet[i - 1].x, fillet[i].y - fillet[i - 1].y));
  }
  for (int k = 0; k <= count; ++k) {
    const double wanted = along.back() * k / count;
    const auto after = std::ranges::lower_bound(along.begin() + 1, along.end() - 1, wanted);
    const auto i = static_cast<std::size_t>(after - along.begin());
    const double step = along[i] - along[i - 1];
    const double share = step > 0 ? (wanted - along[i - 1]) / step : 0;
    rows.push_back({fillet[i - 1] + share * (fillet[i] - fillet[i - 1]), OutlinePart::fillet});
  }
}

/// The involute's, `count` equal steps of the radius, the tooth's middle on the y axis.
void add_involute(const SpurGear& section, int count, std::vector<FlankPoint>& rows) {
  const double from = gear::form_radius(section);
  const double to = gear::flank_end_radius(section);
  for (int k = 0; k <= count; ++k) {
    const double radius = from + (to - from) * k / count;
    const double half = 0.5 * gear::tooth_thickness(section, radius) / radius;
    rows.push_back({{-radius * std::sin(half), radius * std::cos(half)}, OutlinePart::involute});
  }
}

class FlankTable {
 public:
  FlankTable(const SpurGear& section, const std::vector<FlankPoint>& rows)
      : section_(section), rows_(rows) {}

  std::vector<Column> columns() const {
    const double base = gear::base_radius(section_);
    const auto radius = [](const FlankPoint& row) { return std::hypot(row.at.x, row.at.y); };
    const auto involute = [](const FlankPoint& row) { return row.part == OutlinePart::involute; };
    return {column("radius", "length", radius),
            column("x", "length", [](const FlankPoint& row) { return row.at.x; }),
            column("y", "length", [](const FlankPoint& row) { return row.at.y; }),
            column("thickness", "length",
                   [&](const FlankPoint& row) {
                     return 2 * radius(row) * std::atan2(-row.at.x, row.at.y);
                   }),
            column("pressure_angle_deg", "deg",
                   [&](const FlankPoint& row) {
                     if (!involute(row)) return double(NAN);
                     return degrees(gear::pressure_angle(section_, std::max(base, radius(row))));
                   }),
            column("is_involute", "",
                   [&](const FlankPoint& row) { return involute(row) ? 1.0 : 0.0; })};
  }

 private:
  template <class Cell>
  Column column(std::string name, std::string unit, Cell cell) const {
    Column made{std::move(name), "flank", "gear", std::move(unit), {}};
    for (const FlankPoint& row : rows_) made.values.push_back(cell(row));
    return made;
  }

  const SpurGear& section_;
  const std::vector<FlankPoint>& rows_;
};

}  // namespace

GearResult analyse(const GearProblem& given, const Run& run) {
  const auto valid = KindTraits<GearProblem>::checked(given);
  if (!valid) return refused<GearResult>(valid.error());
  const GearProblem& problem = *valid;
  const Deadline deadline(run);
  GearResult result;
  const SpurGear section = gear::transverse(problem.gear);
  result.metrics = gear_quantities(problem.gear, "", problem.span_teeth);
  if (problem.gear.helix != 0 && problem.gear.face_width > 0) {
    result.metrics.push_back({"overlap_ratio", gear::overlap_ratio(problem.gear)});
  }
  std::vector<FlankPoint> rows;
  if (gear::tooth_fault(section) == gear::ToothFault::none) {
    add_fillet(section, problem.points, rows);
    add_involute(section, problem.points, rows);
  }
  result.columns = FlankTable(section, rows).columns();
  result.notes = gear_notes(problem.gear, "The gear");
  result.status = result.notes.empty() ? Status::solved : Status::infeasible;
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
