#include "problems/evaluation/read_tolerances.hpp"

#include "problems/evaluation/output_travel.hpp"
#include "problems/mechanism/joint_names.hpp"
#include "problems/task_document.hpp"
#include "problems/tolerance/dimensions.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {

namespace reading {
namespace {

ToleranceScope scope_of(const NamedMechanism& mechanism) {
  ToleranceScope scope{
      .dimensions = dimension_groups(mechanism), .joints = pin_names(mechanism), .points = {}};
  for (const NamedPoint& point : mechanism.points) {
    if (point.at.body != 0) scope.points.push_back(point.name);
  }
  if (!output_travel(mechanism).slides) scope.unit = "deg";
  return scope;
}

/// The unit of the document's lengths; none where it has none or a wrong one.
std::optional<LengthUnit> length_unit(TableReader& document) {
  if (!document.has_text(kLengthUnit)) return std::nullopt;
  return from_string<LengthUnit>(*document.text(kLengthUnit));
}

}  // namespace

std::optional<Tolerances> read_tolerances(TableReader& document, const NamedMechanism& mechanism) {
  auto tolerances = read_tolerances(document, scope_of(mechanism));
  if (!tolerances || document.faults().size() > 0) return tolerances;
  const auto changed = toleranced(mechanism, *tolerances, length_unit(document));
  if (!changed) fault_impossible(document, changed.error().group, changed.error().reason);
  return tolerances;
}

}  // namespace reading

bool judges_angle(const AnalysisProblem& problem) {
  // A problem of a user's own may have no such body.
  const auto output = static_cast<std::size_t>(problem.mechanism.output);
  if (!problem.tolerances || output >= problem.mechanism.bodies.size()) return false;
  return problem.tolerances->of.empty() && !output_travel(problem.mechanism).slides;
}

}  // namespace cognate::problems
