#include "app/python/arguments.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/python/document.hpp"

namespace cognate::python {
namespace {

constexpr int kMostThreads = 1024;

std::string type_name(const py::handle& value) {
  return py::str(py::type::handle_of(value).attr("__name__")).cast<std::string>();
}

}  // namespace

void refuse_type(const py::handle& value, const char* name, std::string_view expected) {
  raise_fault(name, fmt::format("is of the type {}; expected {}", type_name(value), expected));
}

void expect_made(const py::handle& object, const char* name) {
  auto* instance = reinterpret_cast<py::detail::instance*>(object.ptr());
  if (instance->get_value_and_holder().holder_constructed()) return;
  raise_fault(name, "was never made: __init__ has not run");
}

std::int64_t whole_of(const py::handle& value, const char* name, std::int64_t least,
                      std::int64_t greatest) {
  if (PyBool_Check(value.ptr()) || PyIndex_Check(value.ptr()) == 0) {
    refuse_type(value, name, fmt::format("a whole number from {} to {}", least, greatest));
  }
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!index) {  // an array of more than one
    PyErr_Clear();
    refuse_type(value, name, "a whole number");
  }
  int overflow = 0;
  const long long number = PyLong_AsLongLongAndOverflow(index.ptr(), &overflow);
  if (overflow != 0 || number < least || number > greatest) {
    raise_fault(name, fmt::format("is {}; a whole number from {} to {} is allowed",
                                  py::str(index).cast<std::string>(), least, greatest));
  }
  return number;
}

int threads_of(const py::handle& value) {
  if (value.is_none()) return 0;
  return static_cast<int>(whole_of(value, "threads", 0, kMostThreads));
}

double number_of(const py::handle& value, const char* name) {
  double number = 0;
  if (PyFloat_CheckExact(value.ptr())) {
    number = PyFloat_AS_DOUBLE(value.ptr());
  } else {
    const bool is_text = PyUnicode_Check(value.ptr()) || PyBytes_Check(value.ptr());
    number = is_text ? -1 : PyFloat_AsDouble(value.ptr());
    if (is_text || PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      refuse_type(value, name, "a number");
    }
  }
  if (!std::isfinite(number)) {
    raise_fault(name, fmt::format("is {}; finite numbers are allowed", number));
  }
  return number;
}

double length_of(const py::handle& value, const char* name) {
  const double length = number_of(value, name);
  if (!(length > 0)) raise_fault(name, fmt::format("is {}; above 0 is allowed", length));
  return length;
}

std::string text_of(const py::handle& value, const char* name) {
  if (!PyUnicode_Check(value.ptr())) refuse_type(value, name, "a string");
  Py_ssize_t size = 0;
  const char* bytes = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
  if (bytes == nullptr) {
    PyErr_Clear();
    raise_fault(name, "holds a lone surrogate; expected text");
  }
  return {bytes, static_cast<std::size_t>(size)};
}

std::size_t word_of(const py::handle& value, const char* name,
                    std::initializer_list<std::string_view> words) {
  const std::string word = text_of(value, name);
  const auto found = std::ranges::find(words, word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string allowed;
  for (const auto& each : words) {
    allowed += fmt::format("{}\"{}\"", allowed.empty() ? "" : ", ", each);
  }
  raise_fault(name, fmt::format("is \"{}\"; allowed are {}", word, allowed));
}

}  // namespace cognate::python
