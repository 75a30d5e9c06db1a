#include "problems/machine/read_loads.hpp"

#include <utility>

#include "problems/machine/read_function.hpp"
#include "problems/mechanism/read_links.hpp"

namespace cognate::problems::reading {

void read_machine_loads(TableReader& table, const PartNames& names, MachineProblem& problem) {
  constexpr std::string_view kValue = "value";
  for (TableReader& load : load_tables(table)) {
    const auto rule = read_load(load, names, false);
    const bool smooth = read_interpolation(load, {kValue});
    if (!load.has(kValue)) {
      if (rule) problem.mechanism->loads.push_back(*rule);
    } else if (auto value = read_machine_function(load, kValue, {FunctionOf::load}, smooth);
               value && rule) {
      problem.loads.push_back({*rule, std::move(value->function), std::move(value->of_travel)});
    }
    load.finish();
  }
}

}  // namespace cognate::problems::reading
