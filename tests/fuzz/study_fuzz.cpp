// libFuzzer on the reader of studies: for any bytes, a study of which any design has numbers
// and a text, or one to a hundred faults. The base is that of the library.
//
//   cmake --build build/fuzz --target study_fuzz
//   cd problems/library/study && .../study_fuzz -dict=.../build/fuzz/read.dict CORPUS .

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "problems/study/base.hpp"
#include "problems/study/design_points.hpp"
#include "problems/study/design_text.hpp"
#include "problems/study/read.hpp"

namespace {

using cognate::problems::MetricNames;
using cognate::problems::Study;
using cognate::problems::Task;

void require(bool holds) {
  if (!holds) std::abort();
}

MetricNames names(const Task&) {
  return {{{"time_ratio"}, {"output_swing_deg"}, {"class", true}}, {"mechanism.crank", "error"}};
}

// The numbers of a design lie in their ranges, and its text gives the same problem as they do
// directly.
void check(const Study& study) {
  const auto count = design_count(study);
  require(count >= 1 && count <= 1'000'000'000'000);
  for (const std::int64_t id : {std::int64_t{0}, count / 2, count - 1}) {
    std::vector<double> values(study.variables.size());
    cognate::problems::DesignPoints(study, 1).fill(id, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto& range = study.variables[i].range;
      require(std::isfinite(values[i]));
      require(!range || (values[i] >= range->min && values[i] <= range->max));
    }
    const auto direct = cognate::problems::StudyBase(study).with(values);
    const auto read = cognate::problems::parse_task(design_text(study, values));
    require(direct.has_value() || !read.has_value());  // a text alone finds no file beside it
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto study = cognate::problems::parse_study(text, ".", names);
  if (study) {
    check(*study);
    return 0;
  }
  require(!study.error().empty() && study.error().size() <= 100);
  for (const auto& fault : study.error()) {
    require(fault.line >= 1 && fault.column >= 1);
    require(fault.message.find("; ") != std::string::npos);
  }
  return 0;
}
