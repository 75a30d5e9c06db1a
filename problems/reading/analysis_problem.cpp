#include "problems/reading/analysis_problem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "problems/analysis/simple_parts.hpp"
#include "problems/reading/chain.hpp"
#include "problems/reading/drive_table.hpp"
#include "problems/reading/extra_points.hpp"
#include "problems/reading/link_tables.hpp"
#include "problems/reading/nearest.hpp"
#include "problems/reading/output_table.hpp"
#include "problems/reading/simple_mechanism.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kType = "type";

// A mechanism, and the names of its parts for the tables that refer to them.
struct NamedReading {
  NamedMechanism mechanism;
  PartNames names;
};

std::optional<MechanismType> read_type(TableReader& mechanism) {
  if (mechanism.has(kType)) return mechanism.choice<MechanismType>(kType);
  std::vector<std::string_view> allowed;
  for (const auto& named : names<MechanismType>()) allowed.push_back(named.name);
  mechanism.fault(kType, fmt::format("is missing; allowed are {}", quoted_list(allowed)));
  return std::nullopt;
}

NamedReading read_simple(TableReader& document, TableReader& mechanism, MechanismType type) {
  NamedReading read;
  auto whole = read_simple_mechanism(mechanism, type);
  if (whole.sound) {
    read.names = PartNames(std::move(whole.parts));
  } else {  // of the points only the names are right
    read.names = PartNames({std::move(whole.parts.bodies), {}});
    for (const PlacedPoint& point : whole.parts.points) read.names.announce(point.name);
    read.names.incomplete = true;
  }
  read.mechanism.mechanism = std::move(whole.mechanism);
  read.mechanism.description = std::move(whole.description);
  auto points = read_extra_points(holder("point", document, mechanism), read.names);
  read.mechanism.extra_points = place_extra_points(points, read.names);
  fault_unplaced(points, read.names, document.faults());
  read.mechanism.output = output_of(type);
  return read;
}

NamedReading read_chain_mechanism(TableReader& document, TableReader& mechanism) {
  Chain chain = read_chain(document, mechanism);
  NamedReading read;
  read.names = std::move(chain.names);
  read.mechanism.mechanism = std::move(chain.mechanism);
  read.mechanism.description = std::move(chain.description);
  read.mechanism.extra_points = std::move(chain.points);
  read.mechanism.output = body_count(read.mechanism.mechanism) - 1;
  return read;
}

NamedReading read_mechanism(TableReader& document, TableReader& mechanism, MechanismType type) {
  NamedReading read = type == MechanismType::chain ? read_chain_mechanism(document, mechanism)
                                                   : read_simple(document, mechanism, type);
  read.mechanism.type = type;
  if (const auto* four_bar = std::get_if<FourBar>(&read.mechanism.description)) {
    if (type == MechanismType::four_bar) read.mechanism.four_bar = *four_bar;
  }
  for (const Body& body : read.names.parts().bodies) read.mechanism.bodies.push_back(body.name);
  for (const PlacedPoint& point : read.names.parts().points) {
    read.mechanism.points.push_back({point.name, point.on.front()});
  }
  return read;
}

bool weighs_or_bears(const AnalysisProblem& problem) {
  return !problem.loads.empty() ||
         std::ranges::any_of(problem.inertias, [](const Inertia& inertia) {
           return inertia.mass > 0 || inertia.moment > 0;
         });
}

/// Where no mechanism can be read, the parts that the other tables name are not known, but their
/// numbers and keys are checked all the same.
void check_without_mechanism(TableReader& document, TableReader& mechanism, TableReader& drive,
                             TableReader& output) {
  PartNames unknown;
  unknown.incomplete = true;
  const bool slides = document.has("slider") || mechanism.has("slider");
  read_links(holder("link", document, mechanism), unknown);
  read_loads(holder("load", document, mechanism), unknown, slides);
  read_gravity(holder("gravity", document, mechanism));
  read_drive(drive, slides, 0);
  read_output(output, unknown, false);
  document.know({"pivot", "crank", "slider", "dyad", "point"});
}

/// What can be asked of four-bars with a coupler point alone.
void check_coupler_curve(TableReader& output, TableReader& mechanism,
                         const AnalysisProblem& problem) {
  if (problem.mechanism.type == MechanismType::four_bar && mechanism.has("coupler_point")) return;
  if (problem.output.cognates) {
    output.fault(kCognates,
                 "is true; a four-bar with a coupler_point is wanted, no other has cognates");
  }
  if (problem.output.curve) {
    output.fault(kCurve,
                 "is true; a four-bar with a coupler_point is wanted, whose curve is measured");
  }
}

}  // namespace

AnalysisProblem read_analysis_problem(TableReader& document) {
  AnalysisProblem problem;
  TableReader mechanism = document.table("mechanism");
  TableReader drive = document.table("drive");
  TableReader output = document.table("output");
  const auto type = read_type(mechanism);
  if (!type) {
    check_without_mechanism(document, mechanism, drive, output);
    return problem;
  }
  NamedReading read = read_mechanism(document, mechanism, *type);
  const bool slides = std::holds_alternative<DrivingSlider<double>>(read.mechanism.mechanism.drive);
  const std::size_t parts = read.mechanism.bodies.size() + read.mechanism.points.size();
  problem.inertias = read_links(holder("link", document, mechanism), read.names);
  problem.loads = read_loads(holder("load", document, mechanism), read.names, slides);
  problem.gravity = read_gravity(holder("gravity", document, mechanism));
  problem.drive = read_drive(drive, slides, parts);
  problem.output = read_output(output, read.names, weighs_or_bears(problem));
  problem.mechanism = std::move(read.mechanism);
  check_coupler_curve(output, mechanism, problem);
  mechanism.finish();
  return problem;
}

}  // namespace cognate::problems::reading
