#include "problems/straight_line/segment_forms.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

/// Cells between nodes.
constexpr int kFormCells = 24;

}  // namespace

SegmentForms::SegmentForms(const StraightLineProblem& scaled) : scaled_(scaled) {
  for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
    if (scaled.given.assembly.value_or(assembly) != assembly) continue;
    LinkageSegment any;
    any.type = scaled.type;
    any.assembly = assembly;
    any.dimensions = {{1, 2, 2, 2}, {1, 0}};
    any.reach = 1;
    any.length = scaled.goal->length.value_or(1);
    number_of(any);
  }
}

int SegmentForms::number_of(const LinkageSegment& segment) {
  const auto own = class_of(scaled_, segment);
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    if (forms_[i].start.assembly == segment.assembly && forms_[i].required == own) {
      return static_cast<int>(i);
    }
  }
  forms_.push_back(
      {segment, own,
       std::make_shared<const SegmentModel>(scaled_, segment, segment_nodes(kFormCells))});
  return static_cast<int>(forms_.size()) - 1;
}

int SegmentForms::known(const LinkageSegment& segment) const {
  const auto own = class_of(scaled_, segment);
  int first = -1;
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    if (forms_[i].start.assembly != segment.assembly) continue;
    if (forms_[i].required == own) return static_cast<int>(i);
    if (first < 0) first = static_cast<int>(i);
  }
  return first;
}

std::vector<double> SegmentForms::variables_of(int form, LinkageSegment segment) const {
  const LinkageSegment& start = of(form).start;
  const auto beside = [](double angle, double other) {
    return other + std::remainder(angle - other, kTurn);
  };
  segment.centre = beside(segment.centre, start.centre);
  segment.line = beside(segment.line, start.line);
  return model(form).variables_of(segment);
}

std::vector<Assembly> SegmentForms::assemblies() const {
  std::vector<Assembly> all;
  for (const Form& form : forms_) {
    if (std::ranges::find(all, form.start.assembly) == all.end()) {
      all.push_back(form.start.assembly);
    }
  }
  return all;
}

std::vector<std::shared_ptr<const synthesis::Model>> SegmentForms::models() const {
  std::vector<std::shared_ptr<const synthesis::Model>> all;
  for (const Form& form : forms_) all.push_back(form.model);
  return all;
}

}  // namespace cognate::problems
