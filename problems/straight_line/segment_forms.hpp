#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "problems/straight_line/model.hpp"
#include "problems/straight_line/problem.hpp"

namespace cognate::problems {

/// One model for each assembly and class, in whose variables the points of a search are written.
class SegmentForms {
 public:
  /// One model of each assembly that the problem allows. `scaled` must live as long as this.
  explicit SegmentForms(const StraightLineProblem& scaled);

  /// The number of a segment's form, which is added where there is none yet.
  int number_of(const LinkageSegment& segment);

  /// That of a segment, whose assembly has one; of another class the first of its assembly.
  int known(const LinkageSegment& segment) const;

  const SegmentModel& model(int form) const { return *of(form).model; }

  std::vector<double> variables_of(int form, LinkageSegment segment) const;

  std::vector<Assembly> assemblies() const;

  std::vector<std::shared_ptr<const synthesis::Model>> models() const;

 private:
  struct Form {
    LinkageSegment start;
    std::optional<RequiredClass> required;
    std::shared_ptr<const SegmentModel> model;
  };

  const Form& of(int form) const { return forms_[static_cast<std::size_t>(form)]; }

  const StraightLineProblem& scaled_;
  std::vector<Form> forms_;
};

}  // namespace cognate::problems
