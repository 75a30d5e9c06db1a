#include "problems/guidance/dyad_options.hpp"

#include <fmt/core.h>

#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"

namespace cognate::problems {

using synthesis::DyadSolutions;
using synthesis::GuidanceStatus;
using synthesis::GuidingDyad;

std::string as_sentence(std::string_view text) {
  std::string sentence(text);
  if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z') {
    sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
  }
  return sentence + '.';
}

void add_dyads(const MotionProblem& problem, const DyadSolutions& found, DyadChoices& options) {
  for (const GuidingDyad& dyad : found.dyads()) {
    if (allows(problem, dyad.kind)) {
      options.choices.push_back({dyad});
    } else {
      options.notes.push_back(fmt::format(
          "A dyad {} is left out, which mechanism.dyads does not allow.", to_string(dyad.kind)));
    }
  }
}

DyadChoices listed(const MotionProblem& problem, const DyadSolutions& found,
                   const std::string& what) {
  DyadChoices options;
  add_dyads(problem, found, options);
  if (found.status != GuidanceStatus::found) {
    options.notes.push_back(what + ": " + as_sentence(sentence(found.status)));
  }
  return options;
}

double along(double parameter) {
  return std::tan(parameter * kRightAngle);
}

void add_grid(int side, const DyadPlace& place, const DyadPlace& step, DyadChoices& options) {
  const double width = 3.0 / side;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      DyadPlace at = place, steps = step;
      at[0] = -1.5 + width * (i + 0.45);
      at[1] = -1.5 + width * (j + 0.55);
      steps[0] = steps[1] = width;
      if (const auto dyad = options.dyad_at(at)) options.choices.push_back({*dyad, at, steps});
    }
  }
}

}  // namespace cognate::problems
