/// @file What exact synthesis of function generators gives, as designs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// All real solutions for given starts: those that are mechanisms as designs, in no order, the
/// others as sentences.
struct ExactDesigns {
  bool dependent = false;     ///< the conditions leave more than points
  std::size_t solutions = 0;  ///< real ones, mechanisms or not
  std::vector<Design> designs;
  std::vector<std::string> notes;
};

/// The mechanisms of the problem's type through `wanted.precision`, whose conditions must be three
/// and the number of starts not given. `start` holds the starts of the file or those chosen in a
/// family, which need not be the file's.
ExactDesigns exact_designs(const FunctionProblem& problem, const FunctionSamples& wanted,
                           const synthesis::GivenStart& start);

/// The same for each type.
ExactDesigns exact_four_bars(const FunctionProblem& problem, const FunctionSamples& wanted,
                             const synthesis::GivenStart& start);
ExactDesigns exact_slider_cranks(const FunctionProblem& problem, const FunctionSamples& wanted,
                                 const synthesis::GivenStart& start);

/// "three", "four" or "five", how many conditions there are.
std::string count_word(std::size_t count);

/// What is to be met, in words: "five pairs", or "five conditions" of a function or with
/// derivatives.
std::string conditions_in_words(const FunctionSamples& wanted);

/// Puts a sentence at the end unless it stands there already.
void note_once(std::vector<std::string>& notes, std::string sentence);

}  // namespace cognate::problems
