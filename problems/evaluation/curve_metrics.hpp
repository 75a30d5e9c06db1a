/// @file What a coupler curve is like, in numbers, over the circuit of its linkage.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "analysis/coupler_curve/closed_segment.hpp"
#include "analysis/coupler_curve/curve_measures.hpp"
#include "analysis/coupler_curve/fourier_descriptors.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::problems {

/// What is computed together, the cheapest first.
enum class CurveGroup {
  links,
  size,
  sums,
  widths,
  descriptors,
  segments,
  loose_segments,
  features
};

/// A number that `output.curve` gives; `key` as in `cognate list --metrics`.
struct CurveMetric {
  std::string_view key;
  CurveGroup group = CurveGroup::links;
  int index = 0;  ///< in its group
};

/// All of them, group by group.
const std::vector<CurveMetric>& curve_metrics();

/// That of a key, if it is one.
const CurveMetric* find_curve_metric(std::string_view key);

/// The values of one curve after the other; computes a group when one of its values is requested,
/// and keeps its room.
class CurveValues {
 public:
  /// Begins with the circuit of a linkage that has a coupler point and can be assembled.
  void begin(const FourBar& linkage, const CircuitChoice& circuit);

  /// Gives what is known already: the length and area of the curve, and samples that settle them,
  /// which are used until the next `begin`. What is not given is found when it is requested.
  void know_sums(double length, double area);
  void use(const CurveSamples& samples) { settled_ = samples; }

  /// Empty where the curve has no such value.
  std::optional<double> operator()(const CurveMetric& metric);

 private:
  static constexpr std::size_t kGroups = 8;

  void compute(CurveGroup group);
  std::array<std::optional<double>, 14>& values(CurveGroup group) {
    return values_[static_cast<std::size_t>(group)];
  }
  const CycleTable& table(std::size_t count);
  void find_links();
  void find_sums();
  void find_widths();
  void find_descriptors();
  double longest_segment(double relative);
  void find_features();

  FourBar linkage_;
  CircuitChoice circuit_;
  CurveSamples settled_;
  std::array<bool, kGroups> known_{};
  std::array<std::array<std::optional<double>, 14>, kGroups> values_;
  std::vector<CycleTable> tables_;  ///< made once
  CurveRoom room_, segment_room_;
  CurveSums sums_;
  WidthFinder widths_;
  DescriptorFinder descriptors_;
  ClosedSegmentFinder segments_;
};

/// The quantities that `output.curve` requests.
std::vector<Quantity> curve_quantities(const AnalysisProblem& problem);

}  // namespace cognate::problems
