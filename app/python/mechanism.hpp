/// @file A mechanism of given dimensions, for Python.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <string_view>
#include <vector>

#include "app/python/arrays.hpp"
#include "problems/evaluation/problem.hpp"

namespace cognate::python {

/// A mechanism as `[mechanism]` describes it. Never changes: any number of threads may use it.
class Moved {
 public:
  /// `tables`: the keys of `[mechanism]`, `type` among them. Raises ProblemError.
  explicit Moved(const py::dict& tables);
  /// `problem` is what was read of tables like these.
  explicit Moved(problems::NamedMechanism mechanism);

  const problems::NamedMechanism& named() const { return named_; }
  std::span<const double> sides() const { return sides_; }

  /// The keys of `[mechanism]`, with every default.
  py::object tables() const;

  /// A dictionary: of every named point, or of `points` where these are given, the derivative
  /// `order` (0 to 3) by the drive at `angles`: arrays (…, 2). NaN where the mechanism cannot be
  /// assembled.
  py::object points(const py::object& angles, const py::object& order, const py::object& points,
                    const py::object& threads) const;
  /// Of one point, where it is.
  py::object point(const py::object& name, const py::object& angles,
                   const py::object& threads) const;
  /// Of every moving body: `order` 0 its angle in radians in (−π, π], else the derivative of its
  /// angle.
  py::object bodies(const py::object& angles, const py::object& order,
                    const py::object& threads) const;
  /// The transmission angle of each dyad, in radians: arrays (…,).
  py::object transmission(const py::object& angles, const py::object& threads) const;
  /// ∂(point)/∂(dimension) at `angles`: dictionary of the keys of the dimensions.
  py::object gradient(const py::object& point, const py::object& angles) const;

  /// The names of the points of each body, the frame first, and pairs of points between which
  /// something slides: what a picture is drawn of.
  py::tuple skeleton() const;

  std::vector<std::string> point_names() const;
  std::vector<std::string> body_names() const;

 private:
  /// `key`: of the argument, for the message.
  const problems::NamedPoint& find(const std::string& name, const char* key) const;

  problems::NamedMechanism named_;
  std::vector<double> sides_;
  std::vector<py::object> keys_;  ///< the names of the points
};

/// The keys of `[mechanism]`, with every default, for `mechanism_of` in Python.
py::object tables_of(const problems::NamedMechanism& mechanism);

/// Puts the class into `module`.
void bind_mechanisms(py::module_& module);

}  // namespace cognate::python
