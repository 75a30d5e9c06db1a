/// @file The masses and loads of a mechanism, written down.
#pragma once

#include "problems/evaluation/problem.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// `[[load]]`.
TableWriter load_writer(const AnalysisProblem& problem, const LoadRule& load);

/// `link`, `load` (those that `more_loads` holds behind those of the problem) and `gravity`, and
/// what of them no document can say.
Table body_tables(const AnalysisProblem& problem, const Array& more_loads,
                  std::vector<std::string>& faults);

/// Adds to `faults` a load on a body that there is not.
void check_load(const AnalysisProblem& problem, const LoadRule& load,
                std::vector<std::string>& faults);

/// Adds to `faults` where `given` differs from `read`, made of the same description.
void check_same_mechanism(const NamedMechanism& given, const NamedMechanism& read,
                          std::vector<std::string>& faults);

}  // namespace cognate::problems::reading
