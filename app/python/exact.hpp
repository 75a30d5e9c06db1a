/// @file Synthesis in closed form and by polynomial systems, for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace cognate::python {

namespace py = pybind11;

/// Puts functions of relative angles (Freudenstein, precision points) into `module`.
void bind_exact_functions(py::module_& module);

/// Puts the smallest cams, and the involute of gears, into `module`.
void bind_exact_cams(py::module_& module);

/// Puts Burmester's problems, and the geometry of a moving body, into `module`.
void bind_exact_motion(py::module_& module);

/// Puts quick-return mechanisms into `module`.
void bind_exact_quick_returns(py::module_& module);

/// Puts coupler points that move straight into `module`.
void bind_exact_straight_lines(py::module_& module);

/// Puts the exact paths into `module`.
void bind_exact_paths(py::module_& module);

}  // namespace cognate::python
