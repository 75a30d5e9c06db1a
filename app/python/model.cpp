#include "app/python/model.hpp"

#include <fmt/core.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/python/arguments.hpp"
#include "app/python/arrays.hpp"
#include "app/python/document.hpp"
#include "app/python/problem.hpp"
#include "app/python/watch.hpp"
#include "synthesis/optimise/model.hpp"
#include "synthesis/optimise/solver.hpp"
#include "synthesis/search/search.hpp"

namespace cognate::python {
namespace {

using synthesis::Objective;
using synthesis::Variable;

constexpr std::int64_t kMostSteps = 1'000'000'000;

/// What Python says of a model.
struct Functions {
  std::vector<Variable> variables;
  py::object residuals, jacobian;               ///< the second may be None
  py::object constraints, constraint_jacobian;  ///< both may be None
  int equalities = 0;
  Objective objective = Objective::sum_of_squares;
};

/// A model whose functions are Python's. They are called with the interpreter's lock held; what
/// they raise is kept, ends the search, and is raised when that has returned. Derivatives that are
/// not given are central differences.
class PythonModel final : public synthesis::Model {
 public:
  /// `counts`: of residuals and constraints.
  PythonModel(Functions functions, Watch& watch, std::pair<int, int> counts)
      : functions_(std::move(functions)), watch_(watch), counts_(counts) {}

  std::span<const Variable> variables() const override { return functions_.variables; }
  int residual_count() const override { return counts_.first; }
  int constraint_count() const override { return counts_.second; }
  int equality_count() const override { return functions_.equalities; }
  Objective objective() const override { return functions_.objective; }

  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> /*local*/) const override {
    const py::gil_scoped_acquire locked;
    return guarded([&] {
      if (!call(functions_.residuals, x, r, "residuals")) return false;
      if (jacobian.empty()) return true;
      if (!functions_.jacobian.is_none()) return call(functions_.jacobian, x, jacobian, "jacobian");
      return differences(functions_.residuals, x, r.size(), jacobian, "residuals");
    });
  }

  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override {
    if (c.empty() && jacobian.empty()) return;
    const py::gil_scoped_acquire locked;
    const bool is_there = guarded([&] {
      if (!call(functions_.constraints, x, c, "constraints")) return false;
      if (jacobian.empty()) return true;
      if (!functions_.constraint_jacobian.is_none()) {
        return call(functions_.constraint_jacobian, x, jacobian, "constraint_jacobian");
      }
      return differences(functions_.constraints, x, c.size(), jacobian, "constraints");
    });
    if (is_there) return;
    std::ranges::fill(c, -1);  // not met; the search is at its end or goes elsewhere
    std::ranges::fill(jacobian, 0);
  }

  /// Raises what a function has raised; to be called with the lock held.
  void raise() {
    const std::scoped_lock lock(guard_);
    if (!raised_) return;
    const py::error_already_set error = *std::exchange(raised_, std::nullopt);
    throw error;
  }

 private:
  template <class Body>
  bool guarded(const Body& body) const {
    try {
      return !watch_.interrupted() && body();
    } catch (py::error_already_set& error) {
      const std::scoped_lock lock(guard_);
      if (!raised_) raised_.emplace(error);
      watch_.interrupt();
      return false;
    }
  }

  /// False where the function returns None, and where a number is not finite.
  bool call(const py::object& function, std::span<const double> x, std::span<double> out,
            const char* name) const {
    const py::object value = function(to_array(x));
    if (value.is_none()) return false;
    const Numbers numbers(value, name);
    if (numbers.size() != out.size()) {
      raise_fault(name, fmt::format("has given {} numbers, and before or elsewhere {}; expected "
                                    "always as many",
                                    numbers.size(), out.size()));
    }
    std::ranges::copy(numbers.values(), out.begin());
    return std::ranges::all_of(out, [](double number) { return std::isfinite(number); });
  }

  bool differences(const py::object& function, std::span<const double> x, std::size_t rows,
                   std::span<double> jacobian, const char* name) const {
    const std::size_t count = functions_.variables.size();
    std::vector<double> at(x.begin(), x.end()), above(rows), below(rows);
    for (std::size_t k = 0; k < count; ++k) {
      const Variable& variable = functions_.variables[k];
      const double step = std::cbrt(std::numeric_limits<double>::epsilon()) *
                          std::max(std::abs(x[k]), variable.scale);
      const double high = std::min(x[k] + step, variable.upper);
      const double low = std::max(x[k] - step, variable.lower);
      at[k] = high;
      const bool has_above = call(function, at, above, name);
      at[k] = low;
      const bool has_below = call(function, at, below, name);
      at[k] = x[k];
      if (!has_above || !has_below) return false;
      const double width = high > low ? high - low : 1;
      for (std::size_t i = 0; i < rows; ++i)
        jacobian[i * count + k] = (above[i] - below[i]) / width;
    }
    return true;
  }

  Functions functions_;
  Watch& watch_;
  std::pair<int, int> counts_;
  mutable std::mutex guard_;
  mutable std::optional<py::error_already_set> raised_;
};

std::vector<Variable> variables_of(const py::list& given) {
  std::vector<Variable> all;
  for (const py::handle each : given) {
    const auto row = py::reinterpret_borrow<py::tuple>(each);
    Variable variable{row[0].cast<std::string>(), row[1].cast<double>(), row[2].cast<double>(),
                      row[3].cast<double>()};
    const bool is_range = variable.lower <= variable.upper;
    if (!is_range || !(variable.scale > 0) || !std::isfinite(variable.scale)) {
      raise_fault(variable.name, "has no range lower <= upper, or a scale that is not above 0");
    }
    all.push_back(std::move(variable));
  }
  if (all.empty()) raise_fault("variables", "are none; expected one at least");
  return all;
}

Functions functions_of(const py::dict& model) {
  Functions functions{
      .variables = variables_of(model["variables"]),
      .residuals = model["residuals"],
      .jacobian = model["jacobian"],
      .constraints = model["constraints"],
      .constraint_jacobian = model["constraint_jacobian"],
      .equalities = static_cast<int>(whole_of(model["equalities"], "equalities", 0, kMostSteps))};
  if (model["objective"].cast<std::string>() == "max-abs") functions.objective = Objective::max_abs;
  return functions;
}

/// How many residuals and constraints there are, by the functions' values at `x`.
std::pair<int, int> counts_at(const Functions& functions, std::span<const double> x) {
  const auto count = [&](const py::object& function, const char* name) {
    if (function.is_none()) return 0;
    const py::object value = function(to_array(x));
    if (value.is_none()) {
      raise_fault(name,
                  "are None where their number is looked for: at the start, or in the middle "
                  "of the bounds; give a start with a value");
    }
    const Numbers numbers(value, name);
    return static_cast<int>(numbers.size());
  };
  const std::pair counts(count(functions.residuals, "residuals"),
                         count(functions.constraints, "constraints"));
  if (counts.first == 0) raise_fault("residuals", "are none; expected one at least");
  if (functions.equalities > counts.second) {
    raise_fault("equalities",
                fmt::format("are {} of {} constraints; expected no more than there are",
                            functions.equalities, counts.second));
  }
  return counts;
}

std::vector<double> start_of(const py::object& given, const std::vector<Variable>& variables) {
  if (!given.is_none()) {
    const Numbers numbers(given, "start");
    numbers.expect("start", "(n,), a number for each variable",
                   {static_cast<py::ssize_t>(variables.size())});
    numbers.expect_finite("start");
    return {numbers.values().begin(), numbers.values().end()};
  }
  std::vector<double> middle;
  for (const Variable& variable : variables) {
    const double low = std::isfinite(variable.lower) ? variable.lower : -variable.scale;
    const double high = std::isfinite(variable.upper) ? variable.upper : variable.scale;
    middle.push_back(std::clamp((low + high) / 2, variable.lower, variable.upper));
  }
  return middle;
}

synthesis::Solver solver_of(const std::string& name, const synthesis::Model& model) {
  std::string known;
  for (const auto& solver : synthesis::kSolvers) {
    known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", solver.name);
    if (solver.name != name) continue;
    if (synthesis::can_solve(synthesis::chosen(solver.id), model)) {
      return synthesis::chosen(solver.id);
    }
    raise_fault("solver", fmt::format("is \"{}\", which does not take such a model: {}", name,
                                      solver.meaning));
  }
  raise_fault("solver", fmt::format("is \"{}\"; available are {}", name, known));
}

const char* word(synthesis::Stop stop) {
  using synthesis::Stop;
  switch (stop) {
    case Stop::converged:
      return "converged";
    case Stop::iteration_limit:
      return "iteration-limit";
    case Stop::time_limit:
      return "time-limit";
    case Stop::interrupted:
      return "interrupted";
    case Stop::no_value:
      return "no-value";
    case Stop::infeasible:
      return "infeasible";
    case Stop::failed:
      return "failed";
  }
  return "";
}

const char* word(synthesis::SearchStatus status) {
  using synthesis::SearchStatus;
  switch (status) {
    case SearchStatus::solved:
      return "solved";
    case SearchStatus::infeasible:
      return "infeasible";
    case SearchStatus::no_solution:
      return "no-solution";
    case SearchStatus::time_limit:
      return "time-limit";
    case SearchStatus::cancelled:
      return "interrupted";
  }
  return "";
}

py::dict solution_table(const synthesis::Solution& solution) {
  py::dict table;
  table["x"] = to_array(std::span<const double>(solution.x));
  // Where the residuals have no value at the start, nothing was found.
  const bool has_value = solution.stop != synthesis::Stop::no_value;
  table["objective"] = has_value ? solution.objective : std::numeric_limits<double>::quiet_NaN();
  table["violation"] = solution.violation;
  table["multipliers"] = to_array(std::span<const double>(solution.multipliers));
  table["stop"] = word(solution.stop);
  table["iterations"] = solution.iterations;
  table["evaluations"] = solution.evaluations;
  return table;
}

py::dict solve_model(const py::dict& given, const py::object& start, const py::object& solver,
                     const py::object& tolerance, const py::object& iterations,
                     const py::dict& run) {
  const RunOptions options = checked({run["seed"], run["threads"], run["time_limit"], py::none()});
  Functions functions = functions_of(given);
  const std::vector<double> from = start_of(start, functions.variables);
  const auto counts = counts_at(functions, from);
  Watch watch;
  PythonModel model(std::move(functions), watch, counts);
  const synthesis::Solver chosen = solver_of(text_of(solver, "solver"), model);
  synthesis::Options how{
      .tolerance = length_of(tolerance, "tolerance"),
      .max_iterations = static_cast<int>(whole_of(iterations, "iterations", 0, kMostSteps))};
  how.interrupted = &watch.interrupted();
  how.seed = options.seed;
  if (options.time_limit) how.time_limit = *options.time_limit;
  synthesis::Solution solution;
  watch.run(py::none(), [&] { solution = synthesis::solve(chosen, model, from, how); });
  model.raise();
  return solution_table(solution);
}

py::dict search_model(const py::dict& given, const py::object& start, const py::object& solver,
                      const py::object& starts, const py::object& designs, const py::dict& run) {
  const py::object progress = run["progress"];
  const RunOptions options = checked({run["seed"], run["threads"], run["time_limit"], progress});
  Functions functions = functions_of(given);
  const std::vector<double> known = start_of(start, functions.variables);
  const auto counts = counts_at(functions, known);
  Watch watch;
  PythonModel model(std::move(functions), watch, counts);
  synthesis::SearchOptions how;
  how.solver = how.finisher = solver_of(text_of(solver, "solver"), model);
  if (!starts.is_none()) {
    how.rule.starts = static_cast<int>(whole_of(starts, "starts", 1, kMostSteps));
  }
  if (!start.is_none()) how.known.push_back({known});
  how.designs = static_cast<std::size_t>(whole_of(designs, "designs", 1, kMostSteps));
  how.seed = options.seed;
  how.threads = options.threads;
  if (options.time_limit) how.time_limit = *options.time_limit;
  how.cancelled = &watch.interrupted();
  how.progress = [&](double share, double best) { watch.report(share, best); };
  synthesis::SearchResult found;
  watch.run(progress, [&] { found = synthesis::search(model, how); });
  model.raise();
  py::list minima;
  for (const auto& minimum : found.minima) {
    py::dict table = solution_table(minimum.solution);
    table["hits"] = minimum.hits;
    minima.append(table);
  }
  py::dict all;
  all["status"] = word(found.status);
  all["minima"] = minima;
  all["starts"] = found.statistics.starts;
  all["best_hits"] = found.statistics.best_hits;
  all["unseen"] = found.statistics.unseen;
  return all;
}

}  // namespace

void bind_models(py::module_& module) {
  module.def("solve_model", &solve_model);
  module.def("search_model", &search_model);
  py::list names;
  for (const auto& solver : synthesis::kSolvers) names.append(std::string(solver.name));
  module.attr("SOLVERS") = py::tuple(names);
}

}  // namespace cognate::python
