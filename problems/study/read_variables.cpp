#include "problems/study/read_variables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "problems/study/design_points.hpp"
#include "problems/study/key_path.hpp"
#include "problems/study/names.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kVary = "vary";
constexpr std::size_t kMostVariables = 100;
constexpr int kMostSteps = 1'000'000;
constexpr int kMostSamples = 1'000'000'000;
constexpr double kMostDesigns = 1e12;

constexpr std::string_view kWays =
    "expected range = [a, b] with steps = N, values = [...], or range with sampling and count";

/// How the first sampled variable is sampled, as all others must be.
struct Samples {
  Sampling sampling = Sampling::sobol;
  int count = 1;
};

bool is_positive(double x) {
  return x > 0;
}

// Whether all of `numbers` have a logarithm where one is requested; a fault at `key` where not.
bool suits_scale(TableReader& table, std::string_view key, const StudyVariable& variable,
                 std::initializer_list<double> ends, const std::vector<double>& numbers) {
  if (!variable.logarithmic) return true;
  if (std::ranges::all_of(ends, is_positive) && std::ranges::all_of(numbers, is_positive)) {
    return true;
  }
  table.fault(key, "is not all above 0; expected numbers above 0 with scale = \"log\"");
  return false;
}

std::string hint(const BaseFile& base, const std::string& key) {
  const std::vector<std::string_view> known(base.number_keys.begin(), base.number_keys.end());
  if (const auto meant = nearest(key, known)) {
    return fmt::format("did you mean {}?", in_quotes(*meant));
  }
  return "expected the place of a number of the base, as \"mechanism.crank\" or "
         "\"target.points[2][0]\"";
}

void read_key(TableReader& table, const BaseFile* base, const Study& study,
              StudyVariable& variable) {
  constexpr std::string_view kKey = "key";
  if (!table.has(kKey)) {
    table.fault(kKey,
                "is missing; expected the place of a number of the base, as "
                "\"mechanism.crank\"");
  }
  const auto key = table.text(kKey);
  if (!key) return;
  const auto path = parse_key_path(*key);
  if (!path) {
    table.fault(kKey, fmt::format("is {}, which is no place in a file; {}", in_quotes(*key),
                                  base ? hint(*base, *key) : "\"mechanism.crank\" would be one"));
    return;
  }
  variable.key = *key;
  variable.path = *path;
  if (std::ranges::find(study.variables, *key, &StudyVariable::key) != study.variables.end()) {
    table.fault(kKey, fmt::format("is {} a second time; each number varies once", in_quotes(*key)));
  }
  if (!base || std::ranges::find(base->number_keys, *key) != base->number_keys.end()) return;
  Table document = base->document;
  if (const Node* node = find_node(document, *path); node && is_expression(*node)) return;
  table.fault(kKey, fmt::format("is {}, no number of the base: {}; {}", in_quotes(*key),
                                misfit(base->document, *path), hint(*base, *key)));
}

std::optional<Range> read_range(TableReader& table) {
  const auto range = table.range("range", kNumber);
  if (!range || range->min < range->max) return range;
  table.fault("range",
              fmt::format("is empty, both ends are {}; expected [a, b] with a < b", range->min));
  return std::nullopt;
}

void read_grid(TableReader& table, StudyVariable& variable) {
  if (table.has("values")) {
    const auto values = table.numbers("values", kNumber, {1, kMostSteps, "values"});
    if (values) variable.values = *values;
    return;
  }
  const auto range = read_range(table);
  const auto steps = table.integer("steps", 2, kMostSteps);
  if (!range || !steps || !suits_scale(table, "range", variable, {range->min}, {})) return;
  for (int i = 0; i < *steps; ++i) {
    variable.values.push_back(
        place_in(*range, static_cast<double>(i) / (*steps - 1), variable.logarithmic));
  }
}

// What the sampled variables have in common must be the same in all.
void read_common(TableReader& table, Sampling sampling, int count,
                 std::optional<Samples>& samples) {
  if (!samples) samples = Samples{sampling, count};
  if (sampling != samples->sampling) {
    table.fault("sampling", fmt::format("is {}, and {} of a variable before; expected one for all, "
                                        "their points are drawn together",
                                        in_quotes(to_string(sampling)),
                                        in_quotes(to_string(samples->sampling))));
  }
  if (count != samples->count) {
    table.fault("count", fmt::format("is {}, and {} of a variable before; expected one for all, "
                                     "their points are drawn together",
                                     count, samples->count));
  }
}

void read_samples(TableReader& table, StudyVariable& variable, std::optional<Samples>& samples) {
  const auto sampling = table.choice<Sampling>("sampling");
  if (!table.has("count")) table.fault("count", "is missing; expected how many samples");
  const auto count = table.integer("count", 1, kMostSamples);
  const auto range = read_range(table);
  if (range && suits_scale(table, "range", variable, {range->min}, {})) variable.range = range;
  if (sampling && count) read_common(table, *sampling, *count, samples);
}

// Which of the three ways of varying the table takes; faults it where that is none or several.
enum class Way { steps, values, samples, none };

Way way_of(TableReader& table) {
  table.know({"range", "steps", "values", "sampling", "count"});
  const bool range = table.has("range"), steps = table.has("steps"), values = table.has("values"),
             sampled = table.has("sampling") || table.has("count");
  const int ways = static_cast<int>(steps) + static_cast<int>(values) + static_cast<int>(sampled);
  if (ways == 1 && range == !values) {
    return steps ? Way::steps : values ? Way::values : Way::samples;
  }
  const char* what = ways == 0 && !range ? "does not say how it varies"
                     : ways == 0         ? "has a range and neither steps nor sampling"
                     : ways > 1          ? "says in more than one way how it varies"
                     : values            ? "has a range beside values"
                                         : "has no range";
  table.faults().add(table.where(), fmt::format("this [[vary]] {}; {}", what, kWays));
  return Way::none;
}

StudyVariable read_variable(TableReader& table, const BaseFile* base, const Study& study,
                            std::optional<Samples>& samples) {
  constexpr std::string_view kScales[] = {"linear", "log"};
  StudyVariable variable;
  read_key(table, base, study, variable);
  variable.logarithmic = table.choice_of("scale", kScales).value_or(0) == 1;
  const Way way = way_of(table);
  if (way == Way::samples) {
    if (!table.has("sampling")) {
      table.fault("sampling",
                  "is missing; expected \"sobol\", \"halton\", \"latin\" or \"random\"");
    }
    read_samples(table, variable, samples);
  } else if (way != Way::none) {
    read_grid(table, variable);
  }
  if (way == Way::values && table.has("scale")) {
    table.fault("scale", "is given beside values; it is of a range");
  }
  table.finish();
  return variable;
}

}  // namespace

void read_variables(TableReader& study_file, const BaseFile* base, Study& study) {
  if (!study_file.has(kVary)) {
    study_file.fault(kVary,
                     "is missing; expected at least one [[vary]] with key and range or values");
  }
  std::optional<Samples> samples;
  double designs = 1;  // of the grid
  for (TableReader& table : study_file.tables(kVary, {1, kMostVariables, "variables"})) {
    study.variables.push_back(read_variable(table, base, study, samples));
    designs *= std::max(1.0, static_cast<double>(study.variables.back().values.size()));
    if (designs > kMostDesigns) break;  // as no number of further values would help
  }
  study.sampling = samples.value_or(Samples{}).sampling;
  study.samples = samples.value_or(Samples{}).count;
  designs *= static_cast<double>(study.samples);
  if (designs > kMostDesigns) {
    study_file.fault(kVary, fmt::format("makes {:.3g} designs; at most 1e12 are allowed", designs));
  }
}

}  // namespace cognate::problems::reading
