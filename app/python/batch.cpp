#include "app/python/batch.hpp"

#include <fmt/core.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/batch/four_bar_batch.hpp"
#include "app/python/arguments.hpp"
#include "app/python/arrays.hpp"
#include "app/python/document.hpp"

namespace cognate::python {
namespace {

/// The columns of designs, in the order in which those of an array stand.
constexpr std::array<const char*, 10> kColumns = {
    "pivot_a_x", "pivot_a_y", "pivot_d_x", "pivot_d_y", "crank",
    "coupler",   "rocker",    "assembly",  "point_u",   "point_v"};

std::string column_names() {
  std::string all;
  for (const char* name : kColumns) all += fmt::format("{}{}", all.empty() ? "" : ", ", name);
  return all;
}

/// Designs as spans of arrays, which this keeps alive.
class Designs {
 public:
  /// `columns`: one array (m,) for each of the names.
  explicit Designs(const py::dict& columns) {
    for (const auto& [key, value] : columns) {
      const auto name = py::str(key).cast<std::string>();
      if (std::ranges::find(kColumns, name) != kColumns.end()) continue;
      raise_fault("designs",
                  fmt::format("have the column \"{}\"; allowed are {}", name, column_names()));
    }
    FourBarArrays<double>& arrays = arrays_;
    const std::array<std::span<const double>*, 10> places = {
        &arrays.pivot_a_x, &arrays.pivot_a_y, &arrays.pivot_d_x, &arrays.pivot_d_y,
        &arrays.crank,     &arrays.coupler,   &arrays.rocker,    &arrays.assembly,
        &arrays.point_u,   &arrays.point_v};
    kept_.reserve(kColumns.size());
    for (std::size_t i = 0; i < kColumns.size(); ++i) *places[i] = column(columns, kColumns[i]);
  }

  const FourBarArrays<double>& arrays() const { return arrays_; }
  std::size_t size() const { return size_.value_or(0); }

 private:
  std::span<const double> column(const py::dict& columns, const char* name) {
    if (!columns.contains(name)) {
      raise_fault("designs",
                  fmt::format("have no column \"{}\"; expected all of {}", name, column_names()));
    }
    const Numbers& numbers = kept_.emplace_back(columns[name], name);
    numbers.expect(name, "(m,), a number for each design", {-1});
    const std::size_t size = numbers.size();
    if (size != size_.value_or(size)) {
      raise_fault(
          name, fmt::format("has {} numbers for {} designs; expected one for each", size, *size_));
    }
    size_ = size;
    return numbers.values();
  }

  std::vector<Numbers> kept_;
  std::optional<std::size_t> size_;
  FourBarArrays<double> arrays_;
};

/// A quantity that may be wanted, the array for it, and its columns.
class Outputs {
 public:
  Outputs(std::size_t designs, std::size_t angles)
      : designs_(static_cast<py::ssize_t>(designs)), angles_(static_cast<py::ssize_t>(angles)) {}

  void want(const std::string& name, const py::dict& out) {
    if (name == "position") return pair(name, out, columns_.x, columns_.y);
    if (name == "velocity") return pair(name, out, columns_.velocity_x, columns_.velocity_y);
    if (name == "acceleration") {
      return pair(name, out, columns_.acceleration_x, columns_.acceleration_y);
    }
    if (name == "curvature") return single(name, out, columns_.curvature);
    if (name == "transmission_sin") return single(name, out, columns_.transmission_sin);
    if (name == "transmission_cos") return single(name, out, columns_.transmission_cos);
    if (name == "gradient") return gradient(name, out);
    raise_fault("quantities",
                fmt::format("have \"{}\"; allowed are position, velocity, acceleration, curvature, "
                            "transmission_sin, transmission_cos, gradient",
                            name));
  }

  /// The sine and the cosine go together.
  void complete() {
    const std::size_t size = count();
    for (auto* column : {&columns_.transmission_sin, &columns_.transmission_cos}) {
      const bool other = !columns_.transmission_sin.empty() || !columns_.transmission_cos.empty();
      if (!other || !column->empty()) continue;
      unasked_.resize(size);
      *column = unasked_;
    }
  }

  const FourBarColumns<double>& columns() const { return columns_; }
  py::dict& arrays() { return arrays_; }
  std::size_t count() const { return static_cast<std::size_t>(designs_ * angles_); }

 private:
  /// The array of `out` under `name`, or a new one.
  double* take(const std::string& name, const py::dict& out, const Shape& shape) {
    if (!out.contains(name)) {
      NewArray made = new_columns(shape);
      arrays_[py::str(name)] = made.array;
      return made.data;
    }
    const py::object given = out[py::str(name)];
    double* data = columns_in(given, shape);
    if (data == nullptr) {
      raise_fault("out",
                  fmt::format("is no array of doubles of the shape that {} has, in Fortran's "
                              "order; expected numpy.empty(shape, order=\"F\")",
                              name));
    }
    arrays_[py::str(name)] = given;
    return data;
  }

  void pair(const std::string& name, const py::dict& out, std::span<double>& x,
            std::span<double>& y) {
    double* data = take(name, out, {designs_, angles_, 2});
    x = {data, count()};
    y = {data + count(), count()};
  }
  void single(const std::string& name, const py::dict& out, std::span<double>& column) {
    column = {take(name, out, {designs_, angles_}), count()};
  }
  void gradient(const std::string& name, const py::dict& out) {
    double* data = take(name, out, {designs_, angles_, 2, py::ssize_t{kDesignVariables}});
    for (std::size_t k = 0; k < kDesignVariables; ++k) {
      columns_.gradient_x[k] = {data + 2 * k * count(), count()};
      columns_.gradient_y[k] = {data + (2 * k + 1) * count(), count()};
    }
  }

  py::ssize_t designs_, angles_;
  FourBarColumns<double> columns_;
  std::vector<double> unasked_;
  py::dict arrays_;
};

py::dict evaluate_four_bars(const py::dict& designs, const py::object& angles,
                            const py::list& wanted, const py::dict& out,
                            const py::object& threads_wanted) {
  const int threads = threads_of(threads_wanted);
  std::vector<std::string> quantities;
  for (const py::handle name : wanted) quantities.push_back(text_of(name, "quantities"));
  for (const auto& [name, array] : out) {
    const auto is_wanted = std::ranges::find(quantities, text_of(name, "out"));
    if (is_wanted != quantities.end()) continue;
    raise_fault("out", fmt::format("has \"{}\", which is not among the quantities",
                                   py::str(name).cast<std::string>()));
  }
  const Designs given(designs);
  const Numbers at(angles, "angles");
  if (at.shape().axes() > 1) at.expect("angles", "(n,), in radians from A to D", {-1});
  Outputs outputs(given.size(), at.size());
  for (const std::string& name : quantities) outputs.want(name, out);
  if (outputs.count() == 0 || quantities.empty()) return outputs.arrays();
  outputs.complete();
  BatchStatus status = BatchStatus::done;
  {
    const py::gil_scoped_release unlocked;
    const CrankTable<double> cranks(at.values());
    status = evaluate_batch(given.arrays(), cranks, outputs.columns(), {.threads = threads});
  }
  if (status != BatchStatus::done) throw std::runtime_error("a fault of Cognate's own: a batch");
  return outputs.arrays();
}

}  // namespace

void bind_batch(py::module_& module) {
  module.def("evaluate_four_bars", &evaluate_four_bars);
  py::list names;
  for (const char* name : kColumns) names.append(name);
  module.attr("DESIGN_COLUMNS") = py::tuple(names);
}

}  // namespace cognate::python
