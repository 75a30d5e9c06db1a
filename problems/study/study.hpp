/// @file What a study file says: which numbers of a base file vary, and what is requested of each
/// design. Angles stay as the base file has them, in degrees under keys that end in `_deg`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

/// A place in a file: names of tables and keys, and numbers of entries from 0. Written
/// "mechanism.coupler", "target.points[2][0]", "dyad[1].lengths[0]".
using KeyPath = std::vector<std::variant<std::string, std::size_t>>;

/// How the points of sampled variables are placed in their box. All but `random` spread evenly.
enum class Sampling { sobol, halton, latin, random };

/// `[[vary]]`: a number of the base file, there already, that is replaced.
struct StudyVariable {
  std::string key;  ///< as written, and the name of its column
  KeyPath path;
  std::vector<double> values;  ///< of a grid: `values`, or `range` in `steps`; empty if sampled
  std::optional<Range> range;  ///< of a sampled variable
  bool logarithmic = false;    ///< equal steps, or samples, of the logarithm
};

/// `[filter]`: rows that do not pass are not kept. A design without the metric does not pass.
struct StudyFilter {
  std::string name;  ///< of a metric or a varied key
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  std::vector<std::string> words;  ///< one of these, of a metric that is a word; else empty
};

/// `[objective]`
struct StudyObjective {
  std::string name;  ///< of a metric or a varied key
  bool greatest = false;
};

/// A study. Its designs are numbered from 0: the product of the grid (the last variable fastest)
/// and, fastest of all, the samples.
struct Study {
  std::string title;
  std::string base;                         ///< the base file, as written
  std::string base_text;                    ///< what that file holds
  std::filesystem::path folder;             ///< of the base file, where files that it names are
  std::optional<LengthUnit> length_unit{};  ///< of the base
  std::string drawing;  ///< the path data of the drawing that the base names, if any
  std::vector<StudyVariable> variables;
  Sampling sampling = Sampling::sobol;  ///< of all sampled variables, together one set of points
  std::int64_t samples = 1;
  std::vector<std::string> metrics;  ///< the columns after the varied keys; objectives among them
  std::vector<StudyFilter> filters;
  std::vector<StudyObjective> objectives;
  bool keep_all = false;  ///< rows that do not pass the filters are kept as well
};

/// How many designs the study has.
std::int64_t design_count(const Study& study);

/// The columns of its rows: the varied keys, then the metrics.
std::vector<std::string> study_columns(const Study& study);

}  // namespace cognate::problems
