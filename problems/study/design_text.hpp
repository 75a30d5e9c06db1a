/// @file The base file of a study as a text with gaps.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "problems/study/study.hpp"

namespace cognate::problems {

/// A text in which numbers can be replaced: piece, number, piece, …, piece.
struct GappedText {
  std::vector<std::string> pieces;    ///< one more than there are gaps
  std::vector<std::size_t> variable;  ///< of each gap: the index in `study.variables`
};

/// The base file of `study`, its varied numbers left out.
GappedText gapped_base(const Study& study);

/// The base file with the numbers of a design, one for each variable, each written so that it reads
/// back as the same double.
std::string design_text(const Study& study, std::span<const double> values);

}  // namespace cognate::problems
