/// @file What the program does with a problem, for Python.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace cognate::python {

namespace py = pybind11;

/// The answer to a problem: its document, and what else is made of it when somebody asks.
struct Answer {
  nlohmann::ordered_json document;                                   ///< cognate-result/1
  std::function<std::string(const nlohmann::ordered_json&)> report;  ///< a page; may be empty
  std::function<std::string()> csv;                                  ///< may be empty
};

/// How a computation is steered; every member may be None.
struct Steering {
  py::object seed, threads, time_limit, progress;
};

/// The same, checked.
struct RunOptions {
  std::uint64_t seed = 1;
  int threads = 0;
  std::optional<double> time_limit;
};

/// Raises ProblemError with everything that is wrong.
RunOptions checked(const Steering& steering);

/// Puts solve, analyze, check, list and export into `module`.
void bind_problems(py::module_& module);

}  // namespace cognate::python
