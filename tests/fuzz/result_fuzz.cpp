// libFuzzer on the reader of result files: for any bytes, a cam whose curves can be drawn, or
// a message that says what is wrong and what is requested.
//
//   build/fuzz/tests/fuzz/result_fuzz -max_len=4000 CORPUS
//
// where CORPUS holds results of problems/library/cam.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "app/export/result_cam.hpp"
#include "tests/fuzz/drawn_cam.hpp"
#include "tests/fuzz/sound_cam.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto check = [](const std::string& message) {
    if (!message.starts_with("r:") || message.find("; ") == std::string::npos) std::abort();
    return 0;
  };
  const auto given = cognate::app::parse_result_design(text, 1, "r");
  if (!given) return check(given.error());
  const auto cam = cognate::app::result_cam(*given);
  if (!cam) return check(cam.error());
  const auto& [problem, design] = *cam;
  if (!is_sound(problem) || !is_drawn(problem, design)) std::abort();
  return 0;
}
