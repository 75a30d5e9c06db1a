/// @file What a study of four-bars can ask for, by the stage of its evaluation.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "problems/evaluation/curve_metrics.hpp"
#include "problems/study/block.hpp"
#include "problems/study/study.hpp"

namespace cognate::problems {

/// From the cheapest to the dearest. Of the curve the stages are the groups of `curve_metrics`.
enum class FourBarStage {
  varied,
  links,
  closed_forms,
  size,
  sums,
  widths,
  descriptors,
  stretches,
  loose_segments,
  features
};

/// What the quantities are.
enum class FourBarQuantityId {
  varied,
  mobility_class,
  change_point,
  crank_turns_fully,
  mobility,
  moves_as,
  output,
  transmission_min,
  transmission_max,
  transmission_acute_min,
  time_ratio,
  output_swing,
  curve
};

/// A number or word of a design. Names of varied keys are the study's.
struct FourBarQuantity {
  std::string_view name;
  FourBarStage stage = FourBarStage::varied;
  FourBarQuantityId quantity = FourBarQuantityId::varied;
  std::size_t variable = 0;             ///< of a varied key
  const CurveMetric* metric = nullptr;  ///< of the curve
};

/// The quantity called `name` in `study`; empty where there is none, or one that wants a coupler
/// point and `has_point` is false.
std::optional<FourBarQuantity> four_bar_quantity(const Study& study, std::string_view name,
                                                 bool has_point);

/// Facts of one design after the other, from its dimensions alone.
class ClosedForms {
 public:
  /// Whether a design of these links is left to `analyse`: at change points quantities depend on
  /// the course of the motion.
  static bool is_special(const Lengths<double>& links);

  /// What follows from the lengths at change points, too.
  static bool is_of_lengths(FourBarQuantityId quantity);

  void begin(const Lengths<double>& links);

  bool assembles() const { return assembles_; }
  bool turns() const { return turns_; }
  Cell operator()(FourBarQuantityId quantity);

 private:
  double transmission(double TransmissionAngles::*angle);
  Cell swing() const;

  Lengths<double> links_;
  bool assembles_ = false, turns_ = false;
  std::optional<TransmissionAngles> angles_;
};

}  // namespace cognate::problems
