/// @file Many four-bars at once, for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace cognate::python {

namespace py = pybind11;

/// Puts the evaluation of batches into `module`.
void bind_batch(py::module_& module);

}  // namespace cognate::python
