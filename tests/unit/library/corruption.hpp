/// @file Valid problems made wrong, one member at a time.
#pragma once

#include <functional>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "problems/kinds.hpp"
#include "problems/toml/number_rules.hpp"

namespace cognate::problems {

/// Spoils the member number `at` of those that it is shown; counts them.
class Corruption {
 public:
  Corruption(std::size_t at, std::mt19937_64& random) : at_(at), random_(random) {}

  /// How many members were shown.
  std::size_t count() const { return next_; }

  template <class... Members>
  void operator()(Members&... members) {
    (show(members), ...);
  }

 private:
  template <class T>
  void show(T& member) {
    if (next_++ == at_) spoil(member);
  }

  template <class List>
  auto one_of(const List& list) {
    return *(list.begin() + static_cast<std::ptrdiff_t>(random_() % list.size()));
  }

  void spoil(double& number) {
    const double values[] = {NAN,    INFINITY, -INFINITY, -1,         0,
                             1e-300, 1e300,    -number,   7 * number, 1.5};
    number = values[random_() % std::size(values)];
  }
  void spoil(int& number) {
    const int values[] = {-1, 0, 1, 2, 7, 1 << 30, -(1 << 30)};
    number = values[random_() % std::size(values)];
  }
  void spoil(bool& value) { value = !value; }
  void spoil(std::string& text) { text = random_() % 2 == 0 ? "" : "sin(x)/x + phi"; }
  void spoil(Vec2d& point) { spoil(random_() % 2 == 0 ? point.x : point.y); }
  void spoil(Range& range) { spoil(random_() % 2 == 0 ? range.min : range.max); }
  void spoil(Box& box) { spoil(random_() % 2 == 0 ? box.min : box.max); }
  void spoil(synthesis::Pose& pose) {
    if (random_() % 2 == 0) {
      spoil(pose.at);
    } else {
      spoil(pose.angle);
    }
  }
  void spoil(synthesis::RockerLimitAngle& given) { spoil(given.angle); }
  void spoil(synthesis::PivotLine& line) { spoil(random_() % 2 == 0 ? line.a : line.c); }
  void spoil(FreeMotionParameter& free) {
    if (random_() % 2 == 0) {
      free.segment += 100;
    } else {
      spoil(free.range);
    }
  }
  void spoil(cam::MotionCondition& condition) {
    if (random_() % 2 == 0) {
      spoil(condition.order);
    } else {
      spoil(condition.value);
    }
  }
  void spoil(cam::SplinePoint& point) { spoil(random_() % 2 == 0 ? point.at : point.displacement); }
  void spoil(cam::MotionSegment& segment) {
    const std::function<void()> ways[] = {
        [&] { spoil(segment.over); },          [&] { spoil(segment.rise); },
        [&] { spoil(segment.law); },           [&] { spoil(segment.conditions); },
        [&] { spoil(segment.points); },        [&] { spoil(segment.degree); },
        [&] { spoil(segment.ends.periodic); }, [&] { spoil(segment.shape.sine); }};
    ways[random_() % std::size(ways)]();
  }
  void spoil(CamLength& length) {
    const std::function<void()> ways[] = {[&] { spoil(length.used); }, [&] { spoil(length.given); },
                                          [&] { spoil(length.bounds); }};
    ways[random_() % std::size(ways)]();
  }
  void spoil(LoadRule& load) {
    const std::function<void()> ways[] = {
        [&] { spoil(load.at.body); },      [&] { spoil(load.at.at); }, [&] { spoil(load.force); },
        [&] { spoil(load.between); },      [&] { spoil(load.sense); }, [&] { spoil(load.torque); },
        [&] { spoil(load.within_stroke); }};
    ways[random_() % std::size(ways)]();
  }
  void spoil(Inertia& inertia) {
    if (random_() % 2 == 0) {
      spoil(inertia.mass);
    } else {
      spoil(inertia.centre);
    }
  }
  void spoil(Clearance& clearance) { spoil(clearance.box); }
  void spoil(ErrorLimit& limit) { spoil(limit.max); }
  void spoil(MachineFunction& function) {
    const std::function<void()> ways[] = {[&] { function.value = nullptr; },
                                          [&] { spoil(function.text); },
                                          [&] { spoil(function.table); }};
    ways[random_() % std::size(ways)]();
  }
  void spoil(MachineLoad& load) {
    if (random_() % 2 == 0) {
      spoil(load.rule);
    } else {
      spoil(load.value);
    }
  }
  void spoil(Motor& motor) {
    if (random_() % 2 == 0) {
      spoil(motor.torque);
    } else {
      spoil(motor.ratio);
    }
  }
  void spoil(AnalysisProblem& problem);
  void spoil(TopologyLine& line) {
    const std::function<void()> ways[] = {
        [&] { spoil(line.name); },       [&] { spoil(line.line.type); },
        [&] { spoil(line.line.first); }, [&] { spoil(line.line.second); },
        [&] { spoil(line.given); },      [&] { spoil(line.bounds); },
        [&] { spoil(line.assembly); }};
    ways[random_() % std::size(ways)]();
  }
  void spoil(Topology& topology) {
    const std::function<void()> ways[] = {[&] { spoil(topology.name); },
                                          [&] { spoil(topology.lines); },
                                          [&] { spoil(topology.trace); }};
    ways[random_() % std::size(ways)]();
  }
  void spoil(Dwell& dwell) {
    const std::function<void()> ways[] = {[&] { spoil(dwell.over); }, [&] { spoil(dwell.from); },
                                          [&] { spoil(dwell.half_band_max); }};
    ways[random_() % std::size(ways)]();
  }
  void spoil(NamedMechanism& mechanism) {
    const std::function<void()> ways[] = {[&] { mechanism.bodies.clear(); },
                                          [&] { mechanism.points.clear(); },
                                          [&] { mechanism.description = FourBar{}; },
                                          [&] { mechanism.mechanism.dyads.clear(); },
                                          [&] {
                                            for (NamedPoint& point : mechanism.points)
                                              spoil(point.at.body);
                                          },
                                          [&] { spoil(mechanism.output); }};
    ways[random_() % std::size(ways)]();
  }

  void spoil(TrainMesh& mesh) {
    const std::function<void()> ways[] = {
        [&] { spoil(mesh.gears); }, [&] { spoil(mesh.teeth); }, [&] { spoil(mesh.type); },
        [&] { spoil(mesh.efficiency); }, [&] { spoil(mesh.module); }};
    ways[random_() % std::size(ways)]();
  }
  void spoil(TrainPlanet& planet) {
    const std::function<void()> ways[] = {
        [&] { spoil(planet.name); }, [&] { spoil(planet.carrier); }, [&] { spoil(planet.count); },
        [&] { spoil(planet.inertia); }, [&] { spoil(planet.mass); }};
    ways[random_() % std::size(ways)]();
  }
  void spoil(TrainShaft& shaft) {
    if (random_() % 2 == 0) {
      spoil(shaft.name);
    } else {
      spoil(shaft.inertia);
    }
  }
  void spoil(TrainInput& input) {
    const std::function<void()> ways[] = {[&] { spoil(input.member); }, [&] { spoil(input.speed); },
                                          [&] { spoil(input.torque); }};
    ways[random_() % std::size(ways)]();
  }
  void spoil(TrainOutput& output) {
    if (random_() % 2 == 0) {
      spoil(output.member);
    } else {
      spoil(output.torque);
    }
  }
  void spoil(TrainBrake& brake) { spoil(random_() % 2 == 0 ? brake.name : brake.holds); }
  void spoil(TrainClutch& clutch) {
    if (random_() % 2 == 0) {
      spoil(clutch.name);
    } else {
      spoil(clutch.joins);
    }
  }
  void spoil(TrainState& state) {
    if (random_() % 2 == 0) {
      spoil(state.name);
    } else {
      spoil(state.engaged);
    }
  }
  void spoil(TrainTarget& target) {
    const std::function<void()> ways[] = {
        [&] { spoil(target.train); },     [&] { spoil(target.ratio); },
        [&] { spoil(target.objective); }, [&] { spoil(target.ratio_tolerance); },
        [&] { spoil(target.teeth); },     [&] { spoil(target.ring_teeth); },
        [&] { spoil(target.pairs); },     [&] { spoil(target.coaxial); },
        [&] { spoil(target.planets); },   [&] { spoil(target.input); },
        [&] { spoil(target.output); },    [&] { spoil(target.designs); }};
    ways[random_() % std::size(ways)]();
  }

  template <class A, class B>
  void spoil(std::pair<A, B>& two) {
    if (random_() % 2 == 0) {
      spoil(two.first);
    } else {
      spoil(two.second);
    }
  }
  template <class T, std::size_t n>
  void spoil(std::array<T, n>& list) {
    spoil(list[random_() % n]);
  }
  template <class T>
  void spoil(std::vector<T>& list) {
    const auto way = random_() % 4;
    if (way == 0) list.clear();
    if (way == 1) list.emplace_back();
    if (way == 2 && !list.empty()) list.pop_back();
    if (way == 3 && !list.empty()) {
      T entry = list[random_() % list.size()];
      if constexpr (!std::is_same_v<T, bool>) spoil(entry);
      list[random_() % list.size()] = entry;
    }
  }
  template <class T>
  void spoil(std::optional<T>& value) {
    if (!value) {
      value.emplace();
      spoil(*value);
    } else if (random_() % 2 == 0) {
      value.reset();
    } else {
      spoil(*value);
    }
  }
  template <class Enum>
  std::enable_if_t<std::is_enum_v<Enum>> spoil(Enum& value) {
    value = static_cast<Enum>(random_() % 16);
  }

  std::size_t at_;
  std::size_t next_ = 0;
  std::mt19937_64& random_;
};

inline void show(Corruption& to, Given& g) {
  to(g.crank, g.coupler, g.rocker, g.frame, g.frame_angle, g.pivot_a, g.pivot_d, g.coupler_point,
     g.assembly);
}

inline void show(Corruption& to, Bounds& b) {
  to(b.crank, b.coupler, b.rocker, b.frame, b.frame_angle, b.pivot_a, b.pivot_d, b.coupler_point);
}

inline void show(Corruption& to, Constraints& c) {
  to(c.required_class, c.transmission_angle, c.link_ratio_max, c.time_ratio, c.pivot_region,
     c.clearances, c.cycle_max.values, c.operation.speed, c.operation.flywheel,

     c.operation.fluctuation, c.operation.gravity, c.error, c.no_branch_defect, c.no_order_defect);
}

inline void show(Corruption& to, Solve& s) {
  to(s.solver, s.starts, s.designs, s.objectives, s.loss, s.loss_scale, s.tolerance, s.certify,
     s.certify_gap);
}

inline void show(Corruption& to, PathProblem& p) {
  to(p.method, p.points, p.pose_angles, p.timing, p.crank_angles, p.has_crank_angle,
     p.crank_reference, p.crank_sense, p.order, p.weights);
  if (p.curve) to(p.curve->place, p.curve->svg_path);
  show(to, p.given);
  show(to, p.bounds);
  show(to, p.constraints);
  show(to, p.solve);
}

inline void show(Corruption& to, ChainPathProblem& p) {
  to(p.mechanism, p.topologies, p.points, p.closed, p.crank_angles,
     p.constraints.transmission_angle, p.constraints.over, p.constraints.rms_error_max);
  show(to, p.solve);
}

inline void show(Corruption& to, std::variant<FunctionOfX, AnglePairs>& target) {
  if (auto* f = std::get_if<FunctionOfX>(&target)) {
    to(f->text, f->table, f->domain, f->input_range, f->output_range);
  } else {
    to(std::get<AnglePairs>(target));
  }
}

inline void show(Corruption& to, ChainFunctionProblem& p) {
  to(p.mechanism, p.topologies, p.output, p.objective, p.sample_at,
     p.constraints.transmission_angle, p.constraints.over);
  show(to, p.target);
  show(to, p.solve);
}

inline void show(Corruption& to, ChainMotionProblem& p) {
  to(p.mechanism, p.topologies, p.poses, p.closed, p.crank_angles, p.angle_weight,
     p.constraints.transmission_angle, p.constraints.over, p.constraints.rms_error_max);
  show(to, p.solve);
}

inline void show(Corruption& to, DwellProblem& p) {
  to(p.mechanism, p.topologies, p.output, p.dwells, p.apart, p.swing_min,
     p.constraints.transmission_angle);
  show(to, p.solve);
}

inline void show(Corruption& to, LegProblem& p) {
  to(p.mechanism, p.topologies, p.near, p.target.duty, p.target.stride, p.target.height_min,
     p.target.height_max, p.target.flatness_max, p.target.objective, p.constraints.foot_speed_min,
     p.constraints.foot_speed_max, p.constraints.transmission_angle);
  show(to, p.solve);
}

inline void show(Corruption& to, FunctionProblem& p) {
  to(p.type, p.objective, p.precision_points, p.at, p.spacing, p.multiplicity, p.derivatives,
     p.sample_at, p.start, p.input_start, p.output_start, p.input_start_bounds,
     p.output_start_bounds, p.offset, p.offset_bounds, p.best_by);
  show(to, p.target);
  show(to, p.given);
  show(to, p.bounds);
  show(to, p.constraints);
  show(to, p.solve);
}

inline void show(Corruption& to, MotionProblem& p) {
  to(p.method, p.poses, p.segments, p.angle_weight, p.fixed_pivots, p.moving_pivots,
     p.first_is_driven, p.fixed_pivot_line, p.crank, p.rocker, p.dyads, p.moving_bounds);
  show(to, p.bounds);
  show(to, p.constraints);
  show(to, p.solve);
}

inline void show(Corruption& to, QuickReturnProblem& p) {
  to(p.time_ratio, p.type, p.swing, p.crank_pivot_line, p.limit_angle, p.stroke, p.offset, p.rod,
     p.ram_height, p.pressure_angle_max);
  show(to, p.given);
  show(to, p.bounds);
  show(to, p.constraints);
  show(to, p.solve);
}

inline void show(Corruption& to, StraightLineProblem& p) {
  if (p.goal) to(p.goal->length, p.goal->deviation, p.goal->deviation_relative, p.goal->direction);
  if (p.goal && p.goal->ends) to(p.goal->ends->front(), p.goal->ends->back());
  to(p.type, p.slider_offset, p.segment.crank_range, p.segment.size_over_length_max,
     p.segment.speed_variation_max, p.contact, p.cranks, p.crank_angle, p.coupler_angle, p.sides);
  if (p.slider) to(p.slider->offset, p.slider->direction);
  show(to, p.given);
  show(to, p.bounds);
  show(to, p.constraints);
  show(to, p.solve);
}

inline void show(Corruption& to, AnalysisProblem& p) {
  to(p.mechanism, p.drive.start, p.drive.end, p.drive.steps, p.drive.rate.speed, p.output.position,
     p.output.reactions, p.output.points, p.output.instant_geometry, p.output.curve,
     p.output.cognates, p.output.foot, p.output.duty, p.inertias, p.loads, p.gravity);
}

inline void Corruption::spoil(AnalysisProblem& problem) {
  Corruption inside(random_() % 16, random_);
  problems::show(inside, problem);
}

inline void show(Corruption& to, CamProblem& p) {
  to(p.follower, p.side, p.second.closure, p.second.breadth, p.second.arms_angle, p.motion,
     p.free_motion, p.operation.speed, p.operation.inertia, p.operation.spring_rate,
     p.operation.load, p.operation.width, p.has_operation, p.has_contact, p.preload, p.objective);
  for (CamLength& length : p.lengths) to(length);
  CamConstraints& c = p.constraints;
  to(c.pressure_angle_max, c.pressure_angle_max_rise, c.curvature_radius_min, c.concave_radius_min,
     c.face_width_max, c.profile_radius_min, c.profile_radius_max, c.contact_force_max,
     c.torque_max, c.contact_stress_max);
  show(to, p.solve);
}

inline void show(Corruption& to, GearProblem& p) {
  gear::SpurGear& g = p.gear.normal;
  to(p.gearing, g.teeth, g.module, g.profile_shift, g.rack.pressure_angle, g.rack.addendum,
     g.rack.clearance, g.rack.corner_radius, g.tip_reduction, g.coarsening, p.gear.helix,
     p.gear.face_width, p.points);
}

inline void show(Corruption& to, GearPairProblem& p) {
  to(p.gearing, p.rack.pressure_angle, p.rack.addendum, p.teeth, p.teeth_bounds, p.module,
     p.modules, p.profile_shift, p.profile_shift_bounds, p.tip_reduction, p.centre_distance,
     p.centre_distance_bounds, p.backlash, p.ratio, p.ratio_tolerance, p.helix, p.face_width,
     p.shaft_angle, p.worm.starts, p.worm.wheel_teeth, p.worm.module, p.worm.diameter_quotient,
     p.worm.wheel_shift, p.friction, p.objective, p.constraints.contact_ratio_min,
     p.constraints.tip_thickness_min, p.constraints.sliding_max, p.solve.designs);
}

inline void show(Corruption& to, GearTrainProblem& p) {
  to(p.meshes, p.planets, p.shafts, p.fixed, p.brakes, p.clutches, p.inputs, p.output, p.states,
     p.target);
}

inline void show(Corruption& to, MachineProblem& p) {
  MachineRunRequest& r = p.run;
  to(p.mechanism, p.loads, p.inertia, p.torque, p.motor, p.flywheel, p.fluctuation, p.brake,
     r.tasks, r.start_phi, r.start_speed, r.time_max, r.turns_max, r.speed_end, r.steps,
     r.tolerance);
}

}  // namespace cognate::problems
