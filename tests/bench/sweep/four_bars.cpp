/// Prints, as markdown, how many four-bars a study goes through in a second on one thread: each of
/// the stages of its evaluation against the bare batch kernel and the bare closed form of this run.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "analysis/batch/four_bar_batch.hpp"
#include "analysis/coupler_curve/curve_measures.hpp"
#include "problems/study/four_bar_study.hpp"

namespace cognate::bench {
namespace {

using problems::Study;
using problems::StudyFilter;
using problems::StudyVariable;

constexpr std::int64_t kBlock = 8192;
constexpr double kSeconds = 0.4;  ///< of each measurement

/// Nanoseconds of processor time, which other programs hardly change, for each of the `count`
/// designs of a call: the least of some calls.
double nanoseconds(std::int64_t count, const std::function<void(std::int64_t call)>& body) {
  double best = INFINITY, spent = 0;
  for (std::int64_t call = 0; call < 3 || spent < kSeconds; ++call) {
    const std::clock_t begin = std::clock();
    body(call);
    const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    spent += taken;
    best = std::min(best, taken);
  }
  return 1e9 * best / static_cast<double>(count);
}

constexpr const char* kBase = R"(
kind = "analysis"
[mechanism]
type = "four-bar"
fixed_pivots = [[0, 0], [3, 0]]
crank = 1.0
coupler = 3.0
rocker = 2.5
coupler_point = [1, 1]
)";

StudyVariable grid(const std::string& key, problems::KeyPath path, double from, double to,
                   int steps) {
  StudyVariable variable{key, std::move(path), {}, std::nullopt, false};
  for (int i = 0; i < steps; ++i) {
    variable.values.push_back(from + (to - from) * i / (steps - 1));
  }
  return variable;
}

/// Crank-rockers and double-rockers, crank 1, with points about the coupler.
Study study(std::vector<std::string> metrics, std::vector<StudyFilter> filters) {
  Study study;
  study.base_text = kBase;
  const std::size_t zero = 0, one = 1;
  study.variables = {grid("frame", {"mechanism", "fixed_pivots", one, zero}, 1.517, 5.5, 16),
                     grid("rocker", {"mechanism", "rocker"}, 1.513, 5.5, 16),
                     grid("coupler", {"mechanism", "coupler"}, 1.511, 5.5, 16),
                     grid("u", {"mechanism", "coupler_point", zero}, -2.03, 5, 16),
                     grid("v", {"mechanism", "coupler_point", one}, -3.01, 3, 16)};
  study.metrics = std::move(metrics);
  study.filters = std::move(filters);
  return study;
}

StudyFilter turning() {
  StudyFilter filter;
  filter.name = "class";
  filter.words = {"crank-rocker"};
  return filter;
}

StudyFilter from_to(const std::string& name, double min, double max) {
  StudyFilter filter;
  filter.name = name;
  filter.min = min;
  filter.max = max;
  return filter;
}

struct Bare {
  double kernel, closed_form;
};

/// Positions and velocities of 64 linkages at the steps with which curves begin.
double bare_kernel() {
  constexpr std::size_t kDesigns = 64, kRows = kCurveSteps[0];
  const auto table = CrankTable<double>::full_turn(kRows);
  const std::vector<double> zero(kDesigns, 0), frame(kDesigns, 3), crank(kDesigns, 1),
      coupler(kDesigns, 3), rocker(kDesigns, 2.5);
  CurveRoom out;
  out.resize(kDesigns * kRows);
  return nanoseconds(1024 * kDesigns, [&](std::int64_t) {
    for (int k = 0; k < 1024; ++k) {
      const auto status = evaluate_batch<double>(
          {zero, zero, frame, zero, crank, coupler, rocker, crank, crank, crank}, table,
          {.x = out.x, .y = out.y, .velocity_x = out.dx, .velocity_y = out.dy});
      if (status != BatchStatus::done) std::abort();
    }
  });
}

/// Least and greatest transmission angle by the law of cosines, and their filter.
double bare_closed_form() {
  constexpr std::size_t kDesigns = kBlock;
  std::vector<double> l1(kDesigns, 1), l2(kDesigns, 3), l3(kDesigns, 2.5), l4(kDesigns),
      stays(kDesigns);
  for (std::size_t i = 0; i < kDesigns; ++i) l4[i] = 2 + 1e-4 * static_cast<double>(i);
  return nanoseconds(64 * kDesigns, [&](std::int64_t call) {
    const double bound = 0.7 + 1e-3 * static_cast<double>(call % 7);
    for (int k = 0; k < 64; ++k) {
      for (std::size_t i = 0; i < kDesigns; ++i) {
        const double near = std::max(std::abs(l4[i] - l1[i]), std::abs(l2[i] - l3[i]));
        const double far = std::min(l4[i] + l1[i], l2[i] + l3[i]);
        const double inverse = 0.5 / (l2[i] * l3[i]), squares = l2[i] * l2[i] + l3[i] * l3[i];
        const double open = (squares - near * near) * inverse;
        const double closed = (squares - far * far) * inverse;
        stays[i] += open <= bound && -closed <= bound ? 1.0 : 0.0;
      }
    }
  });
}

void print(const char* name, const Study& study, const Bare& bare) {
  const auto evaluator = problems::four_bar_evaluator(study, 1, nullptr);
  if (!evaluator) std::abort();
  const std::int64_t count = problems::design_count(study), blocks = count / kBlock;
  std::size_t kept = 0;
  // Blocks spread over the study, so that every call has all kinds of designs.
  constexpr std::int64_t kBlocks = 16;
  const double each = nanoseconds(kBlocks * kBlock, [&](std::int64_t) {
    kept = 0;
    for (std::int64_t k = 0; k < kBlocks; ++k) {
      const auto block = (*evaluator)(k * blocks / kBlocks * kBlock, kBlock);
      kept += block->ids.size();
    }
  });
  const double share = static_cast<double>(kept) / static_cast<double>(kBlocks * kBlock);
  fmt::print("| {} | {:.0f} % | {:.1f} | {:.0f} | {:.2f} | {:.1f} |\n", name, 100 * share, each,
             1e9 / each, each / bare.kernel, each / bare.closed_form);
}

void run() {
  const Bare bare{bare_kernel(), bare_closed_form()};
  fmt::print(
      "Bare kernel, {} positions and velocities of a design: {:.1f} ns. Bare closed form, "
      "both extreme transmission angles: {:.2f} ns.\n\n",
      kCurveSteps[0], bare.kernel, bare.closed_form);
  fmt::print(
      "| study | kept | ns/design | designs/s | of the kernel | of the closed form |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: |\n");
  const auto sharp = from_to("transmission_angle_deg.acute_min", 50, 90);
  const auto none = from_to("transmission_angle_deg.acute_min", 89, 90);
  print("a filter that none passes", study({"time_ratio"}, {none}), bare);
  print("acute_min >= 50", study({"transmission_angle_deg.acute_min"}, {sharp}), bare);
  print("crank-rockers, angles and time ratio",
        study({"transmission_angle_deg.acute_min", "time_ratio"}, {turning()}), bare);
  const auto curve = [&](const char* name, const char* metric) {
    print(name, study({metric}, {turning()}), bare);
  };
  curve("crank-rockers, length", "curve_length");
  curve("crank-rockers, widths", "curve_width_min");
  curve("crank-rockers, descriptors", "fourier.p1");
  curve("crank-rockers, straight stretches", "straight_length_at_0_01");
  curve("crank-rockers, features", "double_points");
  print("features of those with acute_min >= 50 and length <= 7",
        study({"double_points"}, {turning(), sharp, from_to("curve_length", 0, 7)}), bare);
}

}  // namespace
}  // namespace cognate::bench

int main() {
  cognate::bench::run();
}
