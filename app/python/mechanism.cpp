#include "app/python/mechanism.hpp"

#include <fmt/core.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "analysis/batch/chain_batch.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "app/documents/result_json.hpp"
#include "app/python/arguments.hpp"
#include "app/python/document.hpp"
#include "app/python/gradient.hpp"
#include "app/python/json.hpp"
#include "problems/mechanism/joint_names.hpp"
#include "problems/mechanism/mechanism_types.hpp"
#include "problems/mechanism/read_whole_mechanism.hpp"

namespace cognate::python {
namespace {

using problems::NamedMechanism;
using problems::NamedPoint;

/// From so many numbers on the interpreter's lock is given up while they are computed.
constexpr std::size_t kLong = 4096;

NamedMechanism read_mechanism(const py::dict& tables) {
  py::dict document;
  document["mechanism"] = tables;
  const Source source = source_of(document);
  problems::reading::FaultList faults;
  problems::reading::TableReader reader(source.document, faults);
  problems::reading::TableReader mechanism = reader.table("mechanism");
  auto read = problems::reading::read_whole_mechanism(reader, mechanism);
  if (read) mechanism.finish();
  if (read && has_groups(read->mechanism.mechanism)) {
    mechanism.fault(mechanism.has("joint") ? "joint" : "dyad",
                    "has a group of more than two links, whose positions only a motion finds; "
                    "expected dyads, or cognate.solve of an analysis");
  }
  if (!faults.empty() || !read) raise_faults(source, std::move(faults).sorted());
  return std::move(read->mechanism);
}

/// Where the columns of a point or body are found, and evaluates them.
class Evaluation {
 public:
  Evaluation(const Moved& mechanism, const py::object& angles, const py::object& threads)
      : mechanism_(mechanism), angles_(angles, "angles"), threads_(threads_of(threads)) {}

  const Shape& shape() const { return angles_.shape(); }
  std::size_t size() const { return angles_.size(); }
  ChainColumns& columns() { return columns_; }

  /// An array (…, 2) that the evaluation fills.
  py::object add(const Attached<double>& point, int order) {
    if (point.body == 0) return repeated_point(shape(), order == 0 ? point.at : Vec2d{});
    NewArray made = new_points(shape());
    PointColumns& column = columns_.points.emplace_back();
    column.point = point;
    column.x[static_cast<std::size_t>(order)] = {made.data, size()};
    column.y[static_cast<std::size_t>(order)] = {made.data + size(), size()};
    return std::move(made.array);
  }

  void run() {
    const bool is_idle =
        columns_.points.empty() && columns_.bodies.empty() && columns_.dyads.empty();
    if (size() == 0 || is_idle) return;
    const std::size_t work = size() * (columns_.points.size() + columns_.bodies.size() + 1);
    std::optional<py::gil_scoped_release> unlocked;
    if (work >= kLong) unlocked.emplace();
    const auto& named = mechanism_.named();
    const DriveTable drives(named.mechanism, angles_.values());
    const auto status = evaluate_batch(named.mechanism, mechanism_.sides(), drives, columns_,
                                       {.threads = threads_});
    if (status != BatchStatus::done) throw std::runtime_error("a fault of Cognate's own: a batch");
  }

 private:
  const Moved& mechanism_;
  Numbers angles_;
  int threads_;
  ChainColumns columns_;
};

int order_of(const py::object& order) {
  return static_cast<int>(whole_of(order, "order", 0, 3));
}

}  // namespace

Moved::Moved(const py::dict& tables) : Moved(read_mechanism(tables)) {}

Moved::Moved(NamedMechanism mechanism)
    : named_(std::move(mechanism)), sides_(cognate::sides(named_.mechanism)) {
  for (const NamedPoint& point : named_.points) {
    PyObject* name = PyUnicode_InternFromString(point.name.c_str());
    if (name == nullptr) throw py::error_already_set();
    keys_.push_back(py::reinterpret_steal<py::object>(name));
  }
}

py::object tables_of(const NamedMechanism& mechanism) {
  return to_python(app::mechanism_json(mechanism));
}

py::object Moved::tables() const {
  return tables_of(named_);
}

const NamedPoint& Moved::find(const std::string& name, const char* key) const {
  const auto found = std::ranges::find(named_.points, name, &NamedPoint::name);
  if (found != named_.points.end()) return *found;
  std::string known;
  for (const NamedPoint& point : named_.points) {
    known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", point.name);
  }
  raise_fault(key, fmt::format("has \"{}\"; this mechanism has {}", name, known));
}

py::object Moved::points(const py::object& angles, const py::object& order_wanted,
                         const py::object& points, const py::object& threads) const {
  const int order = order_of(order_wanted);
  Evaluation evaluation(*this, angles, threads);
  py::dict all;
  if (points.is_none()) {
    evaluation.columns().points.reserve(named_.points.size());
    for (std::size_t i = 0; i < named_.points.size(); ++i) {
      const py::object array = evaluation.add(named_.points[i].at, order);
      if (PyDict_SetItem(all.ptr(), keys_[i].ptr(), array.ptr()) != 0) {
        throw py::error_already_set();
      }
    }
  } else {
    const bool is_list = !PyUnicode_Check(points.ptr()) && py::isinstance<py::iterable>(points);
    if (!is_list) refuse_type(points, "points", "a list of names, as [\"P\"]");
    for (const py::handle name : points) {
      const std::string text = text_of(name, "points");
      all[py::str(text)] = evaluation.add(find(text, "points").at, order);
    }
  }
  evaluation.run();
  return all;
}

py::object Moved::point(const py::object& name, const py::object& angles,
                        const py::object& threads) const {
  Evaluation evaluation(*this, angles, threads);
  py::object array = evaluation.add(find(text_of(name, "point"), "point").at, 0);
  evaluation.run();
  return array;
}

py::object Moved::bodies(const py::object& angles, const py::object& order_wanted,
                         const py::object& threads) const {
  const int order = order_of(order_wanted);
  Evaluation evaluation(*this, angles, threads);
  const std::size_t size = evaluation.size();
  py::dict all;
  std::vector<double*> directions;
  for (std::size_t body = 1; body < named_.bodies.size(); ++body) {
    BodyColumns& column = evaluation.columns().bodies.emplace_back();
    column.body = static_cast<int>(body);
    NewArray made = order > 0 ? new_array(evaluation.shape()) : new_points(evaluation.shape());
    if (order > 0) {
      column.turn[static_cast<std::size_t>(order - 1)] = {made.data, size};
    } else {
      column.cos = {made.data, size};
      column.sin = {made.data + size, size};
      directions.push_back(made.data);
    }
    all[py::str(named_.bodies[body])] = made.array;
  }
  evaluation.run();
  if (order > 0) return all;
  auto direction = directions.begin();
  for (std::size_t body = 1; body < named_.bodies.size(); ++body) {
    const NewArray made = new_array(evaluation.shape());
    const double* cos = *direction++;
    for (std::size_t i = 0; i < size; ++i) made.data[i] = std::atan2(cos[size + i], cos[i]);
    all[py::str(named_.bodies[body])] = made.array;
  }
  return all;
}

py::object Moved::transmission(const py::object& angles, const py::object& threads) const {
  Evaluation evaluation(*this, angles, threads);
  const std::size_t dyads = named_.mechanism.dyads.size(), size = evaluation.size();
  Shape shape = evaluation.shape();
  shape.append(static_cast<py::ssize_t>(dyads));
  // The dyads last, each in a run of its own: the sines stand where the angles will.
  std::vector<double> cosines(size * dyads), sines(size * dyads);
  for (std::size_t k = 0; k < dyads; ++k) {
    evaluation.columns().dyads.push_back({static_cast<int>(k),
                                          std::span(sines).subspan(k * size, size),
                                          std::span(cosines).subspan(k * size, size)});
  }
  evaluation.run();
  const NewArray made = new_array(shape);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < dyads; ++k) {
      made.data[i * dyads + k] = std::atan2(std::abs(sines[k * size + i]), cosines[k * size + i]);
    }
  }
  return made.array;
}

py::object Moved::gradient(const py::object& point, const py::object& angles) const {
  const NamedPoint& found = find(text_of(point, "point"), "point");
  const auto index = static_cast<std::size_t>(&found - named_.points.data());
  const Numbers at(angles, "angles");
  const auto dimensions = dimensions_of(named_);
  py::dict all;
  std::vector<double*> columns;
  for (const Dimension& dimension : dimensions) {
    NewArray made = new_points(at.shape());
    columns.push_back(made.data);
    all[py::str(dimension.name)] = made.array;
  }
  const py::gil_scoped_release unlocked;
  for (std::size_t k = 0; k < dimensions.size(); ++k) {
    const std::size_t size = at.size();
    point_gradient(named_, dimensions[k], index, at.values(), {columns[k], size},
                   {columns[k] + size, size});
  }
  return all;
}

py::tuple Moved::skeleton() const {
  const auto list = joints(named_.mechanism).joints;
  const auto names = problems::joint_names(named_);
  std::vector<std::vector<std::string>> links(named_.bodies.size());
  const auto add = [&](int body, const std::string& point) {
    auto& points = links[static_cast<std::size_t>(body)];
    if (std::ranges::find(points, point) == points.end()) points.push_back(point);
  };
  const auto is_point = [&](const std::string& name) {
    return std::ranges::find(named_.points, name, &NamedPoint::name) != named_.points.end();
  };
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].type != JointType::revolute || !is_point(names[i])) continue;
    add(list[i].first, names[i]);
    add(list[i].second, names[i]);
  }
  for (const NamedPoint& point : named_.points) add(point.at.body, point.name);
  // What slides is joined to the first point of what it slides on, but for the frame.
  std::vector<std::pair<std::string, std::string>> slides;
  for (const Joint& joint : list) {
    const auto& on = links[static_cast<std::size_t>(joint.first)];
    const auto& sliding = links[static_cast<std::size_t>(joint.second)];
    const bool moves = joint.type == JointType::prismatic && joint.first != 0 && joint.second != 0;
    if (moves && !on.empty() && !sliding.empty() && on[0] != sliding[0]) {
      slides.emplace_back(on[0], sliding[0]);
    }
  }
  return py::make_tuple(links, slides);
}

std::vector<std::string> Moved::point_names() const {
  std::vector<std::string> names;
  for (const NamedPoint& point : named_.points) names.push_back(point.name);
  return names;
}

std::vector<std::string> Moved::body_names() const {
  return named_.bodies;
}

namespace {

/// What is said of each type: its word, its meaning, and its keys with theirs.
py::list types() {
  py::list all;
  problems::for_each_mechanism_type([&]<class Type>(std::type_identity<Type>) {
    using Traits = problems::TypeTraits<Type>;
    py::list keys;
    if constexpr (problems::SimpleType<Type>) {
      for (const auto& key : Traits::kKeys) {
        const auto form = std::visit([](const auto& holds) { return holds.kForm; }, key.holds);
        const bool is_required = form == "length" || form == "pivots" ||
                                 std::holds_alternative<problems::NonzeroKey<Type>>(key.holds);
        keys.append(py::make_tuple(std::string(key.name), std::string(form),
                                   std::string(key.meaning), is_required));
      }
    }
    all.append(py::make_tuple(std::string(Traits::kWord), std::string(Traits::kMeaning), keys));
  });
  return all;
}

/// `method` for objects that are whole.
template <class Result, class... Arguments>
auto of_whole(Result (Moved::*method)(Arguments...) const) {
  return [method](const py::object& mechanism, Arguments... arguments) {
    const auto& moved = object_of<Moved>(mechanism, "mechanism", "a cognate.Mechanism");
    return (moved.*method)(std::forward<Arguments>(arguments)...);
  };
}

}  // namespace

void bind_mechanisms(py::module_& module) {
  module.def("mechanism_types", &types);
  py::class_<Moved>(module, "Mechanism")
      .def(py::init<const py::dict&>(), py::arg("tables"))
      .def("tables", of_whole(&Moved::tables))
      .def("_positions", of_whole(&Moved::points))
      .def("_point", of_whole(&Moved::point))
      .def("_bodies", of_whole(&Moved::bodies))
      .def("_transmission", of_whole(&Moved::transmission))
      .def("_gradient", of_whole(&Moved::gradient))
      .def("skeleton", of_whole(&Moved::skeleton))
      .def_property_readonly("point_names", of_whole(&Moved::point_names))
      .def_property_readonly("body_names", of_whole(&Moved::body_names));
}

}  // namespace cognate::python
