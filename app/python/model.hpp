/// @file Models that are written in Python, for the solvers and the search.
#pragma once

#include <pybind11/pybind11.h>

namespace cognate::python {

namespace py = pybind11;

/// Puts the solvers and the search into `module`.
void bind_models(py::module_& module);

}  // namespace cognate::python
