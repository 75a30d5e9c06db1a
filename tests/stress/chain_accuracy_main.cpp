/// The accuracy of dyads in chains near their dead points, against 113 bits.
///
///     chain_accuracy [--samples N] [--seed N]
///
/// prints a Markdown table of positions and of angular velocities.
#include <CLI/CLI.hpp>

#include "tests/stress/accuracy_table.hpp"
#include "tests/stress/chain_accuracy.hpp"
#include "tests/stress/closure_families.hpp"

namespace cognate::stress {
namespace {

void run(int samples, unsigned seed) {
  std::string table = table_head("result");
  std::mt19937_64 random(seed);
  const std::vector<double> distances = half_decades(2, 16);
  for (const ChainFamily& family : chain_families()) {
    ChainAccuracy worst;
    for (int i = 0; i < samples; ++i) {
      const double distance = distances[static_cast<std::size_t>(i) % distances.size()];
      worst.include(family.draw(distance, random));
    }
    table += table_row(family.name, "positions", worst.positions);
    table += table_row("", "angular velocities", worst.velocities);
  }
  fmt::print("{}", table);
}

}  // namespace
}  // namespace cognate::stress

int main(int argc, char** argv) {
  CLI::App app("Errors of dyads in units of 2^-53, against 113 bits and more");
  int samples = 1000;
  unsigned seed = 1;
  app.add_option("--samples", samples, "Chains of each kind")->check(CLI::PositiveNumber);
  app.add_option("--seed", seed, "Of the random numbers");
  CLI11_PARSE(app, argc, argv);
  cognate::stress::run(samples, seed);
}
