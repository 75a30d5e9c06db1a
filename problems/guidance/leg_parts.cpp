#include "problems/guidance/leg_parts.hpp"

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

void add_dyads(const MotionProblem& problem, const DyadSolutions& found, Leg& leg) {
  for (const GuidingDyad& dyad : found.dyads()) {
    if (allows(problem, dyad.kind)) {
      leg.choices.push_back({dyad});
    } else {
      leg.notes.push_back(fmt::format(
          "A dyad {} is left out, which mechanism.dyads does not allow.", to_string(dyad.kind)));
    }
  }
}

Leg listed(const MotionProblem& problem, const DyadSolutions& found, const std::string& what) {
  Leg leg;
  add_dyads(problem, found, leg);
  if (found.status != GuidanceStatus::found) {
    leg.notes.push_back(what + ": " + as_sentence(sentence(found.status)));
  }
  return leg;
}

double along(double parameter) {
  return std::tan(parameter * kRightAngle);
}

void add_grid(int side, const LegPlace& place, const LegPlace& step, Leg& leg) {
  const double width = 3.0 / side;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      LegPlace at = place, steps = step;
      at[0] = -1.5 + width * (i + 0.45);
      at[1] = -1.5 + width * (j + 0.55);
      steps[0] = steps[1] = width;
      if (const auto dyad = leg.dyad_at(at)) leg.choices.push_back({*dyad, at, steps});
    }
  }
}

}  // namespace cognate::problems
