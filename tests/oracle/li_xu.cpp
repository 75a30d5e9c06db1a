#include "tests/oracle/li_xu.hpp"

#include <toml++/toml.h>

#include <cmath>
#include <string_view>

#include "analysis/numbers/constants.hpp"
#include "tests/support/folders.hpp"

namespace cognate {
namespace {

constexpr double pi = kPi;
constexpr double degree = pi / 180;

std::map<std::string, double> numbers(const toml::table& table) {
  std::map<std::string, double> all;
  for (const auto& [key, value] : table) all[std::string(key.str())] = *value.value<double>();
  return all;
}

std::vector<double> column(const toml::node& node) {
  std::vector<double> values;
  for (const auto& value : *node.as_array()) values.push_back(*value.value<double>());
  return values;
}

// Outputs. Reactions are those of the first body of a joint on the second.

Output angle(int body) {
  return [body](const Instant& now) {
    const Vec2d e = now.motion.bodies()[std::size_t(body)].direction;
    return std::atan2(e.y, e.x);
  };
}

Output omega(int body) {
  return [body](const Instant& now) {
    return now.rate.speed * now.motion.bodies()[std::size_t(body)].turn[0];
  };
}

Output alpha(int body) {
  return [body](const Instant& now) {
    const auto& turn = now.motion.bodies()[std::size_t(body)].turn;
    return now.rate.speed * now.rate.speed * turn[1] + now.rate.acceleration * turn[0];
  };
}

Output force_on_first(int joint, double Vec2d::*component) {
  return [=](const Instant& now) {
    return -(now.forces.reactions[std::size_t(joint)].force.*component);
  };
}

Output force_on_second(int joint, double Vec2d::*component) {
  return
      [=](const Instant& now) { return now.forces.reactions[std::size_t(joint)].force.*component; };
}

double driving_torque(const Instant& now) {
  return now.forces.drive;
}

/// Of the links that are bodies `coupler` and so on: theta2, omega2, alpha2.
void add_turning(Model& model, const std::string& link, int body) {
  model.outputs["theta" + link] = angle(body);
  model.outputs["omega" + link] = omega(body);
  model.outputs["alpha" + link] = alpha(body);
}

/// aS2x, aS2y of the body's centre of mass.
void add_centre(Model& model, const std::string& link, int body) {
  const Attached<double> centre{body, model.inertias[std::size_t(body)].centre};
  model.outputs["aS" + link + "x"] = [=](const Instant& now) { return now.acceleration(centre).x; };
  model.outputs["aS" + link + "y"] = [=](const Instant& now) { return now.acceleration(centre).y; };
}

/// F12x, F12y for "F12": the force of the joint's first body on the second.
void add_force(Model& model, const std::string& name, int joint) {
  model.outputs[name + "x"] = force_on_second(joint, &Vec2d::x);
  model.outputs[name + "y"] = force_on_second(joint, &Vec2d::y);
}

/// The same of the joint's second body on the first, which is the frame.
void add_force_on_frame(Model& model, const std::string& name, int joint) {
  model.outputs[name + "x"] = force_on_first(joint, &Vec2d::x);
  model.outputs[name + "y"] = force_on_first(joint, &Vec2d::y);
}

/// s3, v23, a23: the distance of the crank pin (body 2) from the guide pivot (body 3) and its
/// derivatives, from r·r = s².
void add_distance(Model& model) {
  struct Distance {
    double length, rate, second;
  };
  const auto distance = [](const Instant& now) {
    const Attached<double> pin{2, {}}, pivot{3, {}};
    const Vec2d r = now.position(pin) - now.position(pivot);
    const Vec2d v = now.velocity(pin) - now.velocity(pivot);
    const Vec2d a = now.acceleration(pin) - now.acceleration(pivot);
    const double s = std::sqrt(dot(r, r)), rate = dot(r, v) / s;
    return Distance{s, rate, (dot(v, v) + dot(r, a) - rate * rate) / s};
  };
  model.outputs["s3"] = [=](const Instant& now) { return distance(now).length; };
  model.outputs["v23"] = [=](const Instant& now) { return distance(now).rate; };
  model.outputs["a23"] = [=](const Instant& now) { return distance(now).second; };
}

/// Position, velocity and acceleration along x of the slider that is body `body`.
void add_sliding(Model& model, int body, const std::array<std::string, 3>& names) {
  const Attached<double> slider{body, {}};
  model.outputs[names[0]] = [=](const Instant& now) { return now.position(slider).x; };
  model.outputs[names[1]] = [=](const Instant& now) { return now.velocity(slider).x; };
  model.outputs[names[2]] = [=](const Instant& now) { return now.acceleration(slider).x; };
}

double value_or_zero(const Example& example, const std::string& name) {
  const auto found = example.given.find(name);
  return found == example.given.end() ? 0 : found->second;
}

Model four_bar(const Example& example) {
  const auto given = [&](const std::string& name) { return value_or_zero(example, name); };
  const double l1 = given("l1"), l2 = given("l2"), l3 = given("l3");
  Model model;
  model.mechanism.drive = Crank<double>{{0, 0}, l1};
  model.mechanism.dyads = {Rrr<double>{{1, {l1, 0}}, {0, {given("l4"), 0}}, l2, l3}};
  model.inertias = {{},
                    {given("m1"), {l1 / 2, 0}, 0},
                    {given("m2"), {l2 / 2, 0}, given("J2")},
                    {given("m3"), {l3 / 2, 0}, given("J3")}};
  model.rules = {{.at = {3, {}}, .torque = -given("Mr")}};
  for (const int body : {2, 3}) {
    add_turning(model, std::to_string(body), body);
    add_centre(model, std::to_string(body), body);
  }
  add_force_on_frame(model, "F14", 0);
  add_force(model, "F12", 1);
  add_force(model, "F23", 2);
  add_force_on_frame(model, "F34", 3);
  return model;
}

Model slider_crank(const Example& example) {
  const auto given = [&](const std::string& name) { return value_or_zero(example, name); };
  const double l1 = given("l1"), l2 = given("l2");
  Model model;
  model.mechanism.drive = Crank<double>{{0, 0}, l1};
  model.mechanism.dyads = {Rrp<double>{{1, {l1, 0}}, l2, {0, {0, 0}, {1, 0}, given("e")}}};
  model.inertias = {{},
                    {given("m1"), {given("lAS1"), 0}, 0},
                    {given("m2"), {given("lBS2"), 0}, given("J2")},
                    {given("m3"), {0, 0}, 0}};
  model.rules = {{.at = {3, {}}, .force = {given("Fr"), 0}}};
  add_turning(model, "2", 2);
  add_centre(model, "2", 2);
  add_sliding(model, 3, {"s3", "v3", "a3"});
  add_force_on_frame(model, "F14", 0);
  add_force(model, "F12", 1);
  add_force(model, "F23", 2);
  model.outputs["F34y"] = force_on_first(3, &Vec2d::y);
  return model;
}

Model guide_bar(const Example& example) {
  const auto given = [&](const std::string& name) { return value_or_zero(example, name); };
  const double crank = given("l1") + given("lAB"), frame = given("l4") + given("lAC");
  Model model;
  model.mechanism.drive = Crank<double>{{0, frame}, crank};
  model.mechanism.dyads = {Rpr<double>{{1, {crank, 0}}, {0, {0, 0}}, 0}};
  model.inertias = {
      {}, {given("m1"), {0, 0}, 0}, {}, {given("m3"), {given("lCD") / 2, 0}, given("J3")}};
  model.rules = {{.at = {3, {}}, .torque = -given("Mr")}};
  if (example.title.find("working") != std::string::npos) {
    model.rules[0].sense = problems::LoadSense::advance;
  }
  add_turning(model, "3", 3);
  add_centre(model, "3", 3);
  add_distance(model);
  add_force_on_frame(model, "F14", 0);
  add_force(model, "F12", 1);
  add_force(model, "F23", 2);
  add_force_on_frame(model, "F34", 3);
  model.outputs["Mr"] = [](const Instant& now) {
    return now.loads.empty() ? 0 : -now.loads[0].torque;
  };
  return model;
}

Model shaper(const Example& example) {
  const auto given = [&](const std::string& name) { return value_or_zero(example, name); };
  const double l1 = given("l1"), l3 = given("l3"), l4 = given("l4");
  Model model;
  model.mechanism.drive = Crank<double>{{0, given("l6")}, l1};
  model.mechanism.dyads = {
      Rpr<double>{{1, {l1, 0}}, {0, {0, 0}}, 0},
      Rrp<double>{{3, {l3, 0}}, l4, {0, {0, given("l6p")}, {1, 0}, 0}, Assembly::crossed}};
  const Vec2d ram_centre{given("xS5"), 0};
  model.inertias = {{},
                    {},
                    {},
                    {given("m3"), {l3 / 2, 0}, given("J3")},
                    {given("m4"), {l4 / 2, 0}, given("J4")},
                    {given("m5"), ram_centre, 0}};
  model.rules = {{.at = {5, {}},
                  .force = {given("Fr"), 0},
                  .sense = problems::LoadSense::retreat,
                  .within_stroke = {{given("margin"), 1 - given("margin")}}}};
  const Extremes ram = extremes(model.mechanism, 5);
  model.strokes = {{ram.least, ram.greatest}};
  for (const int body : {3, 4}) {
    add_turning(model, std::to_string(body), body);
    add_centre(model, std::to_string(body), body);
  }
  add_distance(model);
  add_sliding(model, 5, {"sE", "vE", "aE"});
  add_force_on_frame(model, "F16", 0);
  add_force(model, "F12", 1);
  add_force(model, "F23", 2);
  add_force_on_frame(model, "F36", 3);
  add_force(model, "F34", 4);
  add_force(model, "F45", 5);
  model.outputs["F56"] = force_on_first(6, &Vec2d::y);
  // Moved from the pin to the ram's centre of mass.
  model.outputs["M5"] = [=](const Instant& now) {
    const Reaction& guide = now.forces.reactions[6];
    return -(guide.moment + cross(-ram_centre, guide.force));
  };
  model.outputs["Fr"] = [](const Instant& now) {
    return now.loads.empty() ? 0 : now.loads[0].force.x;
  };
  return model;
}

}  // namespace

std::vector<Example> read_examples() {
  const toml::table file = toml::parse_file(std::string(kOracleFolder) + "/li_xu.toml");
  std::vector<Example> examples;
  for (const auto& node : *file["example"].as_array()) {
    const toml::table& entry = *node.as_table();
    Example example;
    example.number = entry.at("number").value<std::string>().value();
    example.title = entry.at("title").value<std::string>().value();
    example.given = numbers(*entry.at("given").as_table());
    for (const auto& [key, value] : *entry.at("at").as_table()) {
      example.at[std::string(key.str())] = column(value);
    }
    for (const double theta : example.at.at("theta1_deg")) example.crank.push_back(theta * degree);
    example.at.erase("theta1_deg");
    if (const auto* cycle = entry["over_the_cycle"].as_table()) {
      example.over_the_cycle = numbers(*cycle);
    }
    examples.push_back(std::move(example));
  }
  return examples;
}

std::vector<TypeExample> read_types() {
  const toml::table file = toml::parse_file(std::string(kOracleFolder) + "/li_xu.toml");
  std::vector<TypeExample> types;
  for (const auto& node : *file["type"].as_array()) {
    const toml::table& entry = *node.as_table();
    const auto length = [&](std::string_view key) { return entry.at(key).value<double>().value(); };
    types.push_back({{length("crank"), length("coupler"), length("rocker"), length("frame")},
                     entry.at("class").value<std::string>().value()});
  }
  return types;
}

Vec2d Instant::position(const Attached<double>& point) const {
  return motion.point(point)[0];
}

Vec2d Instant::velocity(const Attached<double>& point) const {
  return rate.speed * motion.point(point)[1];
}

Vec2d Instant::acceleration(const Attached<double>& point) const {
  const auto derivatives = motion.point(point);
  return rate.speed * rate.speed * derivatives[2] + rate.acceleration * derivatives[1];
}

Model model_of(const Example& example) {
  const std::string_view kind = std::string_view(example.number).substr(2);
  Model model = kind == "1"   ? four_bar(example)
                : kind == "2" ? slider_crank(example)
                : kind == "3" ? guide_bar(example)
                              : shaper(example);
  model.rate = {value_or_zero(example, "omega1"), value_or_zero(example, "alpha1")};
  model.gravity = {0, -value_or_zero(example, "g")};
  model.outputs["Mb"] = driving_torque;
  return model;
}

Instant instant(const Model& model, double crank) {
  Instant now{MechanismMotion<2>(model.mechanism), model.rate, {}, {}};
  now.motion.move_to(crank);
  const auto bodies = now.motion.bodies();
  problems::ActiveLoads active(model.mechanism, model.rules, model.strokes);
  const std::span<const Load> loads = active.at<2>(crank, model.rate.speed, bodies);
  now.loads.assign(loads.begin(), loads.end());
  InverseDynamics dynamics(model.mechanism, model.inertias, model.gravity);
  now.forces = dynamics.forces();
  dynamics.solve<2>(bodies, model.rate, now.loads, now.forces);
  return now;
}

Extremes extremes(const Mechanism<double>& mechanism, int body) {
  const Travel travel = travels(mechanism)[std::size_t(body)];
  MechanismMotion<1> motion(mechanism);
  const auto rate = [&](double crank) {
    motion.move_to(crank);
    return travel_rate<1>(travel, motion.bodies());
  };
  Extremes found;
  constexpr int steps = 90;
  for (int i = 0; i < steps; ++i) {
    double low = 2 * pi * i / steps, high = 2 * pi * (i + 1) / steps;
    const bool rises = rate(low) > 0;
    if (rises == (rate(high) > 0)) continue;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      ((rate(middle) > 0) == rises ? low : high) = middle;
    }
    motion.move_to(low);
    (rises ? found.crank_at_greatest : found.crank_at_least) = low;
    (rises ? found.greatest : found.least) = travelled<1>(travel, motion.bodies());
  }
  return found;
}

}  // namespace cognate
