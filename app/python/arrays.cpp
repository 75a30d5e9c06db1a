#include "app/python/arrays.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "app/python/document.hpp"

#define NPY_NO_DEPRECATED_API NPY_1_7_API_VERSION
#include <numpy/arrayobject.h>

namespace cognate::python {
namespace {

static_assert(sizeof(npy_intp) == sizeof(py::ssize_t));
constexpr npy_intp kSize = sizeof(double);

using Sizes = std::array<npy_intp, Shape::kMostAxes>;

PyArrayObject* as_array(const py::handle& array) {
  return reinterpret_cast<PyArrayObject*>(array.ptr());
}

std::string shape_text(const Shape& shape) {
  std::string text = "(";
  for (int i = 0; i < shape.axes(); ++i) text += fmt::format("{}{}", i > 0 ? ", " : "", shape[i]);
  return text + (shape.axes() == 1 ? ",)" : ")");
}

/// An array of doubles with these strides in a memory of its own.
NewArray strided(const Shape& shape, Sizes strides) {
  Sizes sizes{};
  for (int i = 0; i < shape.axes(); ++i) sizes[static_cast<std::size_t>(i)] = shape[i];
  PyObject* made = PyArray_New(&PyArray_Type, shape.axes(), sizes.data(), NPY_DOUBLE,
                               strides.data(), nullptr, 0, 0, nullptr);
  if (made == nullptr) throw py::error_already_set();
  auto array = py::reinterpret_steal<py::object>(made);
  auto* data = static_cast<double*>(PyArray_DATA(as_array(made)));
  return {std::move(array), data};
}

/// What numpy has to say, as a fault of the argument.
[[noreturn]] void refuse(const char* name) {
  PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  const auto text = value != nullptr ? py::str(py::handle(value)).cast<std::string>() : "";
  const bool is_memory = type != nullptr && PyErr_GivenExceptionMatches(type, PyExc_MemoryError);
  Py_XDECREF(type);
  Py_XDECREF(value);
  Py_XDECREF(trace);
  if (is_memory) {
    PyErr_SetString(PyExc_MemoryError, text.c_str());
    throw py::error_already_set();
  }
  raise_fault(name, fmt::format("is no array of numbers ({}); expected numbers", text));
}

}  // namespace

Numbers::Numbers(const py::handle& value, const char* name) {
  if (PyFloat_Check(value.ptr())) {
    one_ = PyFloat_AS_DOUBLE(value.ptr());
    is_one_ = true;
    return;
  }
  if (value.is_none()) raise_fault(name, "is None; expected numbers");
  // What cannot be a double without loss, complex numbers or text, is refused by numpy.
  PyObject* made = PyArray_FROM_OTF(value.ptr(), NPY_DOUBLE, NPY_ARRAY_IN_ARRAY);
  if (made == nullptr) refuse(name);
  array_ = py::reinterpret_steal<py::object>(made);
  PyArrayObject* array = as_array(array_);
  if (PyArray_NDIM(array) >= Shape::kMostAxes) {
    raise_fault(name, fmt::format("has {} axes; at most {} are allowed", PyArray_NDIM(array),
                                  Shape::kMostAxes - 1));
  }
  for (int i = 0; i < PyArray_NDIM(array); ++i) shape_.append(PyArray_DIM(array, i));
  values_ = {static_cast<const double*>(PyArray_DATA(array)),
             static_cast<std::size_t>(PyArray_SIZE(array))};
  if (PyArray_Check(value.ptr()) == 0) refuse_none(value, name);
}

void Numbers::refuse_none(const py::handle& value, const char* name) const {
  const auto is_nan = [](double x) { return std::isnan(x); };
  if (std::ranges::none_of(values_, is_nan)) return;
  const auto given = py::reinterpret_steal<py::object>(
      PyArray_FROM_OTF(value.ptr(), NPY_OBJECT, NPY_ARRAY_IN_ARRAY));
  if (!given) throw py::error_already_set();
  const auto* entries = static_cast<PyObject* const*>(PyArray_DATA(as_array(given)));
  const auto count = static_cast<std::size_t>(PyArray_SIZE(as_array(given)));
  if (std::find(entries, entries + count, Py_None) == entries + count) return;
  raise_fault(name, "has None among its numbers; NaN says that there is none");
}

void Numbers::expect(const char* name, const char* form,
                     std::initializer_list<py::ssize_t> sizes) const {
  bool fits = shape_.axes() == static_cast<int>(sizes.size());
  int axis = 0;
  for (const py::ssize_t size : sizes) {
    fits = fits && (size < 0 || shape_[axis] == size);
    ++axis;
  }
  if (fits) return;
  raise_fault(name, fmt::format("has the shape {}; expected {}", shape_text(shape_), form));
}

void Numbers::expect_finite(const char* name) const {
  const auto all = values();
  const auto wrong = std::ranges::find_if_not(all, [](double x) { return std::isfinite(x); });
  if (wrong == all.end()) return;
  raise_fault(name, fmt::format("is {} in place {}, counted from 0 along the last axis first; "
                                "finite numbers are allowed",
                                *wrong, wrong - all.begin()));
}

NewArray new_array(const Shape& shape) {
  Sizes strides{};
  npy_intp step = kSize;
  for (int i = shape.axes() - 1; i >= 0; --i) {
    strides[static_cast<std::size_t>(i)] = step;
    step *= shape[i];
  }
  return strided(shape, strides);
}

NewArray new_columns(const Shape& shape) {
  Sizes strides{};
  npy_intp step = kSize;
  for (int i = 0; i < shape.axes(); ++i) {
    strides[static_cast<std::size_t>(i)] = step;
    step *= shape[i];
  }
  return strided(shape, strides);
}

double* columns_in(const py::handle& array, const Shape& shape) {
  if (PyArray_Check(array.ptr()) == 0) return nullptr;
  PyArrayObject* given = as_array(array);
  bool fits = PyArray_TYPE(given) == NPY_DOUBLE && PyArray_ISFARRAY(given) &&
              PyArray_NDIM(given) == shape.axes();
  for (int i = 0; fits && i < shape.axes(); ++i) fits = PyArray_DIM(given, i) == shape[i];
  return fits ? static_cast<double*>(PyArray_DATA(given)) : nullptr;
}

NewArray new_points(const Shape& shape) {
  Shape pairs = shape;
  pairs.append(2);
  Sizes strides{};
  npy_intp step = kSize;
  for (int i = shape.axes() - 1; i >= 0; --i) {
    strides[static_cast<std::size_t>(i)] = step;
    step *= shape[i];
  }
  strides[static_cast<std::size_t>(shape.axes())] = step;
  return strided(pairs, strides);
}

py::object repeated_point(const Shape& shape, const Vec2d& point) {
  py::object stored = to_array(point);
  Sizes sizes{}, strides{};
  for (int i = 0; i < shape.axes(); ++i) sizes[static_cast<std::size_t>(i)] = shape[i];
  const auto last = static_cast<std::size_t>(shape.axes());
  sizes[last] = 2;
  strides[last] = kSize;
  PyObject* made = PyArray_New(&PyArray_Type, shape.axes() + 1, sizes.data(), NPY_DOUBLE,
                               strides.data(), PyArray_DATA(as_array(stored)), 0, 0, nullptr);
  if (made == nullptr) throw py::error_already_set();
  auto array = py::reinterpret_steal<py::object>(made);
  if (PyArray_SetBaseObject(as_array(made), stored.release().ptr()) != 0) {
    throw py::error_already_set();
  }
  return array;
}

py::object to_array(const Vec2d& point) {
  NewArray made = new_array({2});
  made.data[0] = point.x;
  made.data[1] = point.y;
  return std::move(made.array);
}

py::object to_array(std::span<const Vec2d> points) {
  NewArray made = new_array({static_cast<py::ssize_t>(points.size()), 2});
  double* next = made.data;
  for (const Vec2d& point : points) {
    *next++ = point.x;
    *next++ = point.y;
  }
  return std::move(made.array);
}

py::object to_array(std::span<const double> values) {
  NewArray made = new_array({static_cast<py::ssize_t>(values.size())});
  std::ranges::copy(values, made.data);
  return std::move(made.array);
}

py::object to_array(std::vector<double>&& values) {
  auto kept = std::make_unique<std::vector<double>>(std::move(values));
  auto size = static_cast<npy_intp>(kept->size());
  if (size == 0) return new_array({0}).array;
  auto array = py::reinterpret_steal<py::object>(
      PyArray_SimpleNewFromData(1, &size, NPY_DOUBLE, kept->data()));
  if (!array) throw py::error_already_set();
  const auto free = [](void* vector) { delete static_cast<std::vector<double>*>(vector); };
  py::capsule owner(kept.get(), free);
  kept.release();
  if (PyArray_SetBaseObject(as_array(array), owner.release().ptr()) != 0) {
    throw py::error_already_set();
  }
  return array;
}

Vec2d point_of(const py::handle& value, const char* name) {
  const Numbers numbers(value, name);
  numbers.expect(name, "(2,), [x, y]", {2});
  numbers.expect_finite(name);
  return {numbers.values()[0], numbers.values()[1]};
}

std::vector<Vec2d> points_of(const py::handle& value, const char* name) {
  const Numbers numbers(value, name);
  numbers.expect(name, "(n, 2), [[x, y], ...]", {-1, 2});
  numbers.expect_finite(name);
  std::vector<Vec2d> points;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    points.push_back({numbers.values()[i], numbers.values()[i + 1]});
  }
  return points;
}

void load_numpy() {
  if (_import_array() < 0) throw py::error_already_set();
}

}  // namespace cognate::python
