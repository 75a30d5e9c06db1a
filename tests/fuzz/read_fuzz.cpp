// libFuzzer on the reader: for any bytes, a problem whose function can be called anywhere on
// its domain, a mechanism that can be evaluated, or one to a hundred faults.
//
//   cmake -B build/fuzz -G Ninja -DCMAKE_CXX_COMPILER=clang++-19 -DCOGNATE_BUILD_FUZZERS=ON
//   cmake --build build/fuzz --target read_fuzz
//   tests/fuzz/dictionary.py build/release/app/cognate > build/fuzz/read.dict
//   build/fuzz/tests/fuzz/read_fuzz -dict=build/fuzz/read.dict CORPUS problems/library/path
//       problems/library/function problems/library/analysis
//       problems/library/cam problems/library/machine problems/library/gear
//       problems/library/gear-pair problems/library/gear-train

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <variant>

#include "problems/read.hpp"
#include "tests/fuzz/sound_analysis.hpp"
#include "tests/fuzz/sound_cam.hpp"
#include "tests/fuzz/sound_gear.hpp"
#include "tests/fuzz/sound_machine.hpp"

namespace {

using cognate::problems::AnalysisProblem;
using cognate::problems::CamProblem;
using cognate::problems::Fault;
using cognate::problems::FunctionOfX;
using cognate::problems::FunctionProblem;
using cognate::problems::GearPairProblem;
using cognate::problems::GearProblem;
using cognate::problems::GearTrainProblem;
using cognate::problems::MachineProblem;
using cognate::problems::PathProblem;

void require(bool holds) {
  if (!holds) std::abort();
}

void check(const PathProblem& problem) {
  const bool exact = problem.method == cognate::problems::PathMethod::exact;
  require(problem.points.size() >= (exact ? 2 : 3));
  require(exact || problem.weights.size() == problem.points.size());
  const bool timed = problem.timing != cognate::problems::Timing::free;
  require(problem.crank_angles.size() == (timed ? problem.points.size() : 0));
}

void check(const FunctionProblem& problem) {
  const bool four_bar = problem.type == cognate::problems::MechanismType::four_bar;
  require(!four_bar || problem.given.crank || problem.given.frame);
  const auto* function = std::get_if<FunctionOfX>(&problem.target);
  if (!function) return;
  const bool exact = problem.objective == cognate::problems::FunctionObjective::exact;
  require(exact || problem.sample_at.size() >= 3);
  for (const double x : problem.sample_at) require(std::isfinite(function->y(x)));
}

void check(const AnalysisProblem& problem) {
  require(is_sound(problem));
}

void check(const CamProblem& problem) {
  require(is_sound(problem));
}

void check(const GearProblem& problem) {
  require(is_sound(problem));
}

void check(const GearPairProblem& problem) {
  require(is_sound(problem));
}

void check(const GearTrainProblem& problem) {
  require(is_sound(problem));
}

void check(const MachineProblem& problem) {
  require(is_sound(problem));
}

/// Of the other kinds nothing is asked but that they are read.
template <class Other>
void check(const Other&) {}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto task = cognate::problems::parse_task(text);
  if (task) {
    std::visit([](const auto& any) { check(any); }, *task);
    return 0;
  }
  require(!task.error().empty() && task.error().size() <= 100);
  for (const Fault& fault : task.error()) {
    require(fault.line >= 1 && fault.column >= 1);
    require(fault.message.find("; ") != std::string::npos);
  }
  return 0;
}
