#include "problems/evaluation/curve_metrics.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/coupler_curve/curve_features.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

constexpr std::array<int, 8> kMagnitudes{-4, -3, -2, -1, 1, 2, 3, 4};
constexpr std::array<int, 6> kPhases{-4, -3, -2, 2, 3, 4};

double longest(const Lengths<double>& links) {
  return std::max({links.crank, links.coupler, links.rocker, links.frame});
}

}  // namespace

const std::vector<CurveMetric>& curve_metrics() {
  using enum CurveGroup;
  static const std::vector<CurveMetric> all = {
      {"longest_link", links, 0},
      {"link_ratio", links, 1},
      {"size", size, 0},
      {"curve_length", sums, 0},
      {"curve_area", sums, 1},
      {"curve_width_min", widths, 0},
      {"curve_width_max", widths, 1},
      {"fourier.m4", descriptors, 0},
      {"fourier.m3", descriptors, 1},
      {"fourier.m2", descriptors, 2},
      {"fourier.m1", descriptors, 3},
      {"fourier.p1", descriptors, 4},
      {"fourier.p2", descriptors, 5},
      {"fourier.p3", descriptors, 6},
      {"fourier.p4", descriptors, 7},
      {"fourier_phase_deg.m4", descriptors, 8},
      {"fourier_phase_deg.m3", descriptors, 9},
      {"fourier_phase_deg.m2", descriptors, 10},
      {"fourier_phase_deg.p2", descriptors, 11},
      {"fourier_phase_deg.p3", descriptors, 12},
      {"fourier_phase_deg.p4", descriptors, 13},
      {"straight_length_at_0_001", segments, 0},
      {"straight_length_over_longest_link", segments, 1},
      {"straight_length_at_0_01", loose_segments, 0},
      {"cusps", features, 0},
      {"double_points", features, 1},
      {"inflections", features, 2},
  };
  return all;
}

const CurveMetric* find_curve_metric(std::string_view key) {
  const auto& all = curve_metrics();
  const auto found = std::ranges::find(all, key, &CurveMetric::key);
  return found == all.end() ? nullptr : &*found;
}

void CurveValues::begin(const FourBar& linkage, const CircuitChoice& circuit) {
  linkage_ = linkage;
  circuit_ = circuit;
  known_.fill(false);
  settled_ = {};
}

void CurveValues::know_sums(double length, double area) {
  values(CurveGroup::sums) = {length, area};
  known_[static_cast<std::size_t>(CurveGroup::sums)] = true;
}

std::optional<double> CurveValues::operator()(const CurveMetric& metric) {
  bool& known = known_[static_cast<std::size_t>(metric.group)];
  if (!known) {
    values(metric.group).fill(std::nullopt);
    compute(metric.group);
    known = true;
  }
  return values(metric.group)[static_cast<std::size_t>(metric.index)];
}

const CycleTable& CurveValues::table(std::size_t count) {
  const auto has_count = [count](const CycleTable& table) { return table.cos.size() == count; };
  const auto found = std::ranges::find_if(tables_, has_count);
  return found == tables_.end() ? tables_.emplace_back(count) : *found;
}

void CurveValues::compute(CurveGroup group) {
  switch (group) {
    case CurveGroup::links:
      return find_links();
    case CurveGroup::size:
      values(group)[0] = moving_pivots_size(linkage_, circuit_);
      return;
    case CurveGroup::sums:
      return find_sums();
    case CurveGroup::widths:
      return find_widths();
    case CurveGroup::descriptors:
      return find_descriptors();
    case CurveGroup::segments:
      values(group)[0] = longest_segment(0.001);
      values(group)[1] = *values(group)[0] / longest(lengths(linkage_));
      return;
    case CurveGroup::loose_segments:
      values(group)[0] = longest_segment(0.01);
      return;
    case CurveGroup::features:
      return find_features();
  }
}

void CurveValues::find_links() {
  const Lengths<double> links = lengths(linkage_);
  values(CurveGroup::links)[0] = longest(links);
  values(CurveGroup::links)[1] =
      longest(links) / std::min({links.crank, links.coupler, links.rocker, links.frame});
}

void CurveValues::find_sums() {
  for (const std::size_t count : kCurveSteps) {
    sample_circuit(linkage_, circuit_, table(count), room_);
    sums_.add_up(room_.samples(), 1);
    if (sums_.is_settled(0)) break;
  }
  use(room_.samples());
  know_sums(sums_.length[0], sums_.area[0]);
}

void CurveValues::find_widths() {
  if (settled_.size() == 0) find_sums();
  const CurveWidths found = widths_(settled_);
  values(CurveGroup::widths)[0] = found.least;
  values(CurveGroup::widths)[1] = found.greatest;
}

void CurveValues::find_descriptors() {
  if (settled_.size() == 0) find_sums();
  if (!(values(CurveGroup::sums)[0] > 0)) return;
  const FourierDescriptors found = descriptors_(settled_);
  auto& all = values(CurveGroup::descriptors);
  for (std::size_t i = 0; i < kMagnitudes.size(); ++i) all[i] = norm(found.of(kMagnitudes[i]));
  constexpr double kNoDirection = 1e-9;
  // Where c₋₁ vanishes nothing says where the curve begins.
  if (norm(found.of(-1)) < kNoDirection) return;
  for (std::size_t i = 0; i < kPhases.size(); ++i) {
    const Vec2d& c = found.of(kPhases[i]);
    if (norm(c) < kNoDirection) continue;
    all[kMagnitudes.size() + i] = std::atan2(c.y, c.x) * (180 / kPi);
  }
}

double CurveValues::longest_segment(double relative) {
  sample_circuit(linkage_, circuit_, table(samples_for_segments(relative)), segment_room_);
  return segments_(segment_room_.samples(), relative);
}

void CurveValues::find_features() {
  const auto found = curve_features(linkage_, circuit_);
  if (!found) return;
  auto& all = values(CurveGroup::features);
  all[0] = static_cast<double>(found->cusps.size());
  all[1] = static_cast<double>(found->double_points.size());
  all[2] = static_cast<double>(found->inflections.size());
}

std::vector<Quantity> curve_quantities(const AnalysisProblem& problem) {
  const FourBar* linkage = problem.mechanism.four_bar();
  if (!problem.output.curve || !linkage || !linkage->coupler_point) return {};
  if (!can_assemble(lengths(*linkage))) return {};
  CurveValues values;
  values.begin(*linkage, circuit_at(*linkage, problem.drive.start));
  std::vector<Quantity> quantities;
  for (const CurveMetric& metric : curve_metrics()) {
    const auto value = values(metric);
    if (value && std::isfinite(*value)) quantities.push_back({std::string(metric.key), *value});
  }
  return quantities;
}

}  // namespace cognate::problems
