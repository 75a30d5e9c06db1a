#include "app/python/forces.hpp"

#include <fmt/core.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "app/python/arguments.hpp"
#include "app/python/arrays.hpp"
#include "app/python/document.hpp"
#include "app/python/mechanism.hpp"
#include "problems/evaluation/active_loads.hpp"
#include "problems/evaluation/force_units.hpp"
#include "problems/mechanism/joint_names.hpp"
#include "problems/task_document.hpp"

namespace cognate::python {
namespace {

using problems::AnalysisProblem;

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

/// The analysis of a mechanism with its tables `[[link]]`, `[[load]]`, `gravity`, `length_unit`.
AnalysisProblem read_problem(const py::dict& mechanism, const py::dict& tables, bool slides) {
  py::dict document, drive;
  document["kind"] = "analysis";
  document["mechanism"] = mechanism;
  if (slides) drive["end"] = 1.0;  // any: the positions are given
  document["drive"] = drive;
  for (const auto& [key, value] : tables) document[key] = value;
  const Source source = source_of(document);
  auto read = problems::reading::read_task(source.document, source.folder);
  if (!read) raise_faults(source, read.error());
  auto* problem = std::get_if<AnalysisProblem>(&read->task);
  if (problem == nullptr) raise_fault("kind", "is for whole problems; remove it");
  for (const problems::LoadRule& load : problem->loads) {
    if (load.within_stroke) {
      raise_fault("load",
                  "is within a part of the stroke, which needs the whole motion; "
                  "cognate.analyze knows it");
    }
  }
  return std::move(*problem);
}

/// Where the forces of one position go, each as long as there are angles.
struct Columns {
  explicit Columns(const Shape& shape, const std::vector<std::string>& joints)
      : drive(new_array(shape)), shaking(new_points(shape)), moment(new_array(shape)) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
      reactions.push_back(new_points(shape));
      moments.push_back(new_array(shape));
    }
  }

  void set(std::size_t row, std::size_t rows, const Forces& forces, double metres) {
    drive.data[row] = metres * forces.drive;
    put(shaking, row, rows, forces.shaking_force);
    moment.data[row] = metres * forces.shaking_moment;
    for (std::size_t i = 0; i < reactions.size(); ++i) {
      put(reactions[i], row, rows, forces.reactions[i].force);
      moments[i].data[row] = metres * forces.reactions[i].moment;
    }
  }

  static void put(const NewArray& to, std::size_t row, std::size_t rows, const Vec2d& value) {
    to.data[row] = value.x;
    to.data[rows + row] = value.y;
  }

  NewArray drive, shaking, moment;
  std::vector<NewArray> reactions, moments;
};

/// Forces that are no numbers, where there are none.
Forces nowhere(Forces forces) {
  for (Reaction& reaction : forces.reactions) reaction = {{kNowhere, kNowhere}, kNowhere};
  forces.drive = forces.shaking_moment = kNowhere;
  forces.shaking_force = {kNowhere, kNowhere};
  return forces;
}

/// A rate of the drive, one for all positions or one for each.
class Rate {
 public:
  Rate(const py::object& value, const char* name, const Shape& shape) : numbers_(value, name) {
    bool fits = numbers_.shape().axes() == 0 || numbers_.shape().axes() == shape.axes();
    for (int i = 0; fits && i < numbers_.shape().axes(); ++i) {
      fits = numbers_.shape()[i] == shape[i];
    }
    if (!fits)
      raise_fault(name, "has another shape than angles; expected a number, or one for each");
    numbers_.expect_finite(name);
  }

  double operator[](std::size_t row) const {
    return numbers_.values()[numbers_.shape().axes() == 0 ? 0 : row];
  }

 private:
  Numbers numbers_;
};

void fill(const AnalysisProblem& problem, std::span<const double> angles, const Rate& speed,
          const Rate& acceleration, double metres, Columns& columns) {
  const auto& mechanism = problem.mechanism.mechanism;
  InverseDynamics dynamics(mechanism, problem.inertias, problem.gravity);
  problems::ActiveLoads loads(mechanism, problem.loads);
  MechanismMotion<2> motion(mechanism);
  Forces forces = dynamics.forces();
  const Forces none = nowhere(dynamics.forces());
  for (std::size_t row = 0; row < angles.size(); ++row) {
    const DriveRate rate{speed[row], acceleration[row]};
    const bool is_there = motion.move_to(angles[row]);
    const bool is_solved =
        is_there &&
        dynamics.solve<2>(motion.bodies(), rate,
                          loads.at<2>(angles[row], rate.speed, motion.bodies()), forces);
    columns.set(row, angles.size(), is_solved ? forces : none, metres);
  }
}

py::dict forces(const py::object& given_mechanism, const py::object& angles,
                const py::object& speed, const py::object& acceleration, const py::dict& tables) {
  const auto& mechanism = object_of<Moved>(given_mechanism, "mechanism", "a cognate.Mechanism");
  const bool slides = driven_by_length(mechanism.named().mechanism.drive);
  const AnalysisProblem given = read_problem(mechanism.tables(), tables, slides);
  const Numbers at(angles, "angles");
  const Rate speeds(speed, "speed", at.shape());
  const Rate accelerations(acceleration, "acceleration", at.shape());
  const double metres = problems::metres(given.length_unit);
  const AnalysisProblem problem = problems::in_newtons(given, metres);
  const auto names = problems::joint_names(problem.mechanism);
  const auto list = joints(problem.mechanism.mechanism).joints;
  Columns columns(at.shape(), names);
  {
    const py::gil_scoped_release unlocked;
    // Torques come in N times the unit of lengths; a slider's force does not.
    fill(problem, at.values(), speeds, accelerations, metres, columns);
    for (std::size_t row = 0; slides && row < at.size(); ++row) columns.drive.data[row] /= metres;
  }
  py::dict all;
  all["drive"] = columns.drive.array;
  for (std::size_t i = 0; i < names.size(); ++i) {
    all[py::str(names[i])] = columns.reactions[i].array;
    if (list[i].type == JointType::prismatic) {
      all[py::str(names[i] + " moment")] = columns.moments[i].array;
    }
  }
  all["shaking_force"] = columns.shaking.array;
  all["shaking_moment"] = columns.moment.array;
  return all;
}

}  // namespace

void bind_forces(py::module_& module) {
  module.def("forces", &forces);
}

}  // namespace cognate::python
