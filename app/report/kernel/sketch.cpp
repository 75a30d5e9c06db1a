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
#include "problems/chain/topology.hpp"
#include "problems/function/problem.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/path/problem.hpp"
#include "problems/straight_line/problem.hpp"

namespace cognate::page {
namespace {

using problems::reading::Table;

/// What stands under a key; null where that is none, or of another type.
template <class Value>
const Value* value_in(const Table& table, std::string_view key) {
  const auto entry = std::ranges::find(table, key, &problems::reading::Entry::key);
  return entry == table.end() ? nullptr : std::get_if<Value>(&entry->node.value);
}

/// The word under a key; empty where there is none.
std::string_view word_in(const Table& table, std::string_view key) {
  const auto* word = value_in<std::string>(table, key);
  return word ? std::string_view(*word) : std::string_view();
}

/// Whether the mechanism of a document is a slider-crank.
bool slides(const Table& document) {
  const auto* mechanism = value_in<Table>(document, "mechanism");
  return mechanism && word_in(*mechanism, "type") == problems::kSliderCrankWord;
}

nlohmann::ordered_json answer_to_path(const SketchQuestion& asked) {
  return slides(asked.document) ? sketched_slider_cranks(asked) : sketched_paths(asked);
}

}  // namespace

/// Solves the problem in the text and the block of numbers. The answer is `designs`, or `values`
/// of an expression, or `faults`, a list of sentences.
COGNATE_EXPORT(sketch) int sketch_text(int seed) {
  const auto document = document_of(question());
  const SketchQuestion asked{document, static_cast<std::uint64_t>(seed)};
  const std::string_view kind = word_in(document, "kind");
  using problems::KindTraits;
  if (kind == KindTraits<problems::PathProblem>::kWord) return answer_with(answer_to_path(asked));
  if (kind == KindTraits<problems::MotionProblem>::kWord) {
    return answer_with(sketched_motions(asked));
  }
  if (kind == KindTraits<problems::FunctionProblem>::kWord) {
    return answer_with(sketched_functions(asked));
  }
  if (kind == KindTraits<problems::StraightLineProblem>::kWord) {
    return answer_with(sketched_lines(asked));
  }
  if (kind == kFunctionValues) return answer_with(function_values(asked));
  problems::reading::FaultList faults;
  faults.add({},
             "kind is none of \"path-generation\", \"motion-generation\", "
             "\"function-generation\" and \"straight-line\"");
  return answer_with(faults_json(std::move(faults)));
}

}  // namespace cognate::page
