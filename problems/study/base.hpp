/// @file The base file of a study, read once, as any of its designs.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <tl/expected.hpp>
#include <vector>

#include "problems/read.hpp"
#include "problems/study/study.hpp"

namespace cognate::problems {

/// Gives the problem of the base file of a study with other numbers, without reading text again.
class StudyBase {
 public:
  explicit StudyBase(const Study& study);
  ~StudyBase();
  StudyBase(StudyBase&&) noexcept;
  StudyBase& operator=(StudyBase&&) noexcept;

  /// The problem of the base with `values`, one for each variable, or every fault that it then has,
  /// where they stand in the base. A whole number where the base has one stays one.
  tl::expected<Task, std::vector<Fault>> with(std::span<const double> values);

 private:
  struct Document;
  std::unique_ptr<Document> document_;
};

/// Whether `value` can be written as an integer that is read as the same double.
bool is_whole(double value);

}  // namespace cognate::problems
