/// @file Studies, for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace cognate::python {

namespace py = pybind11;

/// Puts running and reading studies into `module`.
void bind_studies(py::module_& module);

}  // namespace cognate::python
