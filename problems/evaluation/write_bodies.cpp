/// Writes masses and loads of an analysis, and checks that its mechanism matches its description.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "problems/evaluation/write.hpp"

namespace cognate::problems::reading {
namespace {

/// What rounding leaves of 0 is none of the numbers that a file takes.
Vec2d without_rounding(const Vec2d& v) {
  constexpr double kLeast = 1e-30;
  return {std::abs(v.x) < kLeast ? 0 : v.x, std::abs(v.y) < kLeast ? 0 : v.y};
}

/// The structure and the numbers of a mechanism, each in a row, to compare it by.
struct Digest {
  std::vector<int> structure;
  std::vector<double> numbers;

  explicit Digest(const NamedMechanism& mechanism) {
    structure = {static_cast<int>(mechanism.type()), mechanism.output,
                 static_cast<int>(mechanism.mechanism.drive.index())};
    std::visit(*this, mechanism.mechanism.drive);
    for (const auto& dyad : mechanism.mechanism.dyads) {
      structure.push_back(static_cast<int>(dyad.index()));
      std::visit(*this, dyad);
    }
  }

  void operator()(const Crank<double>& crank) {
    add(crank.pivot);
    add(crank.length);
  }
  void operator()(const DrivingSlider<double>& slider) { add(slider.guide); }
  void operator()(const FloatingLink<double>& link) {
    add(link.first);
    add(link.second);
    add(link.length);
  }
  void operator()(const DrivingRod<double>&) {}
  void operator()(const Rrr<double>& dyad) {
    add(dyad.first);
    add(dyad.second);
    add(dyad.first_length);
    add(dyad.second_length);
    add(dyad.assembly);
  }
  void operator()(const Rrp<double>& dyad) {
    add(dyad.point);
    add(dyad.length);
    add(dyad.guide);
    add(dyad.assembly);
  }
  void operator()(const Rpr<double>& dyad) {
    add(dyad.block);
    add(dyad.pivot);
    add(dyad.offset);
    add(dyad.assembly);
  }
  void operator()(const Prp<double>& dyad) {
    add(dyad.first);
    add(dyad.second);
  }
  void operator()(const Rpp<double>& dyad) {
    add(dyad.point);
    add(dyad.slot);
    add(dyad.guide);
  }
  void operator()(const Cylinder<double>& dyad) {
    add(dyad.base);
    add(dyad.pivot);
    add(dyad.length);
    add(dyad.assembly);
  }
  void operator()(const Group& group) {
    for (const GroupJoint& joint : group.joints) {
      structure.push_back(joint.slides);
      add(joint.first);
      add(joint.second);
      if (!joint.slides) continue;
      add(joint.along_first);
      add(joint.along_second);
    }
    for (const Placement& body : group.drawn) {
      add(body.origin);
      add(body.direction);
    }
    add(group.drive);
  }
  void operator()(const GroupRest&) {}

 private:
  void add(double number) { numbers.push_back(number); }
  void add(Assembly assembly) { structure.push_back(static_cast<int>(assembly)); }
  void add(const Vec2d& v) {
    add(v.x);
    add(v.y);
  }
  void add(const Attached<double>& point) {
    structure.push_back(point.body);
    add(point.at);
  }
  void add(const Guide<double>& guide) {
    structure.push_back(guide.body);
    add(guide.through);
    add(guide.direction);
    add(guide.offset);
  }
};

bool nearly_equal(const std::vector<double>& given, const std::vector<double>& read) {
  constexpr double kSame = 1e-9;
  double size = 1;
  for (const double number : read) size = std::max(size, std::abs(number));
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (!(std::abs(given[i] - read[i]) <= kSame * size)) return false;
  }
  return true;
}

}  // namespace

TableWriter load_writer(const AnalysisProblem& problem, const LoadRule& load) {
  TableWriter table;
  const auto& bodies = problem.mechanism.bodies;
  const auto body = static_cast<std::size_t>(load.at.body);
  table.set("on", body < bodies.size() ? bodies[body] : std::string{})
      .set("at", without_rounding(load.at.at))
      .set("force", load.force)
      .set("torque", load.torque);
  if (load.between) {
    const auto& [from, to] = *load.between;
    table.add("when", drive_slides(problem) ? node(Range{from, to}) : node_deg(Range{from, to}));
  } else {
    table.set_name("when", load.sense);
  }
  if (load.within_stroke) table.set("stroke", *load.within_stroke);
  return table;
}

Table body_tables(const AnalysisProblem& problem, const Array& more_loads,
                  std::vector<std::string>& faults) {
  const auto& bodies = problem.mechanism.bodies;
  if (!problem.inertias.empty() && problem.inertias.size() != bodies.size()) {
    faults.push_back(fmt::format("inertias has {} entries for {} bodies; expected one for each",
                                 problem.inertias.size(), bodies.size()));
  }
  Array links;
  for (std::size_t i = 0; i < std::min(bodies.size(), problem.inertias.size()); ++i) {
    const Inertia& inertia = problem.inertias[i];
    if (inertia.mass == 0 && inertia.moment == 0) continue;
    links.push_back(node(TableWriter{}
                             .set("name", bodies[i])
                             .set("mass", inertia.mass)
                             .set("centre", without_rounding(inertia.centre))
                             .set("inertia", inertia.moment)));
  }
  Array loads;
  for (const LoadRule& load : problem.loads) {
    check_load(problem, load, faults);
    loads.push_back(node(load_writer(problem, load)));
  }
  loads.insert(loads.end(), more_loads.begin(), more_loads.end());
  return TableWriter{}.set("link", links).set("load", loads).set("gravity", problem.gravity).take();
}

void check_load(const AnalysisProblem& problem, const LoadRule& load,
                std::vector<std::string>& faults) {
  const auto count = static_cast<int>(problem.mechanism.bodies.size());
  if (load.at.body >= 0 && load.at.body < count) return;
  faults.push_back(
      fmt::format("a load is on body {}; expected one from 1 to {}", load.at.body, count - 1));
}

void check_same_mechanism(const NamedMechanism& given, const NamedMechanism& read,
                          std::vector<std::string>& faults) {
  const auto bodies = static_cast<int>(read.bodies.size());
  const bool has_all = given.bodies.size() == read.bodies.size() &&
                       std::ranges::all_of(given.points, [&](const NamedPoint& point) {
                         return point.at.body >= 0 && point.at.body < bodies;
                       });
  const Digest has(given), wants(read);
  const bool same = has_all && has.structure == wants.structure &&
                    has.numbers.size() == wants.numbers.size() &&
                    nearly_equal(has.numbers, wants.numbers);
  if (same) return;
  faults.emplace_back(
      "mechanism does not match its description; expected it as problems::named makes it of "
      "the description, or as a file is read");
}

}  // namespace cognate::problems::reading
