/// @file Arrays of numpy: numbers in without a copy where they are doubles already, columns out
/// that numpy owns. Only arrays.cpp knows numpy's own interface.
#pragma once

#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/numbers/vec2.hpp"

namespace cognate::python {

namespace py = pybind11;

/// How many entries an array has along each axis.
class Shape {
 public:
  static constexpr int kMostAxes = 8;

  Shape() = default;
  Shape(std::initializer_list<py::ssize_t> sizes) {
    for (const py::ssize_t size : sizes) append(size);
  }

  void append(py::ssize_t size) { sizes_[static_cast<std::size_t>(axes_++)] = size; }
  int axes() const { return axes_; }
  py::ssize_t operator[](int axis) const { return sizes_[static_cast<std::size_t>(axis)]; }
  std::size_t count() const {
    std::size_t all = 1;
    for (int i = 0; i < axes_; ++i) all *= static_cast<std::size_t>((*this)[i]);
    return all;
  }

 private:
  std::array<py::ssize_t, kMostAxes> sizes_{};
  int axes_ = 0;
};

/// An argument as doubles one after the other, the last axis fastest.
class Numbers {
 public:
  /// `value` is a number or anything that numpy takes for an array of numbers; `name`, of the
  /// argument, is for messages. Raises ProblemError.
  Numbers(const py::handle& value, const char* name);

  const Shape& shape() const { return shape_; }
  std::span<const double> values() const { return is_one_ ? std::span(&one_, 1) : values_; }
  std::size_t size() const { return is_one_ ? 1 : values_.size(); }

  /// Raises ProblemError where the shape is another; −1 stands for any size. `form`: how the
  /// argument is written, "(n, 2)".
  void expect(const char* name, const char* form, std::initializer_list<py::ssize_t> sizes) const;
  /// Raises ProblemError where a number is NaN or infinite.
  void expect_finite(const char* name) const;

 private:
  /// numpy takes None in a list for NaN.
  void refuse_none(const py::handle& value, const char* name) const;

  double one_ = 0;
  bool is_one_ = false;
  Shape shape_;
  py::object array_;
  std::span<const double> values_;
};

/// A new array and its numbers.
struct NewArray {
  py::object array;
  double* data = nullptr;
};

/// Of `shape`, the last axis fastest.
NewArray new_array(const Shape& shape);

/// Of `shape`, the first axis fastest.
NewArray new_columns(const Shape& shape);

/// The numbers of `array` if it is one as `new_columns(shape)` makes, and can be written to; else
/// null.
double* columns_in(const py::handle& array, const Shape& shape);

/// Of shape (…, 2): all x stand one after the other in the order of `shape`, then all y.
NewArray new_points(const Shape& shape);

/// The same point everywhere: an array of shape (…, 2) of which two numbers are stored. Read-only.
py::object repeated_point(const Shape& shape, const Vec2d& point);

/// [x, y].
py::object to_array(const Vec2d& point);

/// Of shape (n, 2).
py::object to_array(std::span<const Vec2d> points);

/// Of shape (n,).
py::object to_array(std::span<const double> values);

/// Of shape (n,); the array keeps the vector, and nothing is copied.
py::object to_array(std::vector<double>&& values);

/// Two numbers.
Vec2d point_of(const py::handle& value, const char* name);

/// Array (n, 2).
std::vector<Vec2d> points_of(const py::handle& value, const char* name);

/// Loads numpy; called once, when the module is.
void load_numpy();

}  // namespace cognate::python
