#include "problems/study/four_bar_quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "analysis/mobility.hpp"
#include "problems/names.hpp"

namespace cognate::problems {
namespace {

using Fact = FourBarQuantity::Fact;
using Stage = FourBarStage;

constexpr double kDegrees = 180 / std::numbers::pi;

struct NamedFact {
  std::string_view name;
  Stage stage;
  Fact fact;
};

constexpr std::array<NamedFact, 11> kFacts{
    {{"class", Stage::links, Fact::mobility_class},
     {"change_point", Stage::links, Fact::change_point},
     {"crank_turns_fully", Stage::links, Fact::crank_turns_fully},
     {"mobility", Stage::links, Fact::mobility},
     {"moves_as", Stage::links, Fact::moves_as},
     {"output", Stage::links, Fact::output},
     {"transmission_angle_deg.min", Stage::closed_forms, Fact::transmission_min},
     {"transmission_angle_deg.max", Stage::closed_forms, Fact::transmission_max},
     {"transmission_angle_deg.acute_min", Stage::closed_forms, Fact::transmission_acute_min},
     {"time_ratio", Stage::closed_forms, Fact::time_ratio},
     {"output_swing_deg", Stage::closed_forms, Fact::output_swing}}};

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
    return FourBarQuantity{.name = name,
                           .variable = static_cast<std::size_t>(varied - variables.begin())};
  }
  const auto* const fact = std::ranges::find(kFacts, name, &NamedFact::name);
  if (fact != kFacts.end()) return FourBarQuantity{name, fact->stage, fact->fact};
  const CurveMetric* metric = find_curve_metric(name);
  if (!metric || !has_point) return std::nullopt;
  return FourBarQuantity{name, stage_of(metric->group), Fact::curve, 0, metric};
}

bool ClosedForms::is_special(const Lengths<double>& links) {
  // A little wider than `is_change_point`, where ranges of the crank nearly meet.
  return std::abs(grashof_excess(links)) <= 1e-9;
}

void ClosedForms::begin(const Lengths<double>& links) {
  links_ = links;
  assembles_ = can_assemble(links);
  turns_ = assembles_ && crank_rotates(links);
  angles_.reset();
}

double ClosedForms::transmission(double TransmissionAngles::*angle) {
  if (!angles_) angles_ = transmission_angles(links_);
  return kDegrees * (*angles_).*angle;
}

Cell ClosedForms::swing() const {
  const auto outer = outer_limit(links_), inner = inner_limit(links_);
  if (!outer || !inner) return {};
  return kDegrees * std::abs(outer->rocker_angle - inner->rocker_angle);
}

Cell ClosedForms::operator()(Fact fact) {
  switch (fact) {
    case Fact::mobility_class:
      return std::string(to_string(mobility_class(links_)));
    case Fact::change_point:
      return word(is_change_point(links_));
    case Fact::crank_turns_fully:
      return word(turns_);
    case Fact::mobility:
      return 1.0;
    default:
      break;
  }
  if (!assembles_) return {};
  switch (fact) {
    case Fact::output:
      return std::string("rocker");
    case Fact::transmission_min:
      return transmission(&TransmissionAngles::min);
    case Fact::transmission_max:
      return transmission(&TransmissionAngles::max);
    case Fact::transmission_acute_min:
      return transmission(&TransmissionAngles::acute_min);
    case Fact::time_ratio:
      if (const auto ratio = time_ratio(links_)) return *ratio;
      return {};
    case Fact::output_swing:
      return swing();
    default:
      return {};
  }
}

}  // namespace cognate::problems
