// A study of documents: a problem file's text with other numbers in it, each read, checked and
// evaluated. Faults of a file are reported with their place.
#include <algorithm>
#include <cmath>
#include <cognate/evaluation.hpp>
#include <cognate/files.hpp>
#include <cstdio>
#include <string>

namespace problems = cognate::problems;

// The stroke of a centric slider-crank is twice its crank.
int main() {
  for (const std::string crank : {"1", "1.5", "-2"}) {
    const auto problem = problems::parse_task<problems::AnalysisProblem>(R"(
      kind = "analysis"
      [mechanism]
      type = "slider-crank"
      coupler = 5
      crank = )" + crank);
    if (!problem) {
      for (const auto& [line, column, message] : problem.error()) {
        std::printf("%zu:%zu: %s\n", line, column, message.c_str());
      }
      continue;
    }
    const problems::AnalysisResult result = analyse(*problem, {});
    const auto place = std::ranges::find(result.columns, "C_x", &problems::Column::name);
    const auto [least, greatest] = std::ranges::minmax(place->values);
    std::printf("crank %s: stroke %.6f\n", crank.c_str(), greatest - least);
  }
}

// crank 1: stroke 2.000000
// crank 1.5: stroke 3.000000
// 6:15: mechanism.crank is -2; expected a length from 1e-30 to 1e30
