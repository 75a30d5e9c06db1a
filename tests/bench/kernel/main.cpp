/// Prints the time of one position of a four-bar, as markdown: by instruction set, number type and
/// layout, against the textbook's form and against the units for roots and divisions; then what
/// more than positions costs; then what a second thread brings.
#include <fmt/core.h>

#include <charconv>
#include <fstream>
#include <memory>
#include <random>
#include <string_view>
#include <system_error>

#include "analysis/batch/four_bar_batch.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/bench/kernel/measure.hpp"
#include "tests/bench/kernel/references.hpp"

namespace cognate::bench {
namespace {

constexpr std::size_t kRows = 1024;    // of one design: all columns in the first cache
constexpr std::size_t kDesigns = 256;  // of many, over kSweep rows
constexpr std::size_t kSweep = 10;
constexpr std::size_t kPoints = 16;  // of kPointDesigns designs
constexpr std::size_t kPointDesigns = 64;

const FourBar kLinkage{.pivot_a = {1, 2},
                       .pivot_d = {4, 3},
                       .crank = 1,
                       .coupler = 2.9,
                       .rocker = 2.4,
                       .coupler_point = Vec2d{1.5, 0.8}};

std::vector<double> full_turn(std::size_t count) {
  std::vector<double> angles(count);
  for (std::size_t i = 0; i < count; ++i) {
    angles[i] = kTurn * static_cast<double>(i) / static_cast<double>(count);
  }
  return angles;
}

/// Crank-rockers with `points` coupler points each.
template <class Real>
struct Designs {
  std::vector<Real> values[8], u, v;

  Designs(std::size_t count, std::size_t points) : u(count * points), v(count * points) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> place(-1, 1), link(2.5, 3.5);
    for (auto& one : values) one.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = place(random), y = place(random);
      const double all[8] = {x,
                             y,
                             x + link(random),
                             y + 0.2 * place(random),
                             1,
                             link(random),
                             link(random),
                             i % 2 ? 1.0 : -1.0};
      for (std::size_t k = 0; k < 8; ++k) values[k][i] = static_cast<Real>(all[k]);
    }
    for (Real& one : u) one = static_cast<Real>(place(random));
    for (Real& one : v) one = static_cast<Real>(place(random));
  }

  FourBarArrays<Real> arrays() const {
    return {values[0], values[1], values[2], values[3], values[4],
            values[5], values[6], values[7], u,         v};
  }
};

/// Buffers for all columns of `size` values each: they begin with a cache line, and not with the
/// same line of a page, so that columns do not drive each other out of the cache.
template <class Real>
struct Buffers {
  std::vector<std::unique_ptr<Real[], void (*)(void*)>> owned;
  std::vector<std::span<Real>> columns;

  explicit Buffers(std::size_t size) {
    constexpr std::size_t line = 64, line_values = line / sizeof(Real);
    for (std::size_t i = 0; i < 27; ++i) {
      const std::size_t bytes = (size * sizeof(Real) + 27 * line) / line * line + line;
      owned.emplace_back(static_cast<Real*>(std::aligned_alloc(4096, (bytes + 4095) / 4096 * 4096)),
                         std::free);
      columns.push_back(std::span(owned.back().get() + i * line_values, size));
      std::fill(columns.back().begin(), columns.back().end(), Real(0));
    }
  }

  FourBarColumns<Real> positions() { return {.x = columns[0], .y = columns[1]}; }
  FourBarColumns<Real> velocities() {
    auto all = positions();
    all.velocity_x = columns[2];
    all.velocity_y = columns[3];
    return all;
  }
  FourBarColumns<Real> accelerations() {
    auto all = velocities();
    all.acceleration_x = columns[4];
    all.acceleration_y = columns[5];
    return all;
  }
  FourBarColumns<Real> curvatures() {
    auto all = accelerations();
    all.curvature = columns[6];
    return all;
  }
  FourBarColumns<Real> transmissions(FourBarColumns<Real> all) {
    all.transmission_sin = columns[7];
    all.transmission_cos = columns[8];
    return all;
  }
  FourBarColumns<Real> gradients(FourBarColumns<Real> all) {
    for (std::size_t i = 0; i < kDesignVariables; ++i) {
      all.gradient_x[i] = columns[9 + i];
      all.gradient_y[i] = columns[18 + i];
    }
    return all;
  }
};

void require(BatchStatus status) {
  if (status != BatchStatus::done) std::abort();
}

template <class Linkages, class Real>
Case batch_case(const Linkages& linkages, const CrankTable<Real>& cranks,
                const FourBarColumns<Real>& columns, std::size_t items, InstructionSet set,
                int threads = 1) {
  return {.items = static_cast<double>(items), .run = [=, &cranks] {
            require(evaluate_batch(linkages, cranks, columns,
                                   {.threads = threads, .instruction_set = set}));
          }};
}

BoundKernel bound_of(InstructionSet set, bool is_double) {
  switch (set) {
#ifdef COGNATE_X86_KERNELS
    case InstructionSet::sse2:
      return is_double ? sse2::bound_double : sse2::bound_float;
    case InstructionSet::avx2:
      return is_double ? avx2::bound_double : avx2::bound_float;
    case InstructionSet::avx512:
      return is_double ? avx512::bound_double : avx512::bound_float;
#endif
    default:
      return is_double ? scalar::bound_double : scalar::bound_float;
  }
}

template <class Real>
void print_positions(const char* type, int rounds) {
  const CrankTable<Real> turn(full_turn(kRows)), sweep(full_turn(kSweep));
  const std::vector<double> angles = full_turn(kRows);
  const std::vector<Real> real_angles(angles.begin(), angles.end());
  const Designs<Real> many(kDesigns, 1), pointed(kPointDesigns, kPoints);
  Buffers<Real> out(kPointDesigns * kSweep * kPoints);
  auto columns = [&](std::size_t size) {
    return FourBarColumns<Real>{.x = out.columns[0].first(size), .y = out.columns[1].first(size)};
  };
  std::vector<Case> cases{{.items = kRows, .run = [&] {
                             textbook<Real>(kLinkage, real_angles, out.columns[0], out.columns[1]);
                           }}};
  std::vector<Real> ones(kRows, Real(1.7));
  for (const InstructionSet set : instruction_sets()) {
    const BoundKernel bound = bound_of(set, sizeof(Real) == 8);
    cases.push_back({.items = kRows, .run = [&, bound] {
                       bound(ones.data(), ones.data(), out.columns[2].data(), kRows);
                     }});
    cases.push_back(batch_case(kLinkage, turn, columns(kRows), kRows, set));
    cases.push_back(
        batch_case(many.arrays(), sweep, columns(kDesigns * kSweep), kDesigns * kSweep, set));
    const std::size_t all = kPointDesigns * kSweep * kPoints;
    cases.push_back(batch_case(pointed.arrays(), sweep, columns(all), all, set));
  }
  measure(cases, rounds);
  const double book = cases[0].nanoseconds;
  std::size_t at = 1;
  for (const InstructionSet set : instruction_sets()) {
    const double bound = cases[at].nanoseconds, one = cases[at + 1].nanoseconds;
    fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} | {:.0f} |\n", type,
               name(set), one, cases[at + 2].nanoseconds, cases[at + 3].nanoseconds, bound,
               one / bound, book, book / one);
    at += 4;
  }
}

template <class Real>
void print_ladder(const char* type, int rounds) {
  const CrankTable<Real> turn(full_turn(kRows)), sweep(full_turn(kSweep));
  const std::size_t count = kDesigns * kSweep / 2;
  const Designs<Real> many(kDesigns / 2, 1);
  for (const bool one_design : {true, false}) {
    Buffers<Real> out(one_design ? kRows : count);
    const FourBarColumns<Real> none{};
    const std::pair<const char*, FourBarColumns<Real>> rungs[] = {
        {"position", out.positions()},
        {"velocity", out.velocities()},
        {"acceleration", out.accelerations()},
        {"curvature", out.curvatures()},
        {"position, transmission", out.transmissions(out.positions())},
        {"transmission alone", out.transmissions(none)},
        {"position, gradient", out.gradients(out.positions())},
        {"all", out.gradients(out.transmissions(out.curvatures()))}};
    std::vector<Case> cases;
    for (const InstructionSet set : instruction_sets()) {
      for (const auto& [rung, columns] : rungs) {
        Case one = one_design ? batch_case(kLinkage, turn, columns, kRows, set)
                              : batch_case(many.arrays(), sweep, columns, count, set);
        cases.push_back(one);
      }
    }
    measure(cases, rounds);
    for (std::size_t i = 0; i < cases.size(); i += std::size(rungs)) {
      fmt::print("| {} | {} | {} |", type, name(instruction_sets()[i / std::size(rungs)]),
                 one_design ? "one design" : "many designs");
      fmt::print(" {:.2f} ns |", cases[i].nanoseconds);
      for (std::size_t k = 1; k < std::size(rungs); ++k) {
        fmt::print(" {:.2f} |", cases[i + k].nanoseconds / cases[i].nanoseconds);
      }
      fmt::print("\n");
    }
  }
}

void print_threads(int rounds) {
  // Enough work for the start of a thread not to count, few enough results for the second cache.
  constexpr std::size_t designs = 2048, rows = 64;
  const CrankTable<double> sweep(full_turn(rows));
  const Designs<double> many(designs, 1);
  Buffers<double> out(designs * rows);
  const FourBarColumns<double> curvature{.curvature = out.columns[0]};
  std::vector<Case> cases;
  for (const int threads : {1, 2}) {
    cases.push_back(batch_case(many.arrays(), sweep, curvature, designs * rows,
                               instruction_sets().back(), threads));
  }
  measure(cases, rounds, 2e-3);
  fmt::print("{:.2f} ns a position with one thread, {:.2f} with two: {:.2f} times as fast.\n",
             cases[0].nanoseconds, cases[1].nanoseconds,
             cases[0].nanoseconds / cases[1].nanoseconds);
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

}  // namespace
}  // namespace cognate::bench

int main(int argc, char** argv) {
  using namespace cognate::bench;
  const std::string_view given = argc > 1 ? argv[1] : "200";
  int rounds = 0;
  const auto read = std::from_chars(given.data(), given.data() + given.size(), rounds);
  if (argc > 2 || read.ec != std::errc() || read.ptr != given.data() + given.size() || rounds < 1) {
    fmt::print("Usage: kernel_bench [ROUNDS]; a whole number from 1 on, 200 by default\n");
    return argc == 2 && given == "--help" ? 0 : 2;
  }
  fmt::print("{}, {}, least of {} rounds\n\n", processor(), COGNATE_COMPILER, rounds);
  fmt::print("Nanoseconds for one position (coupler point with validity):\n\n");
  fmt::print(
      "| type | instructions | one design, {} cranks | {} designs, {} cranks | {} points of {} "
      "designs, {} cranks | root + division | one design ÷ root + division | textbook | "
      "textbook ÷ one design |\n|---|---|---|---|---|---|---|---|---|\n",
      kRows, kDesigns, kSweep, kPoints, kPointDesigns, kSweep);
  print_positions<double>("double", rounds);
  print_positions<float>("float", rounds);
  fmt::print("\nWhat more costs, as ratios to positions (each rung with those before it):\n\n");
  fmt::print(
      "| type | instructions | layout | position | velocity | acceleration | curvature | "
      "position, transmission | transmission alone | position, gradient | all |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n");
  print_ladder<double>("double", rounds);
  print_ladder<float>("float", rounds);
  fmt::print("\nCurvature of 2048 designs at 64 cranks: ");
  print_threads(rounds);
  return 0;
}
