// libFuzzer on the design of cams: any file that is read is solved, its numbers are
// finite, and the curves of its cams can be drawn.
//
//   build/fuzz/tests/fuzz/cam_fuzz -dict=build/fuzz/read.dict -max_len=2000 CORPUS
//       problems/library/cam

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "problems/cam/result.hpp"
#include "problems/read.hpp"
#include "tests/fuzz/drawn_cam.hpp"
#include "tests/fuzz/sound_cam.hpp"

namespace {

using cognate::problems::CamDesign;
using cognate::problems::CamResult;
using cognate::problems::Run;

constexpr double kSeconds = 0.1;  // of a search, which is made to stop wherever it is
constexpr int kStarts = 1;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  auto problem = cognate::problems::parse_task<cognate::problems::CamProblem>(text);
  if (!problem) return 0;
  if (!is_sound(*problem)) std::abort();
  if (problem->solve.starts) problem->solve.starts = kStarts;
  Run run;
  run.threads = 1;
  run.time_limit = kSeconds;
  const CamResult result = solve(*problem, run);
  for (const CamDesign& design : result.designs) {
    if (!is_sound(*problem, design) || !is_drawn(*problem, design)) std::abort();
  }
  return 0;
}
