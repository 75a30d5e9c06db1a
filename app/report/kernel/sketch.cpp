/// @file The searches in a page: a problem as a file would have it is read, solved by the program's
/// own reader and search, and comes back as the designs found.
#include <algorithm>
#include <string>
#include <string_view>
#include <variant>

#include "app/report/kernel/answer.hpp"
#include "app/report/kernel/document.hpp"
#include "app/report/kernel/numbers.hpp"
#include "app/report/kernel/sketched.hpp"
#include "problems/function/problem.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/path/problem.hpp"

namespace cognate::page {
namespace {

/// What a document calls its kind; empty where it does not.
std::string_view kind_of(const problems::reading::Table& document) {
  const auto entry = std::ranges::find(document, "kind", &problems::reading::Entry::key);
  const auto* word =
      entry == document.end() ? nullptr : std::get_if<std::string>(&entry->node.value);
  return word ? std::string_view(*word) : std::string_view();
}

}  // namespace

/// Solves the problem in the text and the block of numbers. The answer is `designs`, or `values`
/// of an expression, or `faults`, a list of sentences.
COGNATE_EXPORT(sketch) int sketch_text(int seed) {
  const auto document = document_of(question());
  const SketchQuestion asked{document, static_cast<std::uint64_t>(seed)};
  const std::string_view kind = kind_of(document);
  using problems::KindTraits;
  if (kind == KindTraits<problems::PathProblem>::kWord) return answer_with(sketched_paths(asked));
  if (kind == KindTraits<problems::MotionProblem>::kWord) {
    return answer_with(sketched_motions(asked));
  }
  if (kind == KindTraits<problems::FunctionProblem>::kWord) {
    return answer_with(sketched_functions(asked));
  }
  if (kind == kFunctionValues) return answer_with(function_values(asked));
  problems::reading::FaultList faults;
  faults.add({},
             "kind is none of \"path-generation\", \"motion-generation\" and "
             "\"function-generation\"");
  return answer_with(faults_json(std::move(faults)));
}

}  // namespace cognate::page
