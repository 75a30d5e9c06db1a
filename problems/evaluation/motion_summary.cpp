#include "problems/evaluation/motion_summary.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <variant>

#include "analysis/linkage/guide_bar_mobility.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/mechanism/circuit_range.hpp"
#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/output_limits.hpp"
#include "analysis/mechanism/three_pin_link.hpp"
#include "analysis/mechanism/transmission_extremes.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/output_travel.hpp"
#include "problems/evaluation/type_quantities.hpp"
#include "problems/evaluation/whole_motion.hpp"
#include "problems/mechanism/joint_names.hpp"

namespace cognate::problems {
namespace {

using Quantities = std::vector<Quantity>;

/// The time ratio by the type's dimensions, where there is a formula; from the motion else, and at
/// change points, where the formula's limits may be passed.
struct TimeRatio {
  const AnalysisProblem& problem;
  const Travel& travel;
  const Deadline& deadline;

  std::optional<double> operator()(const FourBar& linkage) const {
    return is_change_point(lengths(linkage)) ? of_motion() : time_ratio(lengths(linkage));
  }
  template <class Type>
  std::optional<double> operator()(const Type& described) const {
    const auto& dimensions = dimensions_of_formulas(described);
    if constexpr (requires { time_ratio(dimensions); }) {
      if (!is_change_point(dimensions)) return time_ratio(dimensions);
    }
    return of_motion();
  }

  std::optional<double> of_motion() const {
    const auto& mechanism = problem.mechanism.mechanism;
    const AssemblyRanges assembly_ranges = whole_motion(problem, deadline);
    const auto range = output_range(mechanism, assembly_ranges, travel);
    return range ? time_ratio(mechanism, assembly_ranges, *range) : std::nullopt;
  }
};

/// Goes through one motion and collects what it says.
class Summary {
 public:
  Summary(const AnalysisProblem& problem, const AssemblyRanges& assembly_ranges,
          const Deadline& deadline)
      : problem_(problem),
        deadline_(deadline),
        mechanism_(problem.mechanism.mechanism),
        assembly_ranges_(assembly_ranges),
        driven_(assembly_ranges),
        travel_(output_travel(problem.mechanism)),
        motion_(mechanism_, assembly_ranges) {
    driven_.runs = {range_driven()};
    summary_.ranges = static_cast<int>(assembly_ranges.runs.size());
    summary_.from = driven_.runs.front().from;
    summary_.to = driven_.runs.front().to;
  }

  MotionSummary collect() {
    add_special_positions();
    add_assemblies();
    add_transmission();
    add_output();
    std::ranges::stable_sort(summary_.landmarks, [this](const Landmark& a, const Landmark& b) {
      return assembly_ranges_.start <= assembly_ranges_.end ? a.drive < b.drive : a.drive > b.drive;
    });
    return std::move(summary_);
  }

 private:
  void add_landmark(std::string kind, const std::string& of, double drive) {
    const bool found = motion_.move_to(drive);
    const double value =
        found ? travelled<0>(travel_, motion_.bodies()) : std::numeric_limits<double>::quiet_NaN();
    summary_.landmarks.push_back({std::move(kind), of, drive, value});
  }

  void add_special_positions() {
    const auto names = dyad_names(problem_.mechanism);
    for (const SpecialPosition& point : assembly_ranges_.points) {
      add_landmark(kind_of(point), names[static_cast<std::size_t>(point.dyad)], point.drive);
    }
  }

  /// In how many ways links with three pins could stand where the motion begins.
  void add_assemblies() {
    if (!has_groups(mechanism_) || !motion_.move_to(assembly_ranges_.start)) return;
    std::vector<Placement> bodies;
    for (const auto& body : motion_.bodies()) bodies.push_back({body.origin[0], body.direction});
    for (std::size_t i = 0; i < mechanism_.dyads.size(); ++i) {
      const auto* group = std::get_if<Group>(&mechanism_.dyads[i]);
      const int first = first_body(mechanism_, static_cast<int>(i));
      const auto link = group ? as_three_pin_link(*group, first, bodies) : std::nullopt;
      if (link) add_assemblies(*link, bodies[static_cast<std::size_t>(link->body)]);
    }
  }

  /// Their number, which of them it is, and the link's angle in each.
  void add_assemblies(const ThreePinLink& link, const Placement& here) {
    const std::string& name = problem_.mechanism.bodies[static_cast<std::size_t>(link.body)];
    const auto all = assemblies(link);
    if (all.empty()) return;
    const auto distance = [&](const Placement& at) {
      double sum = 0;
      for (const Vec2d& pin : link.pins) {
        sum += norm(at.origin + at.direction * pin - here.origin - here.direction * pin);
      }
      return sum;
    };
    const auto own = std::ranges::min_element(all, {}, distance) - all.begin();
    const auto add = [&](const std::string& what, double value) {
      summary_.quantities.push_back({what + "." + name, value});
    };
    add("assemblies", static_cast<double>(all.size()));
    add("assembly", static_cast<double>(own + 1));
    for (std::size_t i = 0; i < all.size(); ++i) {
      add(fmt::format("assembly_{}_deg", i + 1), kDegreesInRadian * angle_of(all[i].direction));
    }
  }

  static std::string kind_of(const SpecialPosition& point) {
    switch (point.kind) {
      case SpecialPositionKind::dead_point:
        return "dead point";
      case SpecialPositionKind::change_point:
        return "change point";
      case SpecialPositionKind::undetermined:
        return "undetermined change point";
      case SpecialPositionKind::parallel_guides:
        return "end of range";
    }
    return "";
  }

  void add_transmission() {
    const auto names = dyad_names(problem_.mechanism);
    TransmissionAngles all{kPi, 0, kPi};
    std::optional<double> pressure;
    for (std::size_t i = 0; i < mechanism_.dyads.size(); ++i) {
      if (deadline_.reached()) return;
      if (is_of_group(mechanism_.dyads[i])) continue;  // which has no such angle
      const auto angles = transmission_extremes(mechanism_, assembly_ranges_, static_cast<int>(i));
      if (!angles) return;
      all = {std::min(all.min, angles->least.angle), std::max(all.max, angles->greatest.angle),
             std::min(all.acute_min, angles->acute_least())};
      if (!std::holds_alternative<Rrr<double>>(mechanism_.dyads[i])) {
        pressure = std::max(pressure.value_or(0), angles->greatest_pressure());
      }
      constexpr double kConstant = 1e-9;  // radians
      if (angles->greatest.angle - angles->least.angle < kConstant) continue;
      add_landmark("least transmission angle", names[i], angles->least.drive);
      add_landmark("greatest transmission angle", names[i], angles->greatest.drive);
    }
    if (std::ranges::all_of(mechanism_.dyads, is_of_group<double>)) return;
    if (problem_.mechanism.four_bar()) all = by_diagonal(*problem_.mechanism.four_bar());
    summary_.transmission = all;
    if (pressure) add("pressure_angle_max_deg", kDegreesInRadian * *pressure);
  }

  /// The angles of a four-bar by its diagonal, over all assembly ranges.
  TransmissionAngles by_diagonal(const FourBar& linkage) const {
    const auto links = lengths(linkage);
    const double frame = frame_angle(linkage);
    TransmissionAngles all{kPi, 0, kPi};
    for (const AssemblyRange& run : assembly_ranges_.runs) {
      const bool whole = run.to - run.from >= kTurn && crank_rotates(links);
      const auto part = whole ? transmission_angles(links)
                              : transmission_angles(links, {run.from - frame, run.to - frame});
      all = {std::min(all.min, part.min), std::max(all.max, part.max),
             std::min(all.acute_min, part.acute_min)};
    }
    return all;
  }

  void add_output() {
    const auto& name = problem_.mechanism.bodies[static_cast<std::size_t>(travel_.body)];
    const auto range = output_range(mechanism_, assembly_ranges_, travel_);
    if (!range) return;
    summary_.quantities.push_back({"output", name});
    for (const OutputValue& limit : range->limits)
      add_landmark("limit position", name, limit.drive);
    add_strokes(*range);
    const auto ratio =
        std::visit(TimeRatio{problem_, travel_, deadline_}, problem_.mechanism.description);
    if (ratio && std::isfinite(*ratio)) summary_.time_ratio = ratio;
  }

  /// Parts of the scale of the drive: change points closer than this to the start are at it.
  static constexpr double kSameStart = 2e-7;

  /// The first assembly range. Where a crank begins within it and comes back a
  /// turn later in the same assemblies, the way in which it came back is a part of it too.
  AssemblyRange range_driven() const {
    const double sense = assembly_ranges_.start <= assembly_ranges_.end ? 1 : -1;
    const AssemblyRange& first =
        sense > 0 ? assembly_ranges_.runs.front() : assembly_ranges_.runs.back();
    const bool turns = !driven_by_length(mechanism_.drive);
    const bool from_start = (sense > 0 ? first.from_dyad : first.to_dyad) < 0;
    if (!turns || !from_start ||
        sense * (assembly_ranges_.end - assembly_ranges_.start) < kFullTurn)
      return first;
    const double shift = sense * kTurn, back = assembly_ranges_.start + shift;
    const AssemblyRange* again = assembly_ranges_.range_at(back);
    if (again == nullptr || again == &first) return first;
    // Before a change point at the start itself, through which the motion goes on smoothly.
    const double near = kSameStart * assembly_ranges_.scale;
    const double before = assembly_ranges_.start - sense * near;
    if (sides_at(*again, before + shift) != sides_at(first, before)) return first;
    AssemblyRange joined = first;
    (sense > 0 ? joined.from_dyad : joined.to_dyad) = sense > 0 ? again->from_dyad : again->to_dyad;
    if (sense > 0) {
      set_end(joined, joined.from, again->from - shift, 1);
    } else {
      set_end(joined, joined.to, again->to - shift, -1);
    }
    for (Change change : again->changes) {
      change.drive -= shift;
      if (sense * (before - change.drive) > 0) joined.changes.push_back(change);
    }
    std::ranges::stable_sort(joined.changes, {}, &Change::drive);
    return joined;
  }

  /// Sets an end of `run`, which lies on the side `inwards` of it, to the dead point `place`, moved
  /// by a turn: and on, where rounding took it out of what can be assembled, to where it can.
  void set_end(AssemblyRange& run, double& end, double place, int inwards) const {
    constexpr int kMostRoundings = 16;
    constexpr double kRounding = kTurn * std::numeric_limits<double>::epsilon() / 4;
    AssemblyRanges one = assembly_ranges_;
    for (int i = 0; i < kMostRoundings; ++i) {
      end = place + inwards * i * kRounding;
      one.runs = {run};
      if (FollowedMotion<0>(mechanism_, one).move_to(end)) return;
    }
    end = place;
  }

  /// The output's stroke or swing in the range driven and on the whole circuit; none where the
  /// range is a whole turn in which the output turns too, or where the stroke has no end.
  void add_strokes(const OutputRange& all) {
    const bool is_one = assembly_ranges_.runs.size() == 1;
    const auto own = is_one ? all : output_range(mechanism_, driven_, travel_);
    if (!own || goes_to_infinity()) return;
    const double unit = travel_.slides ? 1 : kDegreesInRadian;
    if (!travel_.slides && own->stroke() >= kFullTurn) return;
    add(travel_.slides ? "output_stroke" : "output_swing_deg", unit * own->stroke());
    if (const auto stroke = is_circuit() ? std::optional(own->stroke()) : circuit_stroke()) {
      add(travel_.slides ? "circuit_stroke" : "circuit_swing_deg", unit * *stroke);
    }
  }

  /// Whether the range driven is the whole circuit: a turn that meets neither dead nor change
  /// point.
  bool is_circuit() const {
    const bool turns = !driven_by_length(mechanism_.drive);
    const double driven = std::abs(assembly_ranges_.end - assembly_ranges_.start);
    const bool is_whole = turns && driven >= kFullTurn && assembly_ranges_.runs.size() == 1 &&
                          assembly_ranges_.points.empty();
    if (!is_whole) return false;
    const AssemblyRange& run = assembly_ranges_.runs.front();
    return groups_stand_alike(mechanism_, run, run.from, run, run.from + kTurn);
  }

  std::optional<double> circuit_stroke() const {
    const auto stop = [this] { return deadline_.reached(); };
    const auto circuit = circuit_range(mechanism_, driven_.runs.front(), travel_, stop);
    return circuit ? std::optional(circuit->stroke) : std::nullopt;
  }

  /// Whether a range that ends by this dyad ends because its guides are parallel.
  bool has_guides(int dyad) const {
    if (dyad < 0) return false;
    const auto& group = mechanism_.dyads[static_cast<std::size_t>(dyad)];
    return std::holds_alternative<Prp<double>>(group) || std::holds_alternative<Rpp<double>>(group);
  }

  /// Whether the output slides off towards an end of the range driven at which guides are parallel;
  /// nothing else there makes it travel farther by a factor like this.
  bool goes_to_infinity() {
    constexpr double kNear = 1e-3, kFactor = 1e4;
    if (!travel_.slides) return false;
    const AssemblyRange& run = driven_.runs.front();
    const double middle = std::midpoint(run.from, run.to), step = kNear * (run.to - run.from);
    FollowedMotion<0> motion(mechanism_, driven_);
    const auto value = [&](double drive) {
      motion.move_to(drive);
      return travelled<0>(travel_, motion.bodies());
    };
    const auto is_beyond = [&](double end, double near) {
      return std::abs(value(end) - value(middle)) > kFactor * std::abs(value(near) - value(middle));
    };
    const bool is_endless = (has_guides(run.from_dyad) && is_beyond(run.from, run.from + step)) ||
                            (has_guides(run.to_dyad) && is_beyond(run.to, run.to - step));
    if (is_endless) {
      summary_.endless = problem_.mechanism.bodies[static_cast<std::size_t>(travel_.body)];
    }
    return is_endless;
  }

  static constexpr double kFullTurn = kTurn * (1 - 1e-12);

  void add(const char* name, double value) { summary_.quantities.push_back({name, value}); }

  const AnalysisProblem& problem_;
  const Deadline& deadline_;
  const Mechanism<double>& mechanism_;
  const AssemblyRanges& assembly_ranges_;
  AssemblyRanges driven_;  ///< the first assembly range
  Travel travel_;
  FollowedMotion<0> motion_;
  MotionSummary summary_;
};

}  // namespace

MotionSummary summarise(const AnalysisProblem& problem, const AssemblyRanges& assembly_ranges,
                        const Deadline& deadline) {
  if (assembly_ranges.runs.empty()) return {};
  return Summary(problem, assembly_ranges, deadline).collect();
}

std::vector<Quantity> quantities_of(const MotionSummary& summary) {
  std::vector<Quantity> all;
  if (const auto& angles = summary.transmission) {
    all = {{"transmission_angle_deg.min", kDegreesInRadian * angles->min},
           {"transmission_angle_deg.max", kDegreesInRadian * angles->max},
           {"transmission_angle_deg.acute_min", kDegreesInRadian * angles->acute_min}};
  }
  std::ranges::copy(summary.quantities, std::back_inserter(all));
  if (summary.time_ratio) all.push_back({"time_ratio", *summary.time_ratio});
  return all;
}

}  // namespace cognate::problems
