/// The accuracy of the four-bar's closure and of the common formulas, against 113 bits.
///
///     closure_accuracy [--samples N] [--seed N] [--csv FILE]
///
/// prints a Markdown table, one row for each family of configurations and form, and writes the same
/// numbers for each distance from the singular configuration as comma-separated values.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <string>

#include "tests/stress/accuracy_table.hpp"
#include "tests/stress/batch_accuracy.hpp"
#include "tests/stress/closure_families.hpp"

namespace cognate::stress {
namespace {

using AllForms = std::array<Accuracy, kForms.size()>;

AllForms measure(const Family& family, double distance, int samples, std::mt19937_64& random) {
  AllForms accuracy;
  for (int i = 0; i < samples; ++i) {
    const Configuration at = family.draw(distance, random);
    const ExactClosure exact = exact_closure(at);
    for (std::size_t k = 0; k < kForms.size(); ++k) {
      accuracy[k].include(at, exact, kForms[k].evaluate(at));
    }
  }
  return accuracy;
}

std::string csv_row(const Family& family, double distance, std::string_view form,
                    const Accuracy& a) {
  return fmt::format("\"{}\",\"{}\",{},\"{}\",{},{},{},{},{},{},{},{}\n", family.name,
                     family.distance_is, distance, form, a.error, a.well_conditioned,
                     a.per_condition, a.condition, a.closed, a.total, a.wrong_flags,
                     a.wrong_flag_distance);
}

/// Coupler points in batches, on each instruction set of this machine; ε is 2⁻²⁴ for float.
std::string batch_table(int samples, unsigned seed) {
  const auto families = closure_families();
  std::string table = table_head("batch");
  for (std::size_t k = 0; k < 3; ++k) {
    for (const InstructionSet set : instruction_sets()) {
      const auto row = [&](std::string_view real, const Accuracy& accuracy) {
        table += table_row(families[k].name, fmt::format("{}, {}", name(set), real), accuracy);
      };
      row("double", batch_accuracy<double>(families[k], set, samples / 16, seed));
      row("float", batch_accuracy<float>(families[k], set, samples / 16, seed));
    }
  }
  return table;
}

void run(int samples, unsigned seed, const std::string& csv_file) {
  std::string csv =
      "family,distance_is,distance,form,error_eps,well_conditioned_eps,per_condition,condition,"
      "closed,total,"
      "wrong_flags,wrong_flag_distance_eps\n";
  std::string table = table_head("form");
  std::mt19937_64 random(seed);
  for (const Family& family : closure_families()) {
    AllForms worst;
    // As many configurations for a family without distances as for one with many.
    const int each = samples / static_cast<int>(family.distances.size());
    for (const double distance : family.distances) {
      const AllForms here = measure(family, distance, each, random);
      for (std::size_t k = 0; k < kForms.size(); ++k) {
        worst[k].include(here[k]);
        csv += csv_row(family, distance, kForms[k].name, here[k]);
      }
    }
    for (std::size_t k = 0; k < kForms.size(); ++k) {
      table += table_row(k == 0 ? family.name : "", kForms[k].name, worst[k]);
    }
  }
  fmt::print("{}\n{}", table, batch_table(samples, seed));
  if (!csv_file.empty()) std::ofstream(csv_file) << csv;
}

}  // namespace
}  // namespace cognate::stress

int main(int argc, char** argv) {
  CLI::App app("Errors of the four-bar's closure in units of 2^-53, against 113 bits and more");
  int samples = 20000;
  unsigned seed = 1;
  std::string csv_file;
  app.add_option("--samples", samples, "Configurations in each family")->check(CLI::PositiveNumber);
  app.add_option("--seed", seed, "Of the random numbers");
  app.add_option("--csv", csv_file, "Where to write the numbers for each distance");
  CLI11_PARSE(app, argc, argv);
  cognate::stress::run(samples, seed, csv_file);
}
