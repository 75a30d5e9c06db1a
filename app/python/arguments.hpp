/// @file Single arguments: whole numbers, numbers, words. A wrong one is a ProblemError that names
/// it.
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace cognate::python {

namespace py = pybind11;

/// An integer of Python's or numpy's from `least` to `greatest`.
std::int64_t whole_of(const py::handle& value, const char* name, std::int64_t least,
                      std::int64_t greatest);

/// 0 and None mean as many as the machine has.
int threads_of(const py::handle& value);

/// A finite number.
double number_of(const py::handle& value, const char* name);

/// A finite number above 0.
double length_of(const py::handle& value, const char* name);

/// A string.
std::string text_of(const py::handle& value, const char* name);

/// The place in `words` of a string that is one of them.
std::size_t word_of(const py::handle& value, const char* name,
                    std::initializer_list<std::string_view> words);

/// Raises ProblemError: `value` is of another type than `expected` says.
[[noreturn]] void refuse_type(const py::handle& value, const char* name, std::string_view expected);

/// Raises ProblemError where `__init__` of an object of a class that is bound has not run: pybind11
/// would read uninitialised memory as one.
void expect_made(const py::handle& object, const char* name);

/// The T in an object of Python's class for it.
template <class T>
const T& object_of(const py::handle& object, const char* name, const char* expected) {
  if (!py::isinstance<T>(object)) refuse_type(object, name, expected);
  expect_made(object, name);
  return object.cast<const T&>();
}

}  // namespace cognate::python
