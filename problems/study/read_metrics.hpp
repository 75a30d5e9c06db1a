/// @file Which names a study may use for what a design has.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "problems/study/read_base.hpp"
#include "problems/study/study.hpp"

namespace cognate::problems::reading {

/// What a name in a study stands for.
enum class NameKind { number, word, either };

/// The varied keys and the metrics of a base.
class StudyNames {
 public:
  /// Without a base, which could not be read, every name is known and may be anything.
  StudyNames(const BaseFile* base, const Study& study);

  bool is_varied(std::string_view name) const;
  /// Empty where `name` is neither a varied key nor a metric.
  std::optional<NameKind> find(std::string_view name) const;
  /// The column that is already there and differs from `name` in capitals alone: in SQL they would
  /// be one.
  std::optional<std::string> namesake(std::string_view name) const;
  /// "did you mean …?", or where to look.
  std::string hint(std::string_view name) const;

 private:
  const BaseFile* base_;
  const Study* study_;
};

}  // namespace cognate::problems::reading
