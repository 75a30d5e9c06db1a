/// @file The extension module of the package `cognate`: what of it is not written in Python.
#include <pybind11/pybind11.h>

#include "app/python/arrays.hpp"
#include "app/python/batch.hpp"
#include "app/python/exact.hpp"
#include "app/python/forces.hpp"
#include "app/python/mechanism.hpp"
#include "app/python/model.hpp"
#include "app/python/problem.hpp"
#include "app/python/study.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "What of the package cognate is compiled; use cognate itself.";
  cognate::python::load_numpy();
  cognate::python::bind_problems(module);
  cognate::python::bind_mechanisms(module);
  cognate::python::bind_batch(module);
  cognate::python::bind_forces(module);
  cognate::python::bind_exact_functions(module);
  cognate::python::bind_exact_cams(module);
  cognate::python::bind_exact_motion(module);
  cognate::python::bind_exact_paths(module);
  cognate::python::bind_exact_quick_returns(module);
  cognate::python::bind_exact_straight_lines(module);
  cognate::python::bind_models(module);
  cognate::python::bind_studies(module);
}
