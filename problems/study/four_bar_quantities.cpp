#include "problems/study/four_bar_quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"

namespace cognate::problems {
namespace {

using Stage = FourBarStage;

struct NamedFact {
  std::string_view name;
  Stage stage;
  FourBarFact fact;
};

constexpr std::array<NamedFact, 11> kFacts{
    {{"class", Stage::links, FourBarFact::mobility_class},
     {"change_point", Stage::links, FourBarFact::change_point},
     {"crank_turns_fully", Stage::links, FourBarFact::crank_turns_fully},
     {"mobility", Stage::links, FourBarFact::mobility},
     {"moves_as", Stage::links, FourBarFact::moves_as},
     {"output", Stage::links, FourBarFact::output},
     {"transmission_angle_deg.min", Stage::closed_forms, FourBarFact::transmission_min},
     {"transmission_angle_deg.max", Stage::closed_forms, FourBarFact::transmission_max},
     {"transmission_angle_deg.acute_min", Stage::closed_forms, FourBarFact::transmission_acute_min},
     {"time_ratio", Stage::closed_forms, FourBarFact::time_ratio},
     {"output_swing_deg", Stage::closed_forms, FourBarFact::output_swing}}};

Stage stage_of(CurveGroup group) {
  switch (group) {
    case CurveGroup::links:
      return Stage::links;
    case CurveGroup::size:
      return Stage::size;
    case CurveGroup::sums:
      return Stage::sums;
    case CurveGroup::widths:
      return Stage::widths;
    case CurveGroup::descriptors:
      return Stage::descriptors;
    case CurveGroup::stretches:
      return Stage::stretches;
    case CurveGroup::loose_stretches:
      return Stage::loose_stretches;
    case CurveGroup::features:
      return Stage::features;
  }
  return Stage::features;
}

Cell word(bool value) {
  return std::string(value ? "true" : "false");
}

}  // namespace

std::optional<FourBarQuantity> four_bar_quantity(const Study& study, std::string_view name,
                                                 bool has_point) {
  const auto& variables = study.variables;
  const auto varied = std::ranges::find(variables, name, &StudyVariable::key);
  if (varied != variables.end()) {
    return FourBarQuantity{.name = varied->key,
                           .variable = static_cast<std::size_t>(varied - variables.begin())};
  }
  const auto* const fact = std::ranges::find(kFacts, name, &NamedFact::name);
  if (fact != kFacts.end()) return FourBarQuantity{fact->name, fact->stage, fact->fact};
  const CurveMetric* metric = find_curve_metric(name);
  if (!metric || (!has_point && metric->group > CurveGroup::size)) return std::nullopt;
  return FourBarQuantity{metric->key, stage_of(metric->group), FourBarFact::curve, 0, metric};
}

bool ClosedForms::is_special(const Lengths<double>& links) {
  // A little wider than `is_change_point`, where ranges of the crank nearly meet.
  return std::abs(grashof_excess(links)) <= 1e-9;
}

bool ClosedForms::is_of_lengths(FourBarFact fact) {
  return fact == FourBarFact::varied || fact == FourBarFact::mobility_class ||
         fact == FourBarFact::change_point || fact == FourBarFact::crank_turns_fully;
}

void ClosedForms::begin(const Lengths<double>& links) {
  links_ = links;
  assembles_ = can_assemble(links);
  turns_ = assembles_ && crank_rotates(links);
  angles_.reset();
}

double ClosedForms::transmission(double TransmissionAngles::*angle) {
  if (!angles_) angles_ = transmission_angles(links_);
  return kDegreesInRadian * (*angles_).*angle;
}

Cell ClosedForms::swing() const {
  const auto outer = outer_limit(links_), inner = inner_limit(links_);
  if (!outer || !inner) return {};
  return kDegreesInRadian * std::abs(outer->rocker_angle - inner->rocker_angle);
}

Cell ClosedForms::operator()(FourBarFact fact) {
  switch (fact) {
    case FourBarFact::mobility_class:
      return std::string(to_string(mobility_class(links_)));
    case FourBarFact::change_point:
      return word(is_change_point(links_));
    case FourBarFact::crank_turns_fully:
      return word(turns_);
    case FourBarFact::mobility:
      return 1.0;
    default:
      break;
  }
  if (!assembles_) return {};
  switch (fact) {
    case FourBarFact::output:
      return std::string("rocker");
    case FourBarFact::transmission_min:
      return transmission(&TransmissionAngles::min);
    case FourBarFact::transmission_max:
      return transmission(&TransmissionAngles::max);
    case FourBarFact::transmission_acute_min:
      return transmission(&TransmissionAngles::acute_min);
    case FourBarFact::time_ratio:
      if (const auto ratio = time_ratio(links_)) return *ratio;
      return {};
    case FourBarFact::output_swing:
      return swing();
    default:
      return {};
  }
}

}  // namespace cognate::problems
