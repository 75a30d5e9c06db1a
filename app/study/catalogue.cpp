#include "app/study/catalogue.hpp"

namespace cognate::app {
namespace {

constexpr Entry kFile[] = {
    {"kind", "\"study\"; may be left out"},
    {"title", "of the study"},
    {"base", "the problem or mechanism file whose numbers vary, relative to this one"}};

constexpr Entry kVary[] = {
    {"key",
     "the place of a number of the base: \"mechanism.crank\", \"target.points[2][0]\", entries "
     "counted from 0"},
    {"range", "[a, b], with steps, or with sampling and count"},
    {"steps", "how many values, in equal steps, both ends included"},
    {"values", "or: these, [x, ...]"},
    {"sampling", "one of the samplings below, the same for all variables that are sampled"},
    {"count", "how many samples, the same for all of these"},
    {"scale", "of a range: \"linear\" (default), or \"log\": steps or samples of the logarithm"}};

constexpr Entry kOutput[] = {
    {"metrics", "names of 'cognate list --metrics', or places in a design of the result document"},
    {"rows", "\"passed\" (default): those that pass the filters, or \"all\""}};

constexpr Entry kFilter[] = {
    {"METRIC or KEY",
     "[min, max], {min = x}, {max = x}; of words \"a\", [\"a\", \"b\"], true, "
     "false"}};

constexpr Entry kObjective[] = {
    {"minimize, maximize", "a metric or varied key, or a list of them: a Pareto front"}};

constexpr KeyedEntry kTables[] = {
    {"the file", "numbers of a base file vary; cognate sweep runs all designs", kFile},
    {"[[vary]]", "a number of the base", kVary},
    {"[output]", "what rows hold besides what varies", kOutput},
    {"[filter]", "which rows are kept", kFilter},
    {"[objective]", "which rows are best", kObjective}};

constexpr Entry kSamplings[] = {
    {"sobol", "Sobol's sequence, shifted at random by --seed (0: as published); best with 2^k"},
    {"halton", "Halton's sequence, its digits permuted at random by --seed (0: as published)"},
    {"latin", "a Latin hypercube: of count equal parts of every range each holds one sample"},
    {"random", "independent and uniform"}};

}  // namespace

std::span<const KeyedEntry> study_tables() {
  return kTables;
}

std::span<const Entry> samplings() {
  return kSamplings;
}

}  // namespace cognate::app
