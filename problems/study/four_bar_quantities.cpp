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

struct NamedQuantity {
  std::string_view name;
  Stage stage;
  FourBarQuantityId quantity;
};

constexpr std::array<NamedQuantity, 11> kQuantities{
    {{"class", Stage::links, FourBarQuantityId::mobility_class},
     {"change_point", Stage::links, FourBarQuantityId::change_point},
     {"crank_turns_fully", Stage::links, FourBarQuantityId::crank_turns_fully},
     {"mobility", Stage::links, FourBarQuantityId::mobility},
     {"moves_as", Stage::links, FourBarQuantityId::moves_as},
     {"output", Stage::links, FourBarQuantityId::output},
     {"transmission_angle_deg.min", Stage::closed_forms, FourBarQuantityId::transmission_min},
     {"transmission_angle_deg.max", Stage::closed_forms, FourBarQuantityId::transmission_max},
     {"transmission_angle_deg.acute_min", Stage::closed_forms,
      FourBarQuantityId::transmission_acute_min},
     {"time_ratio", Stage::closed_forms, FourBarQuantityId::time_ratio},
     {"output_swing_deg", Stage::closed_forms, FourBarQuantityId::output_swing}}};

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
    case CurveGroup::segments:
      return Stage::stretches;
    case CurveGroup::loose_segments:
      return Stage::loose_segments;
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
  const auto* const quantity = std::ranges::find(kQuantities, name, &NamedQuantity::name);
  if (quantity != kQuantities.end())
    return FourBarQuantity{quantity->name, quantity->stage, quantity->quantity};
  const CurveMetric* metric = find_curve_metric(name);
  if (!metric || (!has_point && metric->group > CurveGroup::size)) return std::nullopt;
  return FourBarQuantity{metric->key, stage_of(metric->group), FourBarQuantityId::curve, 0, metric};
}

bool ClosedForms::is_special(const Lengths<double>& links) {
  // A little wider than `is_change_point`, where ranges of the crank nearly meet.
  return std::abs(grashof_excess(links)) <= 1e-9;
}

bool ClosedForms::is_of_lengths(FourBarQuantityId quantity) {
  return quantity == FourBarQuantityId::varied || quantity == FourBarQuantityId::mobility_class ||
         quantity == FourBarQuantityId::change_point ||
         quantity == FourBarQuantityId::crank_turns_fully;
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

Cell ClosedForms::operator()(FourBarQuantityId quantity) {
  switch (quantity) {
    case FourBarQuantityId::mobility_class:
      return std::string(to_string(mobility_class(links_)));
    case FourBarQuantityId::change_point:
      return word(is_change_point(links_));
    case FourBarQuantityId::crank_turns_fully:
      return word(turns_);
    case FourBarQuantityId::mobility:
      return 1.0;
    default:
      break;
  }
  if (!assembles_) return {};
  switch (quantity) {
    case FourBarQuantityId::output:
      return std::string("rocker");
    case FourBarQuantityId::transmission_min:
      return transmission(&TransmissionAngles::min);
    case FourBarQuantityId::transmission_max:
      return transmission(&TransmissionAngles::max);
    case FourBarQuantityId::transmission_acute_min:
      return transmission(&TransmissionAngles::acute_min);
    case FourBarQuantityId::time_ratio:
      if (const auto ratio = time_ratio(links_)) return *ratio;
      return {};
    case FourBarQuantityId::output_swing:
      return swing();
    default:
      return {};
  }
}

}  // namespace cognate::problems
