/// An analysis written down, and checked by reading what was written.
#include "problems/evaluation/write.hpp"

#include <fmt/core.h>

#include "problems/evaluation/problem.hpp"
#include "problems/evaluation/read_tolerances.hpp"
#include "problems/layers/read.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/mechanism/write_mechanism.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {
namespace reading {
namespace {

TableWriter sweep_writer(const AnalysisProblem& problem) {
  const DriveSweep& drive = problem.drive;
  TableWriter table;
  table.set("speed", drive.rate.speed).set("acceleration", drive.rate.acceleration);
  if (drive_slides(problem)) {
    table.set("start", drive.start).set("end", drive.end);
  } else {
    table.set_deg("start_deg", drive.start).set_deg("end_deg", drive.end);
  }
  return table.set("steps", drive.steps);
}

/// The names of what is numbered; a number of nothing is a fault.
template <class NameOf>
Array names_of(const std::vector<int>& indices, std::size_t count, std::string_view key,
               const NameOf& name_of, std::vector<std::string>& faults) {
  Array all;
  for (const int index : indices) {
    const auto place = static_cast<std::size_t>(index);
    if (place < count) {
      all.push_back(node(name_of(place)));
    } else {
      faults.push_back(fmt::format("output.{} has the index {}; expected one from 0 to {}", key,
                                   index, std::ssize(indices) > 0 ? count - 1 : 0));
    }
  }
  return all;
}

TableWriter output_writer(const AnalysisProblem& problem, std::vector<std::string>& faults) {
  const AnalysisOutput& wanted = problem.output;
  const NamedMechanism& mechanism = problem.mechanism;
  TableWriter table;
  // Studies may need nothing but what is known without a table; files ask for something.
  const bool none = !wanted.position && !wanted.velocity && !wanted.acceleration &&
                    !wanted.transmission && !wanted.curvature && !wanted.reactions &&
                    !wanted.torque && wanted.points.empty() && wanted.instant_geometry.empty() &&
                    !wanted.curve && !wanted.cognates && !wanted.foot;
  table.set("position", wanted.position || none)
      .set("velocity", wanted.velocity)
      .set("acceleration", wanted.acceleration)
      .set("transmission", wanted.transmission)
      .set("curvature", wanted.curvature)
      .set("reactions", wanted.reactions)
      .set("torque", wanted.torque);
  const Array points = names_of(
      wanted.points, mechanism.points.size(), "points",
      [&](std::size_t i) { return mechanism.points[i].name; }, faults);
  const Array bodies = names_of(
      wanted.instant_geometry, mechanism.bodies.size(), "instant_geometry",
      [&](std::size_t i) { return mechanism.bodies[i]; }, faults);
  if (!points.empty()) table.set("points", points);
  if (!bodies.empty()) table.set("instant_geometry", bodies);
  if (wanted.curve) table.set("curve", true);
  if (wanted.cognates) table.set("cognates", true);
  if (wanted.foot) {
    const Array foot = names_of(
        {*wanted.foot}, mechanism.points.size(), "foot",
        [&](std::size_t i) { return mechanism.points[i].name; }, faults);
    if (!foot.empty()) table.add("foot", foot.front());
  }
  table.set("duty", wanted.duty);
  return table;
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<AnalysisProblem>::written(const AnalysisProblem& problem) {
  using namespace reading;
  Written all;
  all.document = document_writer(kWord, problem.title, problem.length_unit)
                     .set("mechanism", mechanism_writer(problem.mechanism))
                     .set("drive", sweep_writer(problem))
                     .set("output", output_writer(problem, all.faults))
                     .append(body_tables(problem, {}, all.faults))
                     .append(tolerance_table(problem.tolerances, judges_angle(problem)))
                     .append(layers_table(problem.layers))
                     .take();
  return all;
}

tl::expected<AnalysisProblem, std::vector<std::string>> KindTraits<AnalysisProblem>::checked(
    const AnalysisProblem& problem) {
  using namespace reading;
  const auto read = read_back(problem);
  if (!read) return tl::unexpected(read.error());
  std::vector<std::string> faults;
  check_same_mechanism(problem.mechanism, read->mechanism, faults);
  if (!faults.empty()) return tl::unexpected(faults);
  AnalysisProblem complete = problem;
  if (complete.inertias.empty()) complete.inertias = read->inertias;
  return complete;
}

}  // namespace cognate::problems
