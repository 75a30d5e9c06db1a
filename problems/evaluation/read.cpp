#include "problems/evaluation/read.hpp"

#include <algorithm>
#include <utility>

#include "problems/evaluation/read_drive.hpp"
#include "problems/evaluation/read_output.hpp"
#include "problems/mechanism/read_links.hpp"
#include "problems/mechanism/read_whole_mechanism.hpp"

namespace cognate::problems::reading {
namespace {

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
  const PartNames unknown = unknown_parts(document);
  const bool slides = document.has("slider") || mechanism.has("slider");
  read_links(holder("link", document, mechanism), unknown);
  read_loads(holder("load", document, mechanism), unknown, slides);
  read_gravity(holder("gravity", document, mechanism));
  read_drive(drive, slides, 0);
  read_output(output, unknown, false);
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
  auto whole = read_whole_mechanism(document, mechanism);
  if (!whole) {
    check_without_mechanism(document, mechanism, drive, output);
    return problem;
  }
  WholeMechanism& read = *whole;
  const bool slides = is_slider_driven(read.mechanism);
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
