/// @file Forces of a moving mechanism, for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace cognate::python {

namespace py = pybind11;

/// Puts the forces of mechanisms into `module`.
void bind_forces(py::module_& module);

}  // namespace cognate::python
